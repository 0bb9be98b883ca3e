// The template for controllers means to the program what its comments say.

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "inspect/survey/log_survey.h"
#include "support/run_program.h"

namespace tribolog::controller_template_test {
namespace {

const std::string template_path =
    std::string(TRIBOLOG_SOURCE_DIR) + "/examples/templates/controller_log.csv";

void expect_understood(const inspect::survey::TableSurvey& table) {
  ASSERT_TRUE(table.clock);
  EXPECT_EQ(table.clock->unit, "s");
  ASSERT_EQ(table.joints.size(), 1U);
  const inspect::survey::JointSurvey& joint = table.joints[0];
  const auto expect = [&](std::optional<std::size_t> column, ingest::log::Quantity quantity,
                          const char* unit) {
    ASSERT_TRUE(column);
    ASSERT_TRUE(table.columns[*column].meaning);
    EXPECT_EQ(table.columns[*column].meaning->quantity, quantity);
    EXPECT_EQ(table.columns[*column].meaning->unit, unit);
    EXPECT_TRUE(table.columns[*column].meaning->unit_is_stated);
    EXPECT_TRUE(table.columns[*column].guessed_by.empty()) << "told by its name";
  };
  expect(joint.angle, ingest::log::Quantity::angle, "deg");
  expect(joint.speed, ingest::log::Quantity::angular_speed, "deg/s");
  expect(joint.effort, ingest::log::Quantity::current, "A");
  expect(joint.temperature, ingest::log::Quantity::temperature, "degC");
}

TEST(ControllerTemplate, IsUnderstoodAsItStands) {
  const inspect::survey::LogSurvey log = inspect::survey::survey_log(template_path);
  ASSERT_EQ(log.tables.size(), 1U);
  EXPECT_EQ(log.tables[0].rows, 3U);
  expect_understood(log.tables[0]);
  EXPECT_EQ(log.tables[0].columns[*log.tables[0].joints[0].effort].gaps, 1U);
}

TEST(ControllerTemplate, IsUnderstoodWithRowsOfAWholeRun) {
  const test::ScratchDirectory scratch;
  std::ifstream file(template_path);
  std::string csv(std::istreambuf_iterator<char>(file), {});
  constexpr int rows = 2000;
  for (int i = 3; i < rows; ++i) {
    csv += fmt::format("{:.2f},{:.4f},{:.3f},{:.3f},31.5\n", 0.01 * i, -10 + 0.05 * i, 5.0,
                       1.8 + 0.2 * std::cos(0.001 * i));
  }
  const inspect::survey::LogSurvey log = inspect::survey::survey_log(scratch.write("run.csv", csv));
  expect_understood(log.tables.at(0));
  EXPECT_NEAR(log.tables[0].joints.at(0).highest_rad,
              (-10 + 0.05 * (rows - 1)) * std::numbers::pi / 180, 1e-6);
  EXPECT_FALSE(log.tables[0].joints[0].segments.empty());
}

}  // namespace
}  // namespace tribolog::controller_template_test
