// A whole robot by its manifest: from one log of all joints to a page, a report and numbers of
// each.

#include <cstddef>
#include <filesystem>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"

namespace tribolog::test::robot_test {
namespace {

using nlohmann::json;

/// Two joints, each with a sweep, a loop and a few runs.
std::string scenario_text() {
  std::string text = R"(schema = "tribolog-scenario-1"
name = "two joints"
[robot]
name = "two axes"
serial = "7"
[friction]
model = "lugre"
[friction.sliding]
model = "dynamic"
[noise]
torque_white_Nm = 0.005
)";
  for (const auto& [name, ratio, peak] : {std::tuple{"J1", 100, 10}, std::tuple{"J2", 50, -20}}) {
    text += fmt::format(R"(
[[joints]]
name = "{}"
gear_ratio = {}
motor_inertia_kgm2 = 1e-4
arm_inertia_kgm2 = 0.5
[joints.load]
mass_kg = 12
distance_m = 0.2
q_peak_deg = {}
[joints.friction.presliding]
bristle_stiffness_Nm_rad = 100
bristle_damping_Nms_rad = 0.1
viscous_Nms_rad = 1e-3
coulomb_Nm = 0.1
static_Nm = 0.15
stribeck_speed_rad_s = 5
[joints.rough_sweep]
from_deg = {}
to_deg = {}
speed_deg_s = 5
sample_rate_Hz = 100
[joints.oscillation]
centre_deg = {}
amplitude_rad = {}
frequency_Hz = 1
cycles = 6
sample_rate_Hz = 200
record_bristle = false
[joints.constant_speed]
motor_speeds_rad_s = [2, 6, 15, 40]
centre_deg = {}
largest_travel_deg = 50
longest_plateau_s = 2
acceleration_rad_s2 = 15
sample_rate_Hz = 100
)",
                        name, ratio, peak, peak - 50, peak + 45, peak, 0.008 / ratio, peak);
  }
  return text;
}

struct Robot {
  ScratchDirectory scratch;

  Robot() {
    const std::string scenario = scratch.write("scenario.toml", scenario_text());
    const ProgramRun made = run("simulate '" + scenario + "' -o '" + scratch.path() + "'");
    EXPECT_EQ(made.status, 0) << made.err;
  }
  [[nodiscard]] std::string file(const std::string& name) const { return scratch.file(name); }
  [[nodiscard]] static ProgramRun run(const std::string& what) { return run_shell(program + what); }
  [[nodiscard]] json read(const std::string& name) const {
    return json::parse(read_text(file(name)));
  }
  [[nodiscard]] ProgramRun report(const std::string& manifest, const std::string& more = "") const {
    return run("--quiet report '" + file(manifest) + "' -o '" + file("out") +
               "' --truth-runs 0 --no-figures " + more);
  }
};

double estimate_of(const json& calibration, const std::string& key) {
  for (const json& q : calibration["verdict"]["quantities"]) {
    if (q["key"] == key) return q["estimate"]["estimate"];
  }
  ADD_FAILURE() << key;
  return 0;
}

