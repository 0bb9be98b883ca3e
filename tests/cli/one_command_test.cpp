// From a log to an answer in one command: what is written where, and what is never replaced.

#include <cmath>
#include <filesystem>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"

namespace tribolog::test::one_command_test {
namespace {

namespace fs = std::filesystem;

/// A sweep there and back over a gravity peak at 0.2 rad, the effort under the given name.
std::string sweep(const std::string& header, double per_radian = 1) {
  std::string csv = header + "\n";
  for (int i = 0; i <= 4000; ++i) {
    const double t = 0.02 * i;
    const double q = i <= 2000 ? -1 + 0.001 * i : 1 - 0.001 * (i - 2000);
    const double friction = i <= 2000 ? 4.0 : -4.0;
    const double noise = 0.05 * std::sin(1234.5 * i);
    csv += fmt::format("{:.3f},{:.6f},{:.5f}\n", t, q * per_radian,
                       30 * std::cos(q - 0.2) + friction + noise);
  }
  return csv;
}

class OneCommand : public testing::Test {
 protected:
  [[nodiscard]] ProgramRun report(const std::string& arguments) const {
    return run_shell("cd '" + scratch_.path() + "' && " + program +
                     "report --no-figures --truth-runs 0 " + arguments);
  }
  [[nodiscard]] nlohmann::json numbers(const std::string& name) const {
    return nlohmann::json::parse(read_text(scratch_.file(name)));
  }
  [[nodiscard]] std::string verdict_on(const std::string& quantity, const std::string& name) const {
    const nlohmann::json all = numbers(name);
    for (const auto& one : all["verdict"]["quantities"]) {
      if (one["key"] == quantity) return one["verdict"];
    }
    return "";
  }
  ScratchDirectory scratch_;
};

TEST_F(OneCommand, WritesPageManifestAndNumbersBesideTheLog) {
  scratch_.write("joint.csv", sweep("t_s,q_rad,tau_Nm"));
  const ProgramRun run = report("joint.csv --effort-kind joint_torque --gear-ratio 50");
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* name : {"joint.html", "joint.toml", "joint.calibration.json"}) {
    EXPECT_TRUE(fs::exists(scratch_.file(name))) << name;
  }
  EXPECT_EQ(run.out.find("the log does not tell"), std::string::npos) << run.out;
  const ProgramRun again = report("joint.toml");
  EXPECT_EQ(again.status, 0) << again.err;
}

// Makers state the motor's constant as well as that behind the gear.
TEST_F(OneCommand, DoesNotTrustTheSideOfATorqueConstant) {
  scratch_.write("joint.csv", sweep("t_s,q_rad,i_A"));
  const std::string known = "joint.csv --gear-ratio 101 --torque-constant 0.1 ";
  const ProgramRun guessed = report(known);
  EXPECT_EQ(guessed.status, 0) << guessed.err;
  EXPECT_NE(guessed.out.find("--torque-constant 0.1 --effort-side SIDE"), std::string::npos)
      << guessed.out;
  EXPECT_NE(read_text(scratch_.file("joint.toml")).find("confirmed = false  # the side is a guess"),
            std::string::npos);
  for (const char* quantity : {"gravity_torque", "coulomb_torque"}) {
    EXPECT_NE(verdict_on(quantity, "joint.calibration.json"), "usable") << quantity;
  }
  for (const char* side : {"motor", "joint"}) {
    const ProgramRun stated = report(known + "--effort-side " + side);
    EXPECT_EQ(stated.status, 0) << stated.err;
    EXPECT_EQ(stated.out.find("--effort-side SIDE"), std::string::npos) << stated.out;
    const std::string manifest = read_text(scratch_.file("joint.toml"));
    EXPECT_EQ(manifest.find("confirmed = false  # the side"), std::string::npos) << manifest;
  }
  // Without a gear there is one side alone.
  const ProgramRun direct = report("joint.csv --gear-ratio 1 --torque-constant 0.1");
  EXPECT_EQ(direct.out.find("--effort-side"), std::string::npos) << direct.out;
}

TEST_F(OneCommand, WritesNothingWhereOneOfSeveralLogsIsMissing) {
  scratch_.write("joint.csv", sweep("t_s,q_rad,tau_Nm"));
  const ProgramRun run = report("joint.csv page.html");
  EXPECT_EQ(run.status, 3) << run.out;
  EXPECT_NE(run.err.find("-o FILE names what is to be written"), std::string::npos) << run.err;
  for (const auto& entry : fs::directory_iterator(scratch_.path())) {
    EXPECT_EQ(entry.path().filename(), "joint.csv");
  }
}

TEST_F(OneCommand, NamesWhatToTypeForWhatTheLogDoesNotTell) {
  scratch_.write("joint.csv", sweep("time,position,torque"));
  const ProgramRun run = report("joint.csv");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("proposed, not confirmed: the angle's unit, rad (--angle-unit)"),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("joint.csv --angle-unit rad --time-unit s --gear-ratio "
                         "RATIO --effort-kind joint_torque --effort-unit Nm"),
            std::string::npos)
      << run.out;
  EXPECT_NE(verdict_on("gravity_torque", "joint.calibration.json"), "usable");
}

