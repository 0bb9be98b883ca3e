#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "base/requirements.h"
#include "wording/words.h"

namespace tribolog::refusal_words_test {
namespace {

std::string said_by(const std::function<void()>& requirement) {
  try {
    requirement();
  } catch (const std::invalid_argument& refused) {
    return wording::words(refused);
  }
  return "nothing";
}

TEST(RefusalWords, QuoteTheValueAndTheRule) {
  EXPECT_EQ(said_by([] { require_positive(2, "inertia", "kg·m²"); }), "nothing");
  EXPECT_EQ(said_by([] { require_positive(0, "inertia", "kg·m²"); }),
            "inertia 0 kg·m² is not allowed; it must be > 0");
  EXPECT_EQ(said_by([] { require_positive(-1.5, "gear ratio", ""); }),
            "gear ratio −1.5 is not allowed; it must be > 0");
  EXPECT_EQ(said_by([] { require_not_negative(0, "damping", "N·m·s/rad"); }), "nothing");
  EXPECT_EQ(said_by([] { require_not_negative(-0.1, "damping", "N·m·s/rad"); }),
            "damping −0.1 N·m·s/rad is not allowed; it must be >= 0");
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(said_by([&] { require_not_negative(infinite, "stiction gain", ""); }),
            "stiction gain inf is not allowed; it must be >= 0");
  EXPECT_EQ(said_by([] { require_not_above(1, "Coulomb torque", 1, "static torque", "N·m"); }),
            "nothing");
  EXPECT_EQ(said_by([] { require_not_above(1.4, "Coulomb torque", 1.1, "static torque", "N·m"); }),
            "Coulomb torque 1.4 N·m exceeds static torque 1.1 N·m; it must not be larger");
}

TEST(RefusalWords, SayTheWordsOfAParameterThatHasACode) {
  EXPECT_EQ(said_by([] { require_positive(-1, Code{"parameter.cog_distance"}, "m"); }),
            "distance of the centre of gravity −1 m is not allowed; it must be > 0");
}

TEST(RefusalWords, AreWhatAnyOtherErrorSays) {
  EXPECT_EQ(wording::words(std::runtime_error("no such file")), "no such file");
}

TEST(RefusalWords, AreTheCodeWhereThereIsNoMessage) {
  EXPECT_EQ(wording::words(Refusal({"test.unheard_of", {{"runs", 3}}})),
            "test.unheard_of (runs 3)");
}

}  // namespace
}  // namespace tribolog::refusal_words_test
