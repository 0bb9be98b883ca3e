// Bad input: one clear line, the documented exit status, and the old report untouched.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::bad_input_test {
namespace {

struct BadInput {
  const char* name;
  std::string manifest;
  std::string log;
  int status;
  std::string says;  // must appear on standard error
};

std::vector<BadInput> bad_inputs() {
  const std::string m = small_manifest();
  const std::string l = small_log();
  return {
      {"MissingLog", replaced(m, "log.csv", "gone.csv"), l, 3, "No such file or directory"},
      {"MissingColumn", replaced(m, "\"tau\"", "\"torque\""), l, 3, "torque"},
      {"TextInANumber", m, replaced(l, "\n1,-0.7,", "\n1,abc,"), 3, "abc"},
      {"NoEffortKind", replaced(m, "kind = \"motor_torque\"\n", ""), l, 3, "kind"},
      {"NoEffortSide", replaced(m, "side = \"motor\"\n", ""), l, 3, "side"},
      {"CurrentWithoutConstant", replaced(m, "motor_torque", "motor_current"), l, 3,
       "torque_constant_Nm_A"},
      {"EmptyLog", m, "", 3, "empty"},
      {"HeaderOnly", m, "t,q,tau\n", 3, "no data rows"},
      {"UnknownUnit", replaced(m, "\"Nm\"", "\"furlong\""), l, 3, "furlong"},
      {"ZeroGearRatio", replaced(m, "gear_ratio = 100", "gear_ratio = 0"), l, 3, "gear"},
      {"UnknownKey", replaced(m, "gear_ratio", "gear_ration"), l, 3, "gear_ratio"},
      {"UnknownRole", replaced(m, "rough_sweep", "ruff_sweep"), l, 3, "rough_sweep"},
      {"BrokenToml", replaced(m, "[joint]", "[joint"), l, 3, "dataset.toml:"},
      {"DecimalComma", m, replaced(l, "t,q,tau\n0,", "t;q;tau\n0;"), 3, "log.csv"},
      {"TwoLogsInOne", m, l + l, 3, "log.csv:"},
      {"BinaryLog", m, std::string("\x89PNG\r\n\x1a\n\0\0\0", 11), 3, "log.csv"},
      {"NoRecording",
       replaced(m, "[[recording]]\nrole = \"rough_sweep\"\nfile = \"log.csv\"\n", ""), l, 3,
       "recording"},
      {"DuplicateColumn", m, replaced(l, "t,q,tau", "t,q,q"), 3, "q"},
  };
}

class BadInputTest : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadInputTest, OneLineRightStatusOldReportUntouched) {
  const BadInput& bad = GetParam();
  const SmallDataset dataset(bad.manifest, bad.log);
  dataset.scratch().write("report.html", "last year's report");
  dataset.scratch().write("report.calibration.json", "last year's numbers");
  const ProgramRun run = dataset.run("--quiet report", "report.html");
  EXPECT_EQ(run.status, bad.status) << run.err;
  EXPECT_NE(run.err.find(bad.says), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(read_text(dataset.file("report.html")), "last year's report");
  EXPECT_EQ(read_text(dataset.file("report.calibration.json")), "last year's numbers");
}

INSTANTIATE_TEST_SUITE_P(Kinds, BadInputTest, ::testing::ValuesIn(bad_inputs()),
                         [](const auto& which) { return std::string(which.param.name); });

TEST(BadInput, MissingManifest) {
  const ProgramRun run = run_shell(program + "identify /nowhere/dataset.toml -o /tmp/x.json");
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("/nowhere/dataset.toml: cannot open"), std::string::npos) << run.err;
}

TEST(BadInput, ImpossibleScenarioNamesItsKey) {
  const ScratchDirectory scratch;
  const std::string scenario =
      replaced(read_text(std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/scenario.toml"),
               "gear_ratio = 100", "gear_ratio = -100");
  const std::string path = scratch.write("scenario.toml", scenario);
  const ProgramRun run =
      run_shell(program + "simulate '" + path + "' -o '" + scratch.file("out") + "'");
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_NE(run.err.find("gear_ratio"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("scenario.toml:"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace tribolog::test::bad_input_test