TEST_F(OneCommand, GivesTheNumbersOfACurrentInAmperes) {
  scratch_.write("joint.csv", sweep("t_s,q_rad,i_A"));
  const ProgramRun run = report("joint.csv");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("gravity torque at the joint"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("N·m"), std::string::npos) << run.out;
  const ProgramRun again = report("joint.toml");
  EXPECT_NE(again.out.find(" A (95 %"), std::string::npos) << again.out;
  EXPECT_EQ(again.out.find("N·m"), std::string::npos) << again.out;
  EXPECT_NE(run.out.find("--torque-constant NM_PER_A"), std::string::npos) << run.out;
  const nlohmann::json all = numbers("joint.calibration.json");
  EXPECT_EQ(all["drive"]["torque_is_in_amperes"], true);
  EXPECT_EQ(all["drive"]["torque_constant_Nm_A"], nullptr);
  EXPECT_NE(verdict_on("gravity_torque", "joint.calibration.json"), "usable");
  EXPECT_EQ(verdict_on("surrogate_mass", "joint.calibration.json"), "not_identifiable");
  const std::string page = read_text(scratch_.file("joint.html"));
  const std::string shown = page.substr(0, page.find("<script"));
  EXPECT_EQ(shown.find("N·m"), std::string::npos);
}

TEST_F(OneCommand, NeverReplacesAManifestThatSomebodyEdited) {
  scratch_.write("joint.csv", sweep("t_s,q_rad,tau_Nm"));
  ASSERT_EQ(report("joint.csv --gear-ratio 50").status, 0);
  // Unedited: another proposal may take its place.
  EXPECT_EQ(report("joint.csv --gear-ratio 60").status, 0);
  const std::string edited =
      replaced(read_text(scratch_.file("joint.toml")), "gear_ratio = 60", "gear_ratio = 61");
  scratch_.write("joint.toml", edited);
  const ProgramRun refused = report("joint.csv --gear-ratio 70");
  EXPECT_EQ(refused.status, 4) << refused.err;
  EXPECT_NE(refused.err.find("joint.toml: exists and was left unchanged"), std::string::npos)
      << refused.err;
  EXPECT_EQ(read_text(scratch_.file("joint.toml")), edited);
  EXPECT_EQ(report("joint.csv --gear-ratio 70 --force").status, 0);
}

TEST_F(OneCommand, NeverReplacesAPageOfSomebodyElses) {
  scratch_.write("joint.csv", sweep("t_s,q_rad,tau_Nm"));
  scratch_.write("joint.html", "<html>mine</html>");
  const ProgramRun run = report("joint.csv");
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_EQ(read_text(scratch_.file("joint.html")), "<html>mine</html>");
  EXPECT_EQ(report("joint.csv -o page.html").status, 0);
  EXPECT_TRUE(fs::exists(scratch_.file("page.toml")));
}

