// Messages with places: what they match, and what comes out.

#include "wording/message_pattern.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace tribolog::message_pattern_test {
namespace {

using Texts = std::vector<std::string>;

/// What stood in the places; {"-"} where the text is another message.
Texts placed(const std::string& message, const std::string& text) {
  const auto found = wording::MessagePattern(message).match(text);
  if (!found) return {"-"};
  Texts texts;
  for (const wording::PlacedText& one : *found) texts.emplace_back(one.text);
  return texts;
}

TEST(MessagePattern, MatchesWholeTextsOnly) {
  EXPECT_EQ(placed("no place", "no place"), Texts{});
  EXPECT_EQ(placed("no place", "no place at all"), Texts{"-"});
  EXPECT_EQ(placed("{n} runs", "15 runs"), Texts{"15"});
  EXPECT_EQ(placed("{n} runs", "15 runs, 5 left out"), Texts{"-"});
  EXPECT_EQ(placed("at {}", "at "), Texts{"-"});
  EXPECT_EQ(placed("{} at {}: {}", "a at b at c: d: e"), (Texts{"a", "b at c", "d: e"}));
}

TEST(MessagePattern, NumbersAreThoseOfTheReport) {
  for (const char* number :
       {"3", "−0.0043", "3.8832 ± 0.0043", "1 000", "1.2e-5", "1.2×10⁻⁷", "0.1 … 3"}) {
    const bool is_number = std::string(number) != "0.1 … 3";
    EXPECT_EQ(placed("{n} kg", number + std::string(" kg")), Texts{is_number ? number : "-"});
  }
  EXPECT_EQ(placed("{n} kg", "some kg"), Texts{"-"});
  EXPECT_EQ(placed("{n} kg", "± kg"), Texts{"-"});
  // A blank beside a number is the message's own.
  EXPECT_EQ(placed("{n} to {n}", "1 to 2"), (Texts{"1", "2"}));
}

TEST(MessagePattern, LongTextsOfManyPlacesEnd) {
  const std::string text(20'000, 'a');
  EXPECT_EQ(placed("{}a{}a{}a{}a{}b", text), Texts{"-"});
}

TEST(MessagePattern, RefusesWrongPlaces) {
  for (const char* wrong : {"{", "{n", "{x}", "{}{}", "{n}{t} a"}) {
    EXPECT_THROW(wording::MessagePattern{wrong}, std::invalid_argument) << wrong;
  }
}

TEST(FillPlaces, OrderIsTheTranslations) {
  EXPECT_EQ(wording::fill_places("{1} z {0}", {"a", "b"}), "b z a");
  EXPECT_EQ(wording::fill_places("{0} {0|próbka|próbki|próbek}", {"22"}), "22 próbki");
  for (const char* wrong : {"{2}", "{0", "{0|a}", "{}", "{a}", "{-1}"}) {
    EXPECT_THROW(wording::fill_places(wrong, {"a", "b"}), std::invalid_argument) << wrong;
  }
}

TEST(PluralForm, IsThatOfPolish) {
  for (const char* one : {"1"}) EXPECT_EQ(wording::plural_form(one), 0) << one;
  for (const char* few : {"2", "4", "22", "104"}) EXPECT_EQ(wording::plural_form(few), 1) << few;
  for (const char* many : {"0", "5", "11", "12", "14", "21", "112", "1.5", "2.0", "−2", "many"}) {
    EXPECT_EQ(wording::plural_form(many), 2) << many;
  }
}

}  // namespace
}  // namespace tribolog::message_pattern_test
