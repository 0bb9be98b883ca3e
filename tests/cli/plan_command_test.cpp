// `tribolog plan`: what it writes, and how it refuses.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"
#include "support/breadth.h"

namespace tribolog::test::plan_command_test {
namespace {

using nlohmann::json;

const std::string example = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/plan/joint.toml";

ProgramRun plan(const ScratchDirectory& scratch, const std::string& arguments) {
  return run_shell("cd '" + scratch.path() + "' && SOURCE_DATE_EPOCH=1700000000 " + program +
                   "plan " + arguments);
}

TEST(PlanCommand, WritesPageNumbersSetPointsAndManifest) {
  const ScratchDirectory scratch;
  const ProgramRun run = plan(scratch, "'" + example + "' -o out/first --runs 2");
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* name : {"plan.html", "plan.json", "setpoints.csv", "dataset.toml"}) {
    EXPECT_TRUE(std::filesystem::exists(scratch.file(std::string("out/first/") + name))) << name;
  }
  for (const char* words : {"rough sweep", "micro-oscillations", "8 positions", "± "}) {
    EXPECT_NE(run.out.find(words), std::string::npos) << words << '\n' << run.out;
  }
  EXPECT_EQ(run.err.find("note:"), std::string::npos) << run.err;
  // Each picture is in the page.
  const std::string page = read_text(scratch.file("out/first/plan.html"));
  EXPECT_NE(page.find("data:image/png"), std::string::npos);
  EXPECT_EQ(page.find("This figure is missing"), std::string::npos);
}

TEST(PlanCommand, OfAReportPlansWhatIsMissingWithinWhatWasRecorded) {
  const SmallDataset directory;
  const std::string at = "cd '" +
                         std::filesystem::path(directory.file("r.html")).parent_path().string() +
                         "' && " + program;
  ASSERT_EQ(run_shell(at + "report dataset.toml -o r.html --no-figures").status, 0);
  const std::string page = read_text(directory.file("r.html"));
  EXPECT_NE(page.find("id=\"next-experiment\""), std::string::npos);
  EXPECT_NE(page.find("tribolog plan REPORT.html -o next"), std::string::npos);
  const ProgramRun run = run_shell(at + "plan r.html -o next --runs 0");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("not needed"), std::string::npos) << run.out;
  const json first = json::parse(read_text(directory.file("next/plan.json")));
  EXPECT_GT(first["duration_s"], 10);
  // Its own file of the joint, with the limits put right, is a plan too.
  EXPECT_EQ(run_shell(at + "plan next/joint.toml -o again --runs 0").status, 0);
}

TEST(PlanCommand, SameInputSameBytes) {
  TRIBOLOG_EACH_NIGHT();
  const ScratchDirectory scratch;
  for (const char* threads : {"1", "2"}) {
    EXPECT_EQ(plan(scratch, "'" + example + "' -o out --runs 2 --threads " + threads).status, 0);
    std::filesystem::rename(scratch.file("out"), scratch.file(std::string("out_") + threads));
  }
  for (const char* name : {"plan.json", "setpoints.csv", "dataset.toml"}) {
    EXPECT_EQ(read_text(scratch.file(std::string("out_1/") + name)),
              read_text(scratch.file(std::string("out_2/") + name)))
        << name;
  }
}

TEST(PlanCommand, RefusesAndLeavesTheOldPlan) {
  const ScratchDirectory scratch;
  scratch.write("bad.toml", "schema = \"tribolog-joint-1\"\n[robot]\n");
  std::filesystem::create_directory(scratch.file("out"));
  scratch.write("out/setpoints.csv", "of last year");
  const ProgramRun refused = plan(scratch, "bad.toml -o out");
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("bad.toml:2:"), std::string::npos) << refused.err;
  EXPECT_EQ(plan(scratch, "'" + example + "' -o out --calibration bad.toml").status, 3);
  EXPECT_EQ(plan(scratch, "-o out").status, 2);
  std::filesystem::create_directory(scratch.file("out/plan.html"));
  EXPECT_EQ(plan(scratch, "'" + example + "' -o out --runs 0").status, 4);
  EXPECT_EQ(read_text(scratch.file("out/setpoints.csv")), "of last year");
}

