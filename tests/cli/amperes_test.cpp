// A current whose torque constant nobody states: every number of it says amperes, wherever it goes.

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"

namespace tribolog::test::amperes_test {
namespace {

using nlohmann::json;

/// A sweep there and back over a gravity peak at 0.2 rad: 30 A of gravity and 4 A of friction.
std::string sweep() {
  std::string csv = "t_s,q_rad,i_A\n";
  for (int i = 0; i <= 4000; ++i) {
    const double q = i <= 2000 ? -1 + 0.001 * i : 1 - 0.001 * (i - 2000);
    const double noise = 0.05 * std::sin(1234.5 * i);
    csv += fmt::format("{:.3f},{:.6f},{:.5f}\n", 0.02 * i, q,
                       30 * std::cos(q - 0.2) + (i <= 2000 ? 4.0 : -4.0) + noise);
  }
  return csv;
}

/// Neither N·m nor kg·m², in any spelling of the formats.
void expect_no_torques(const std::string& text) {
  for (const char* const unit : {"N·m", "kg·m", "N\\ensuremath{\\cdot}m", "\\newton"}) {
    EXPECT_EQ(text.find(unit), std::string::npos)
        << unit << ": " << text.substr(std::min(text.find(unit), text.size()), 300);
  }
}

class Amperes : public testing::Test {
 protected:
  Amperes() {
    scratch_.write("joint.csv", sweep());
    const ProgramRun made = run(identified + "joint.csv -o a.html");
    EXPECT_EQ(made.status, 0) << made.err;
  }
  [[nodiscard]] ProgramRun run(const std::string& arguments) const {
    return run_shell("cd '" + scratch_.path() + "' && " + program + arguments);
  }
  [[nodiscard]] std::string text(const std::string& file) const {
    return read_text(scratch_.file(file));
  }

