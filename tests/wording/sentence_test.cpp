#include <gtest/gtest.h>

#include "wording/words.h"

namespace tribolog::test::sentence_test {
namespace {

using wording::as_sentence;

TEST(Sentences, CapitalAndFullStop) {
  EXPECT_EQ(as_sentence("a fast sine"), "A fast sine.");
  EXPECT_EQ(as_sentence("no data"), "No data.");
  EXPECT_EQ(as_sentence("Done."), "Done.");
  EXPECT_EQ(as_sentence("what it is:"), "What it is:");
  EXPECT_EQ(as_sentence(""), "");
}

TEST(Sentences, SymbolsStaySmall) {
  EXPECT_EQ(as_sentence("q_peak is unknown"), "q_peak is unknown.");
  EXPECT_EQ(as_sentence("n is 100"), "n is 100.");
  EXPECT_EQ(as_sentence("σ₀ is unknown"), "σ₀ is unknown.");
  EXPECT_EQ(as_sentence("µm are too coarse"), "µm are too coarse.");
}

TEST(Sentences, LettersBeyondAsciiHaveCapitals) {
  EXPECT_EQ(as_sentence("środek ciężkości"), "Środek ciężkości.");
  EXPECT_EQ(as_sentence("łożysko"), "Łożysko.");
  EXPECT_EQ(as_sentence("über"), "Über.");
}

TEST(Sentences, ALabelHasNoFullStop) {
  EXPECT_EQ(wording::capitalised("mean of A and B"), "Mean of A and B");
  EXPECT_EQ(wording::capitalised("\xc5"), "\xc5");
  EXPECT_EQ(wording::capitalised("\xc5 broken"), "\xc5 broken");
}

}  // namespace
}  // namespace tribolog::test::sentence_test
