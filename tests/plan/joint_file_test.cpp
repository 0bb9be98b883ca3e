// The file of a joint to be measured.

#include "ingest/manifest/joint_file.h"

#include <cstddef>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/requirements.h"
#include "base/temporary_directory.h"
#include "exports/experiment/plan_files.h"
#include "joint/degrees.h"
#include "plan/experiment_plan.h"
#include "plan/paper_facts.h"

namespace tribolog::test::joint_file_test {
namespace {

constexpr const char* smallest = R"(schema = "tribolog-joint-1"
[robot]
name = "arm"
[joint]
name = "J1"
gear_ratio = 50
lowest_deg = -90
highest_deg = 90
speed_limit_deg_s = 100
acceleration_limit_deg_s2 = 500
joint_torque_limit_Nm = 200
)";

std::string refusal(const std::string& text) {
  return refusal_of<InputError>([&] { return ingest::manifest::parse_joint(text, "j.toml"); });
}

std::string with(const std::string& piece, const std::string& other) {
  std::string text = smallest;
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) throw std::logic_error("no such piece: " + piece);
  return text.replace(at, piece.size(), other);
}

TEST(JointFile, LimitsAreTakenToRadiansAndTheMotor) {
  const joint::JointFacts f = ingest::manifest::parse_joint(smallest, "j.toml");
  EXPECT_NEAR(f.lowest_rad, -1.5707963, 1e-7);
  EXPECT_NEAR(f.speed_limit_rad_s, 1.7453293, 1e-7);
  EXPECT_NEAR(f.acceleration_limit_rad_s2, 8.7266463, 1e-7);
  EXPECT_DOUBLE_EQ(f.torque_limit_Nm, 4);
  EXPECT_FALSE(f.q_peak_rad);
  EXPECT_TRUE(f.ripple_periods_per_turn.empty());
}

TEST(JointFile, TheExampleStatesThePapersJoint) {
  const joint::JointFacts f = paper_facts();
  EXPECT_NEAR(*f.gravity_Nm, 3.88318571, 1e-12);
  EXPECT_NEAR(*f.q_peak_rad, -0.388019, 1e-6);
  EXPECT_NEAR(*f.inertia_kgm2, 1e-4 + 15.83358e-4, 1e-12);
  EXPECT_EQ(f.ripple_periods_per_turn, (std::vector<double>{1, 6}));
}

TEST(JointFile, RipplePeriodsFollowFromTheBuild) {
  const std::string build = "[ripple]\npole_pairs = 4\nwave_generator = true\n";
  EXPECT_EQ(ingest::manifest::parse_joint(smallest + build, "j.toml").ripple_periods_per_turn,
            (std::vector<double>{1, 2, 4, 8, 24}));
}

TEST(JointFile, RefusalsNameThePlace) {
  EXPECT_EQ(refusal(with("highest_deg = 90", "highest_deg = -95")),
            "j.toml:8:15: key 'joint.highest_deg': highest angle −95 deg is not above the lowest, "
            "−90 deg");
  EXPECT_NE(refusal(with("joint_torque_limit_Nm = 200", "")).find("motor_torque_limit_Nm"),
            std::string::npos);
  EXPECT_NE(refusal(with("speed_limit_deg_s = 100", "speed_limit_deg_s = 0")).find("j.toml:9:"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(smallest) + "[gravity]\nq_peek_deg = 3\n").find("q_peak_deg"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(smallest) + "[friction]\nstatic_Nm = 1\ncoulomb_Nm = 2\n")
                .find("Coulomb torque 2 N·m exceeds static torque 1 N·m"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(smallest) + "motor_inertia_kgm2 = 1e-4\n").find("is given alone"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(smallest) + "motor_torque_limit_Nm = 4\n").find("too"),
            std::string::npos);
}

constexpr const char* calibration = R"({"schema": "tribolog-calibration-1",
 "drive": {"gear_ratio": 50},
 "cog": {"q_peak_rad": {"estimate": 0.25}, "rough": {"gravity_Nm": {"estimate": 1.5}}},
 "ripple": {"lines": [{"periods_per_turn": 2, "amplitude_Nm": 0.1}]},
 "friction": {"waiboer": {"stribeck_speed_rad_s": {"motor": {"estimate": 7}},
                          "asperity_torque_Nm": {"motor": {"estimate": 0.3}}}, "lugre": null}})";

TEST(JointCalibration, AddsWhatWasIdentified) {
  const joint::JointFacts f = ingest::manifest::with_calibration(
      ingest::manifest::parse_joint(smallest, "j.toml"), calibration, "c.json");
  EXPECT_EQ(f.q_peak_rad, 0.25);
  EXPECT_EQ(f.gravity_Nm, 1.5);
  EXPECT_EQ(f.stribeck_speed_rad_s, 7);
  EXPECT_EQ(f.static_Nm, 0.3);
  EXPECT_FALSE(f.bristle_stiffness_Nm_rad);
  EXPECT_EQ(f.ripple_periods_per_turn, std::vector<double>{2});
  EXPECT_EQ(f.identified.count("q_peak_rad"), 1U);
}

TEST(JointCalibration, StatedFrictionWins) {
  const joint::JointFacts f = ingest::manifest::with_calibration(
      ingest::manifest::parse_joint(std::string(smallest) + "[friction]\nstatic_Nm = 0.5\n",
                                    "j.toml"),
      calibration, "c.json");
  EXPECT_EQ(f.static_Nm, 0.5);
  EXPECT_EQ(f.identified.count("static_Nm"), 0U);
}