  const std::string identified =
      "report --no-figures --truth-runs 0 --robot R --serial S --gear-ratio 50 ";
  ScratchDirectory scratch_;
};

TEST_F(Amperes, AreTheUnitsOfTheCalibration) {
  const std::string calibration = text("a.calibration.json");
  expect_no_torques(calibration);
  std::map<std::string, std::string> units;
  const json read = json::parse(calibration);
  for (const json& q : read["verdict"]["quantities"]) {
    if (q["unit"].is_string()) units[q["key"]] = q["unit"];
  }
  EXPECT_EQ(units, (std::map<std::string, std::string>{{"cog_angle", "rad"},
                                                       {"gravity_torque", "A"},
                                                       {"surrogate_mass", "kg"},
                                                       {"break_away_torque", "A"},
                                                       {"bristle_stiffness", "A/rad"},
                                                       {"bristle_damping", "A·s/rad"},
                                                       {"inertia", "A·s²/rad"},
                                                       {"coulomb_torque", "A"},
                                                       {"stribeck_speed", "rad/s"},
                                                       {"viscous_coefficient", "A·s/rad"}}));
  for (const json& conversion : read["conversions"]) {
    for (const json& step : conversion["steps"]) EXPECT_NE(step["reason"], "torque_constant");
    if (conversion["signal"] != "effort") continue;
    EXPECT_EQ(conversion["si_unit"], "A");
  }
}

TEST_F(Amperes, AreShownAndExportedAsSuch) {
  const ProgramRun shown = run("show a.calibration.json");
  EXPECT_NE(shown.out.find(" A "), std::string::npos) << shown.out;
  expect_no_torques(shown.out);
  expect_no_torques(text("a.html"));
  const std::map<std::string, std::string> found{{"csv", ",A,joint,"},
                                                 {"latex", " & A & joint"},
                                                 {"json", "\"unit\": \"A\""},
                                                 {"mat", "gravity_torque_motor_unit"},
                                                 {"dcc", "<si:unit>\\ampere</si:unit>"}};
  for (const auto& [format, words] : found) {
    const std::string call = "export a.calibration.json --format " + format + " -o out";
    const ProgramRun made = run(call);
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_NE(text("out").find(words), std::string::npos) << format;
    expect_no_torques(text("out"));
  }
}

TEST_F(Amperes, AreForNoSimulator) {
  for (const char* const format : {"urdf", "sdf", "mjcf", "modelica", "ros2"}) {
    for (const char* const also : {"", " --doubtful-too"}) {
      const ProgramRun refused =
          run(fmt::format("export a.calibration.json --format {}{} -o out", format, also));
      EXPECT_EQ(refused.status, 2) << format;
      EXPECT_NE(refused.err.find("the torques are in amperes"), std::string::npos) << refused.err;
      EXPECT_NE(refused.err.find("--torque-constant NM_PER_A"), std::string::npos) << refused.err;
    }
  }
}

// The same joint, once its torque constant is known.
TEST_F(Amperes, AreNotHeldAgainstNewtonMetres) {
  ASSERT_EQ(run(identified + "joint.csv --torque-constant 2 -o b.html").status, 0);
  std::string ids;
  for (const char* const one : {"a", "b"}) {
    const ProgramRun added = run(fmt::format("archive add {}.calibration.json --archive k", one));
    ASSERT_EQ(added.status, 0) << added.err;
  }
  const json listed = json::parse(run("archive list --json --archive k").out);
  for (const json& one : listed["calibrations"]) {
    ids += one["id"].get<std::string>().substr(0, 10) + " ";
  }
  const ProgramRun diff = run("archive diff " + ids + "--json --archive k");
  ASSERT_EQ(diff.status, 0) << diff.err;
  ASSERT_EQ(run("archive diff " + ids + "-o diff.html --archive k").status, 0);
  bool has_gravity = false;
  const json compared = json::parse(diff.out);
  for (const json& q : compared["quantities"]) {
    if (q["name"] != "gravity_torque") continue;
    has_gravity = true;
    EXPECT_EQ(q["word"], "not comparable");
    EXPECT_NE(q["why_not"].dump().find("the units differ"), std::string::npos) << q;
  }
  EXPECT_TRUE(has_gravity) << diff.out;
  EXPECT_NE(text("diff.html").find("cannot be laid over each other"), std::string::npos);
  const json trend = json::parse(run("archive trend --json --archive k").out);
  for (const json& q : trend["joints"][0]["quantities"]) {
    if (q["name"] != "gravity_torque") continue;
    EXPECT_EQ(q["left_out"]["in another unit"], 1) << q;
  }
}

TEST_F(Amperes, AreRefusedBesideWhatIsInNewtonMetres) {
  const std::string manifest = text("a.toml");
  for (const char* const stated : {"[[limit]]\nquantity = \"coulomb_joint_Nm\"\nmax = 9\n",
                                   "[known_gravity]\namplitude_Nm = 30\nq_peak_deg = 11\n"}) {
    scratch_.write("b.toml", manifest + "\n" + stated);
    const ProgramRun refused = run("report --no-figures b.toml -o b.html");
    EXPECT_EQ(refused.status, 3) << refused.err;
    EXPECT_NE(refused.err.find("'effort.torque_constant_Nm_A': has to be known beside "),
              std::string::npos)
        << refused.err;
  }
  scratch_.write("b.toml", manifest +
                               "\n[[limit]]\nquantity = \"coulomb_joint_Nm\"\n"
                               "half_width_percent = 50\n[[limit]]\nquantity = "
                               "\"q_peak_deg\"\nmax = 30\n");
  const ProgramRun taken = run("report --no-figures --truth-runs 0 b.toml -o b.html");
  EXPECT_EQ(taken.status, 0) << taken.err;
}

TEST_F(Amperes, APageOfNoNamedRobotIsCalledAfterItsLog) {
  ASSERT_EQ(run("report --no-figures --truth-runs 0 joint.csv -o c.html").status, 0);
  const std::string page = text("c.html");
  EXPECT_NE(page.find("<h1><bdi>joint.csv</bdi></h1>"), std::string::npos)
      << page.substr(std::min(page.find("<h1"), page.size()), 200);
  EXPECT_EQ(page.substr(0, page.find("<script")).find("unnamed robot"), std::string::npos);
  EXPECT_NE(text("a.html").find("<h1><bdi>R</bdi></h1>"), std::string::npos)
      << "the joint has no name";
}

// UR's controllers log the current and, with gravity taken off, their own torque of it.
TEST(ATorqueConstant, MeansTheCurrentOfALogThatHasATorqueToo) {
  const ScratchDirectory scratch;
  std::string csv = "timestamp,actual_q_2,actual_current_2,actual_current_as_torque_2\n";
  for (int i = 0; i <= 400; ++i) {
    const double q = i <= 200 ? -1 + 0.01 * i : 3 - 0.01 * i;
    const double friction = i <= 200 ? 4.0 : -4.0;
    csv += fmt::format("{:.3f},{:.6f},{:.5f},{:.5f}\n", 0.2 * i, q,
                       3 * std::cos(q - 0.2) + 0.1 * friction, friction);
  }
  const std::string log = scratch.write("ur.csv", csv);
  const auto proposed = [&](const std::string& options) {
    const std::string to = scratch.file("m.toml");
    const ProgramRun made =
        run_shell(program + "init '" + log + "' " + options + " --force -o '" + to + "'");
    EXPECT_EQ(made.status, 0) << made.err;
    return read_text(to);
  };
  const std::string torque = "effort = { name = \"actual_current_as_torque_2\", unit = \"Nm\"";
  const std::string current = "effort = { name = \"actual_current_2\", unit = \"A\"";
  const std::string constant = "--gear-ratio 101 --torque-constant 0.1 ";
  for (const auto& [options, column] : std::map<std::string, std::string>{
           {"--gear-ratio 101", torque},
           {constant, current},
           {constant + "--effort-kind motor_current", current},
           {constant + "--effort-kind joint_torque", torque},
           {constant + "--column effort=actual_current_as_torque_2", torque}}) {
    const std::string manifest = proposed(options);
    EXPECT_NE(manifest.find(column), std::string::npos) << options << "\n" << manifest;
    EXPECT_TRUE(column == torque || manifest.find("gravity_removed") == std::string::npos);
  }
}

}  // namespace
}  // namespace tribolog::test::amperes_test
