// What is printed: aligned, within the page, and safe on a terminal.

#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "inspect/survey/log_survey.h"
#include "inspect/survey/text_table.h"
#include "support/run_program.h"

namespace tribolog::survey_text_test {
namespace {

TEST(TextTable, AlignsByCharactersNotBytes) {
  inspect::survey::TextTable table(2);
  table.add({"a", "°", "x"});
  table.add({"bbb", "22", "y"});
  EXPECT_EQ(table.text(), "  a    °   x\n  bbb  22  y\n");
}

TEST(TextTable, BreaksItsLastColumn) {
  inspect::survey::TextTable table(0);
  table.add({"key", "many words that do not fit into the width"});
  EXPECT_EQ(table.text(31), "key  many words that do not fit\n     into the width\n");
}

TEST(SurveyText, FitsIntoThePageAndShowsControlCharacters) {
  const test::ScratchDirectory scratch;
  std::string csv = "t_s,q_rad,tau_Nm,\"evil\x1b[31m\"\n";
  for (int i = 0; i < 200; ++i) csv += fmt::format("{},{},{},1\n", 0.01 * i, 0.01 * i, 1.0);
  std::vector<inspect::survey::LogSurvey> logs;
  for (int k = 0; k < 3; ++k) {
    logs.push_back(inspect::survey::survey_log(scratch.write(fmt::format("run_{}.csv", k), csv)));
  }
  const std::string text = inspect::survey::survey_text(logs);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("\\x1b"), std::string::npos);
  EXPECT_NE(text.find("3 logs with the same columns"), std::string::npos);
  EXPECT_NE(text.find("constant"), std::string::npos) << "a column that never changes";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(inspect::survey::places(line), 100U) << line;
}

}  // namespace
}  // namespace tribolog::survey_text_test