TEST_F(OneCommand, TakesAFolderOfLogs) {
  fs::create_directory(scratch_.file("runs"));
  scratch_.write("runs/a.csv", sweep("t_s,q_rad,tau_Nm"));
  scratch_.write("runs/b.csv", sweep("t_s,q_rad,tau_Nm"));
  for (int times = 0; times < 2; ++times) {  // what it wrote is no log of the second run's
    const ProgramRun run = report("runs");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("rows: 8002 read"), std::string::npos) << run.out;
  }
  EXPECT_TRUE(fs::exists(scratch_.file("runs/runs.html")));
}

TEST_F(OneCommand, OptionsOfLogsAreRefusedBesideAManifest) {
  const SmallDataset dataset;
  const ProgramRun run =
      run_shell(program + "report '" + dataset.file("dataset.toml") + "' --gear-ratio 3");
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_NE(run.err.find("--gear-ratio is for logs"), std::string::npos) << run.err;
}

TEST_F(OneCommand, LeavesAPageAloneThatOnlySpeaksOfTheProgram) {
  const std::string notes = "<html><body>Notes on tribolog</body></html>\n";
  scratch_.write("joint.csv", sweep("t_s,q_rad,tau_Nm"));
  scratch_.write("joint.html", notes);
  const ProgramRun run = report("joint.csv --gear-ratio 50");
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_EQ(read_text(scratch_.file("joint.html")), notes);
}

TEST_F(OneCommand, FrictionPointsNeedNoClock) {
  std::string csv = "velocity [rad/s],friction torque [Nm]\n";
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.004);
  for (int repeat = 0; repeat < 3; ++repeat) {
    for (int k = -9; k <= 9; ++k) {
      if (k == 0) continue;
      const double v = 0.2 * k;
      csv += fmt::format("{:.3f},{:.5f}\n", v, 0.57 * (v > 0 ? 1 : -1) + 0.52 * v + noise(random));
    }
  }
  scratch_.write("points.csv", csv);
  const ProgramRun run = report("points.csv");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(verdict_on("coulomb_torque", "points.calibration.json"), "usable") << run.out;
}

TEST_F(OneCommand, ARegisterWithoutItsSignIsSaidAndConfirmed) {
  std::string csv = "t_s,q_rad,present_current\n";
  for (int i = 0; i <= 4000; ++i) {
    const double q = i <= 2000 ? -1 + 0.001 * i : 1 - 0.001 * (i - 2000);
    const double effort = 30 * std::sin(q) + (i <= 2000 ? 4.0 : -4.0);
    const int counts = static_cast<int>(std::lround(effort * 10));
    csv += fmt::format("{:.3f},{:.6f},{}\n", 0.02 * i, q, counts < 0 ? counts + 65536 : counts);
  }
  scratch_.write("servo.csv", csv);
  const std::string known =
      "servo.csv --torque-constant 1 --effort-side joint --effort-unit '0.1 A'";
  const ProgramRun run = report(known);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE((run.out + run.err).find("unsigned 16"), std::string::npos) << run.out << run.err;
  EXPECT_NE(verdict_on("gravity_torque", "servo.calibration.json"), "usable");
  EXPECT_NE(read_text(scratch_.file("servo.toml")).find("register = \"unsigned 16\""),
            std::string::npos);
  ASSERT_EQ(report(known + " --signed-registers").status, 0);
  for (const auto& one : numbers("servo.calibration.json")["verdict"]["quantities"]) {
    if (one["key"] != "gravity_torque") continue;
    EXPECT_NEAR(one["estimate"]["estimate"], 30, 0.5);
  }
}

}  // namespace
}  // namespace tribolog::test::one_command_test