TEST(PlanCommand, OfAWholeRobotIsADirectoryForEachJointAndAPage) {
  const ScratchDirectory scratch;
  const std::string robot = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/plan/robot.toml";
  const ProgramRun run = plan(scratch, "'" + robot + "' -o out --runs 0");
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* joint : {"shoulder", "elbow"}) {
    for (const char* name : {"plan.html", "plan.json", "setpoints.csv", "dataset.toml"}) {
      EXPECT_TRUE(std::filesystem::exists(scratch.file(std::string("out/") + joint + "/" + name)));
    }
  }
  const std::string page = read_text(scratch.file("out/index.html"));
  EXPECT_NE(page.find("href=\"shoulder/plan.html\""), std::string::npos);
  // The manifest of all logs names those that are not there yet.
  const ProgramRun too_early = run_shell(program + "report '" + scratch.file("out/dataset.toml") +
                                         "' -o '" + scratch.file("robot") + "'");
  EXPECT_EQ(too_early.status, 3);
  EXPECT_NE(too_early.err.find("shoulder/"), std::string::npos) << too_early.err;
  EXPECT_NE(too_early.err.find("elbow/"), std::string::npos) << too_early.err;
  // The sums and the joints' own plans agree.
  const json numbers =
      json::parse(run_shell(program + "show '" + scratch.file("out") + "' --json").out);
  double sum_s = 0;
  for (const json& joint : numbers["joints"]) {
    const std::string name = joint["name"];
    const json own = json::parse(read_text(scratch.file("out/" + name + "/plan.json")));
    double ends_s = 0;
    for (const json& segment : own["segments"]) ends_s = segment["end_s"];
    EXPECT_NEAR(joint["duration_s"].get<double>(), ends_s, 1e-9) << name;
    sum_s += ends_s;
  }
  EXPECT_EQ(numbers["joints"].size(), 2U);
  EXPECT_NEAR(numbers["duration_s"].get<double>(), sum_s, 1e-9);
  // One joint by its name has the same plan.
  EXPECT_EQ(plan(scratch, "'" + robot + "' --joint elbow -o alone --runs 0").status, 0);
  EXPECT_EQ(read_text(scratch.file("alone/setpoints.csv")),
            read_text(scratch.file("out/elbow/setpoints.csv")));
}

TEST(PlanCommand, AJointOfARobotThatIsRefusedDoesNotStopTheOthers) {
  const ScratchDirectory scratch;
  const std::string robot =
      read_text(std::string(TRIBOLOG_SOURCE_DIR) + "/examples/plan/robot.toml");
  scratch.write("robot.toml", replaced(robot, "lowest_deg = -150", "lowest_deg = 150"));
  const ProgramRun run = plan(scratch, "robot.toml -o out --runs 0");
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("elbow: error: robot.toml:"), std::string::npos) << run.err;
  EXPECT_TRUE(std::filesystem::exists(scratch.file("out/shoulder/plan.html")));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("out/elbow")));
  EXPECT_NE(read_text(scratch.file("out/index.html")).find("class=\"refusal\""), std::string::npos);
  EXPECT_EQ(plan(scratch, "robot.toml -o out --calibration nowhere").status, 2);
  EXPECT_EQ(plan(scratch, "robot.toml -o out --joint wrist").status, 3);
  scratch.write("logs.toml", "schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n");
  const ProgramRun logs = plan(scratch, "logs.toml -o out");
  EXPECT_EQ(logs.status, 3);
  EXPECT_NE(logs.err.find("logs.toml: is a manifest, expected the file of a joint"),
            std::string::npos)
      << logs.err;
}

TEST(PlanCommand, AFileOfTheJointIsNeverOverwritten) {
  const ScratchDirectory scratch;
  scratch.write("dataset.toml", read_text(example));
  EXPECT_EQ(plan(scratch, "dataset.toml -o . --runs 0").status, 2);
  EXPECT_EQ(read_text(scratch.file("dataset.toml")), read_text(example));
}

}  // namespace
}  // namespace tribolog::test::plan_command_test