TEST(JointCalibration, RefusesWhatIsNone) {
  const joint::JointFacts f = ingest::manifest::parse_joint(smallest, "j.toml");
  const auto refused = [&](const std::string& text) {
    return refusal_of<InputError>(
        [&] { return ingest::manifest::with_calibration(f, text, "c.json"); });
  };
  EXPECT_NE(refused("{}").find("c.json: is no calibration"), std::string::npos);
  EXPECT_NE(refused("{").find("c.json:1:"), std::string::npos);
  std::string other = calibration;
  other.replace(other.find("50"), 2, "60");
  EXPECT_NE(refused(other).find("another gear ratio, found 60, expected 50"), std::string::npos);
}

constexpr const char* recorded = R"({"schema": "tribolog-calibration-1",
 "robot": {"name": "R", "serial": "7", "joint": "2"},
 "drive": {"gear_ratio": 50, "effort_kind": "motor_current", "effort_side": "motor",
           "torque_constant_Nm_A": 0.1, "torque_is_in_amperes": false},
 "speeds": [{"window_samples": 20, "window_s": 0.04}],
 "cog": {"q_peak_rad": {"estimate": 0.25},
         "rough": {"lowest_rad": -1, "highest_rad": 0.5, "argmax_torque_Nm": 1.8,
                   "gravity_Nm": {"estimate": 1.5}}, "precise": {}},
 "viscous": {"runs": [{"speed_rad_s": -90, "torque_Nm": -2, "lowest_rad": -0.4,
                       "highest_rad": 0.7}]},
 "friction_at_speed": [{"speed_rad_s": 0.5}, {"speed_rad_s": 100}],
 "friction": {"waiboer": null, "lugre": null}})";

TEST(RecordedJoint, HasTheLimitsThatItsRecordingsShow) {
  const joint::JointFacts f = ingest::manifest::recorded_joint(recorded, "c.json");
  EXPECT_EQ(f.robot, "R");
  EXPECT_EQ(f.joint, "2");
  constexpr double digits = 0.005;  // rounded to three
  EXPECT_NEAR(f.lowest_rad, -1, digits);
  EXPECT_NEAR(f.highest_rad, 0.7, digits);
  EXPECT_NEAR(f.speed_limit_rad_s, 100.0 / 50, 2 * digits);
  EXPECT_NEAR(f.acceleration_limit_rad_s2, 100.0 / 50 / 0.2, 10 * digits);
  EXPECT_NEAR(f.torque_limit_Nm, 1.3 * 2, digits);
  EXPECT_EQ(f.sample_rate_Hz, 500);
  EXPECT_EQ(f.effort_kind, joint::EffortKind::motor_current);
  EXPECT_EQ(f.torque_constant_Nm_A, 0.1);
  EXPECT_EQ(f.gravity_Nm, 1.5);
  EXPECT_EQ(f.q_peak_rad, 0.25);
}

TEST(RecordedJoint, ComesBackFromItsFile) {
  const joint::JointFacts f = ingest::manifest::recorded_joint(recorded, "c.json");
  const joint::JointFacts read =
      ingest::manifest::parse_joint(exports::experiment::joint_toml(f), "joint.toml");
  EXPECT_EQ(read.robot, f.robot);
  EXPECT_EQ(read.serial, f.serial);
  EXPECT_NEAR(read.lowest_rad, f.lowest_rad, 1e-6);
  EXPECT_NEAR(read.highest_rad, f.highest_rad, 1e-6);
  EXPECT_NEAR(read.speed_limit_rad_s, f.speed_limit_rad_s, 1e-5);
  EXPECT_NEAR(read.torque_limit_Nm, f.torque_limit_Nm, 1e-5);
  EXPECT_EQ(read.sample_rate_Hz, f.sample_rate_Hz);
  EXPECT_EQ(read.gravity_Nm, f.gravity_Nm);
  EXPECT_NEAR(present(read.q_peak_rad), 0.25, 1e-5);
  EXPECT_EQ(read.effort_kind, f.effort_kind);
  EXPECT_EQ(read.torque_constant_Nm_A, f.torque_constant_Nm_A);
  EXPECT_NEAR(plan::plan_experiment(read).duration_s(), plan::plan_experiment(f).duration_s(), 0.1);
}

TEST(RecordedJoint, GoesRoundNoMoreThanOnce) {
  std::string text = recorded;
  text.replace(text.find("0.7"), 3, "80.0");
  const joint::JointFacts f = ingest::manifest::recorded_joint(text, "c.json");
  EXPECT_NEAR(f.highest_rad - f.lowest_rad, 2 * std::numbers::pi, 0.02);
}

TEST(RecordedJoint, RefusesWhatShowsNoLimits) {
  const auto refused = [](const std::string& what, const std::string& by) {
    std::string text = recorded;
    text.replace(text.find(what), what.size(), by);
    return refusal_of<InputError>([&] { return ingest::manifest::recorded_joint(text, "c.json"); });
  };
  EXPECT_NE(refused("\"torque_is_in_amperes\": false", "\"torque_is_in_amperes\": true")
                .find("its torques are in ampere"),
            std::string::npos);
  const std::string nothing = R"({"schema": "tribolog-calibration-1"})";
  EXPECT_NE(refusal_of<InputError>([&] {
              return ingest::manifest::recorded_joint(nothing, "c.json");
            }).find("neither a sweep nor a run"),
            std::string::npos);
}

}  // namespace
}  // namespace tribolog::test::joint_file_test
