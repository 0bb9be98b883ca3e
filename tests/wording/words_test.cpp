// Codes become sentences: each message with its values, in singular and plural, one inside another.

#include "wording/words.h"

#include <regex>
#include <stdexcept>

#include <gtest/gtest.h>

#include "wording/message_table.h"

namespace tribolog::words_test {
namespace {

TEST(Words, ValuesStandInTheirFormats) {
  EXPECT_EQ(wording::words(Statement{"verdict.known_to_share", {{"percent", 41.6}}}),
            "known only to ± 42 %");
  EXPECT_EQ(wording::words(Statement{}), "");
}

TEST(Words, NumbersHaveAMinusSignAndNoExponent) {
  const auto law = [](double coulomb_Nm) {
    return wording::words(
        Statement{"verdict.of_law_without_coulomb", {{"coulomb_Nm", coulomb_Nm}}});
  };
  EXPECT_EQ(law(-0.52), "the same law has a Coulomb torque of −0.52 N·m, which no joint has");
  EXPECT_EQ(law(-4.8e-5), "the same law has a Coulomb torque of −4.8×10⁻⁵ N·m, which no joint has");
}

TEST(Words, AStatementStandsInsideAnother) {
  const Statement why{"truth.too_few_samples"};
  EXPECT_EQ(
      wording::words(Statement{"truth.not_simulated", {{"recording", "a.csv"}, {"why", why}}}),
      "a.csv: too few samples");
}

TEST(Words, MoreIsSaidBehindASemicolon) {
  Statement all;
  all.add({});
  EXPECT_TRUE(all.empty());
  all.add({"verdict.no_loop_model"});
  EXPECT_EQ(wording::words(all), "no friction model was fitted to the loop");
  all.add({"truth.too_few_samples"});
  all.add({"truth.no_curve"});
  EXPECT_EQ(wording::words(all),
            "no friction model was fitted to the loop; too few samples; no friction curve was "
            "identified");
}

TEST(Words, WhatAPersonWroteStaysAsItIs) {
  EXPECT_EQ(wording::words(Statement::verbatim("100 % {of} it")), "100 % {of} it");
}

TEST(Words, WhatAnArchiveCallsAQuantityStaysAsItIs) {
  EXPECT_EQ(wording::words_for("quantity", "inertia", "Inertia at the motor"),
            "Inertia at the motor");
  EXPECT_EQ(wording::words_for("quantity", "inertia", "Rotor {of} old"), "Rotor {of} old");
  EXPECT_EQ(wording::words_for("quantity", "charm", "Charm"), "Charm");
}

TEST(Words, AFaultOfTheProgramIsNamed) {
  EXPECT_THROW(wording::words(Statement{"nobody.says_this"}), std::logic_error);
  EXPECT_THROW(wording::words(Statement{"verdict.known_to_share"}), std::logic_error);
  EXPECT_THROW(wording::words(Statement{"verdict.known_to_share", {{"percent", "much"}}}),
               std::logic_error);
  EXPECT_THROW(wording::words_for("quantity", "charm"), std::logic_error);
}

/// A value that the message's placeholder takes: a number where it has a number's format.
StatedValue value_for(const std::string& name, const std::string& format) {
  static const std::regex number("[+.0-9]*[efg]");
  if (std::regex_match(format, number)) return {name, 1.5};
  if (!format.empty()) return {name, std::vector<Statement>{{"truth.no_curve"}}};
  return {name, 2};
}

TEST(Words, EveryMessageTakesItsValues) {
  static const std::regex placeholder(R"(\{(\w+)(?::([^}]*))?\})");
  for (const auto& [coded, forms] : wording::all_messages()) {
    const std::string code(coded);
    const std::string message(forms.one);
    std::vector<StatedValue> values;
    for (std::sregex_iterator at(message.begin(), message.end(), placeholder), end; at != end;
         ++at) {
      values.push_back(value_for((*at)[1], (*at)[2]));
    }
    // One that a count decides names it; two of it are many.
    std::string text;
    ASSERT_NO_THROW(text = wording::words(Statement::with(Code::of(code), values))) << code;
    EXPECT_FALSE(text.empty()) << code;
    EXPECT_EQ(text.find('{'), std::string::npos) << code << ": " << text;
  }
}

}  // namespace
}  // namespace tribolog::words_test