TEST(WholeRobot, IsReportedInOneGoAndKeptInOneArchive) {
  const Robot robot;
  const ProgramRun run = robot.report("robot.toml", "--archive '" + robot.file("a.tribolog") + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string page = read_text(robot.file("out/index.html"));
  for (const char* name : {"J1", "J2"}) {
    EXPECT_NE(page.find(fmt::format("href=\"{}.html\"", name)), std::string::npos);
    EXPECT_NE(read_text(robot.file(fmt::format("out/{}.html", name))).find("<!DOCTYPE html>"),
              std::string::npos);
    // The very numbers of the joint alone.
    const ProgramRun alone =
        Robot::run(fmt::format("--quiet identify '{}' --joint {} --truth-runs 0 -o '{}'",
                               robot.file("robot.toml"), name, robot.file("alone.json")));
    EXPECT_EQ(alone.status, 0) << alone.err;
    EXPECT_EQ(robot.read(fmt::format("out/{}.calibration.json", name))["verdict"],
              robot.read("alone.json")["verdict"]);
  }
  // A second report takes the place of the first.
  EXPECT_EQ(robot.report("robot.toml").status, 0);
  // The page says each joint's verdict and numbers by itself.
  const ProgramRun shown = Robot::run("show '" + robot.file("out") + "'");
  EXPECT_EQ(shown.status, 0) << shown.err;
  for (const char* words : {"two axes", "\nJ1: ", "\nJ2: ", "Coulomb torque", "Gravity torque"}) {
    EXPECT_NE(shown.out.find(words), std::string::npos) << words << '\n' << shown.out;
  }
  const json page_numbers =
      json::parse(Robot::run("show '" + robot.file("out/index.html") + "' --json").out);
  const json& second = page_numbers["joints"][1];
  const json own = robot.read("out/J2.calibration.json");
  EXPECT_EQ(second["report"], "J2.html");
  EXPECT_EQ(second["verdict"], own["verdict"]["verdict"]);
  for (const json& q : second["quantities"]) {
    if (q["key"] != "coulomb_torque") continue;
    EXPECT_EQ(q["estimate"]["value"].get<double>(), estimate_of(own, "coulomb_torque"));
  }
  const json truth = robot.read("truth.json");
  EXPECT_NEAR(estimate_of(robot.read("out/J2.calibration.json"), "gravity_torque"),
              truth["joints"][1]["gravity_torque_motor_Nm"].get<double>(), 0.01);
  const ProgramRun list =
      Robot::run("archive list --json --archive '" + robot.file("a.tribolog") + "'");
  for (const char* name : {"J1", "J2"}) {
    EXPECT_NE(list.out.find(fmt::format("\"joint\": \"{}\"", name)), std::string::npos) << list.out;
  }
}

TEST(WholeRobot, AJointThatIsRefusedDoesNotStopTheOthers) {
  const Robot robot;
  const std::string manifest = read_text(robot.file("robot.toml"));
  robot.scratch.write("broken.toml", replaced(manifest, "q2_rad", "no_such_column"));
  const ProgramRun run = robot.report("broken.toml");
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("J2: error: "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("no_such_column"), std::string::npos) << run.err;
  const std::string page = read_text(robot.file("out/index.html"));
  EXPECT_NE(page.find("J1.html"), std::string::npos);
  EXPECT_NE(page.find("class=\"refusal\""), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(robot.file("out/J2.html")));
}

TEST(WholeRobot, InitFindsTheMotionsOfEachJoint) {
  const Robot robot;
  const std::string init = "--quiet init '" + robot.file("robot.csv") + "' --all-joints -o '" +
                           robot.file("found.toml") + "' --effort-kind motor_torque ";
  const ProgramRun run = Robot::run(init + "--gear-ratio 100,50");
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string text = read_text(robot.file("found.toml"));
  for (const char* part : {"gear_ratio = 100", "gear_ratio = 50", "role = \"rough_sweep\"",
                           "role = \"oscillation\"", "role = \"constant_speed\""}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  const ProgramRun report = robot.report("found.toml");
  EXPECT_EQ(report.status, 0) << report.err;
  const json truth = robot.read("truth.json");
  for (std::size_t k = 0; k < 2; ++k) {
    const json found = robot.read(fmt::format("out/{}.calibration.json", k + 1));
    EXPECT_NEAR(estimate_of(found, "gravity_torque"),
                truth["joints"][k]["gravity_torque_motor_Nm"].get<double>(), 0.01);
    EXPECT_NEAR(estimate_of(found, "bristle_stiffness"), 100, 10);
  }
  const ProgramRun three = Robot::run(init + "--gear-ratio 100,50,20 --force");
  EXPECT_EQ(three.status, 2);
  EXPECT_NE(three.err.find("3 values for 2 joints"), std::string::npos) << three.err;
}

TEST(WholeRobot, IdentifyWritesTheNumbersOfEach) {
  const Robot robot;
  const ProgramRun run = Robot::run("identify '" + robot.file("robot.toml") + "' -o '" +
                                    robot.file("numbers") + "' --truth-runs 0");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("of 2 joints usable"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find("J1: "), std::string::npos) << "a line of progress for each\n" << run.err;
  EXPECT_TRUE(std::filesystem::exists(robot.file("numbers/J1.calibration.json")));
  EXPECT_TRUE(std::filesystem::exists(robot.file("numbers/J2.calibration.json")));
  EXPECT_EQ(Robot::run("identify '" + robot.file("robot.toml") + "' -o -").status, 2);
  const ProgramRun late = Robot::run("identify '" + robot.file("robot.toml") + "' -o '" +
                                     robot.file("robot.csv") + "'");
  EXPECT_EQ(late.status, 4);
  EXPECT_EQ(late.err.find("J1: "), std::string::npos) << "told before anything is read\n"
                                                      << late.err;
}

}  // namespace
}  // namespace tribolog::test::robot_test
