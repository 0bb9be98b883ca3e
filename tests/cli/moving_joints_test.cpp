// A joint is recorded while another one of the robot moves: with the masses of the arm its numbers
// come back to the truth, and without them they are doubtful, and the other joint is named.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"

namespace tribolog::test::moving_joints_test {
namespace {

using nlohmann::json;

constexpr double g = 9.80665;
constexpr double gear_ratio = 100;
constexpr double peak_rad = 10 * std::numbers::pi / 180;
constexpr double mass_kg = 6;
constexpr double centre_m = 0.3;
constexpr double held_rad = 0.8986;  // the second joint's mean over the sweep

const std::string scenario = R"(schema = "tribolog-scenario-1"
name = "one joint"
[robot]
name = "arm"
[friction]
model = "lugre"
[friction.sliding]
model = "dynamic"
[noise]
torque_white_Nm = 0.002
[[joints]]
name = "J1"
gear_ratio = 100
motor_inertia_kgm2 = 1e-4
arm_inertia_kgm2 = 0.5
[joints.load]
mass_kg = 12
distance_m = 0.2
q_peak_deg = 10
[joints.friction.presliding]
bristle_stiffness_Nm_rad = 100
bristle_damping_Nms_rad = 0.1
viscous_Nms_rad = 1e-3
coulomb_Nm = 0.1
static_Nm = 0.15
stribeck_speed_rad_s = 5
[joints.rough_sweep]
from_deg = -40
to_deg = 55
speed_deg_s = 5
sample_rate_Hz = 100
[joints.oscillation]
centre_deg = 10
amplitude_rad = 0.00008
frequency_Hz = 1
cycles = 6
sample_rate_Hz = 200
record_bristle = false
[joints.constant_speed]
motor_speeds_rad_s = [2, 6, 15, 40]
centre_deg = 10
largest_travel_deg = 50
longest_plateau_s = 2
acceleration_rad_s2 = 15
sample_rate_Hz = 100
)";

/// With the second link held as it is in the sweep, gravity by it is that of the simulated load.
/// @param share of the second link's mass that the description states. @param zero_rad added to the
///        first joint's zero.
std::string urdf(double share, double zero_rad = 0) {
  constexpr double upper_kg = 9;
  const double level_m =
      (12 * 0.2 * 9.81 / g - mass_kg * (0.5 + centre_m * std::cos(held_rad))) / upper_kg;
  const double upright_m = -mass_kg * centre_m * std::sin(held_rad) / upper_kg;
  return fmt::format(R"(<robot name="arm"><link name="base"/>
  <link name="upper"><inertial><origin xyz="{} 0 {}"/><mass value="{}"/></inertial></link>
  <link name="fore"><inertial><origin xyz="{} 0 0"/><mass value="{}"/></inertial></link>
  <joint name="J1" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0 0 0.4" rpy="0 {} 0"/><axis xyz="0 -1 0"/></joint>
  <joint name="J2" type="revolute"><parent link="upper"/><child link="fore"/>
    <origin xyz="0.5 0 0"/><axis xyz="0 -1 0"/></joint></robot>)",
                     level_m, upright_m, upper_kg, centre_m, share * mass_kg, peak_rad + zero_rad);
}

double second_at(double t_s) { return 0.9 + 0.25 * std::sin(2 * std::numbers::pi * t_s / 9.7); }

struct Row {
  double t_s{}, q1_rad{}, torque_Nm{};
};

std::vector<Row> rows_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    Row row;
    char comma = 0;
    fields >> row.t_s >> comma >> row.q1_rad >> comma >> row.torque_Nm;
    rows.push_back(row);
  }
  return rows;
}

/// The simulated joint, with a second link that swings: held at its mean over the sweep it is part
/// of the simulated load.
class MovingArm {
 public:
  MovingArm() {
    const std::string file = scratch_.write("scenario.toml", scenario);
    const ProgramRun made =
        run_shell(program + "--quiet simulate '" + file + "' -o '" + scratch_.path() + "'");
    EXPECT_EQ(made.status, 0) << made.err;
    truth_ = json::parse(read_text(scratch_.file("truth.json")))["joints"][0];
    manifest_ =
        read_text(scratch_.file("robot.toml")) +
        "[[joints.other_joint]]\nname = \"J2\"\nangle = {name = \"q2_rad\", unit = \"rad\"}\n";
    const std::vector<Row> rows = rows_of(read_text(scratch_.file("robot.csv")));
    const double from_s = std::stod(manifest_.substr(manifest_.find("from_s = ") + 9));
    const double to_s = std::stod(manifest_.substr(manifest_.find("to_s = ") + 7));
    double sum = 0;
    std::size_t count = 0;
    for (const Row& row : rows) {
      if (row.t_s < from_s || row.t_s > to_s) continue;
      sum += second_at(row.t_s);
      ++count;
    }
    const double held = sum / static_cast<double>(count);
    EXPECT_NEAR(held, held_rad, 1e-3);
    std::string csv = "t_s,q1_rad,torque1_Nm,q2_rad\n";
    for (const Row& row : rows) {
      const double q2 = second_at(row.t_s);
      const double changed_Nm =
          mass_kg * g * centre_m *
          (std::cos(row.q1_rad - peak_rad + q2) - std::cos(row.q1_rad - peak_rad + held));
      csv += fmt::format("{},{},{},{}\n", row.t_s, row.q1_rad,
                         row.torque_Nm + changed_Nm / gear_ratio, q2);
    }
    scratch_.write("robot.csv", csv);
  }

  /// @param share of the mass in the description; 0: there is none.
  [[nodiscard]] json identified(double share, double zero_rad = 0) const {
    std::string manifest = manifest_;
    if (share > 0) {
      scratch_.write("arm.urdf", urdf(share, zero_rad));
      manifest = replaced(manifest, "[robot]\n", "[robot]\ndescription = \"arm.urdf\"\n");
    }
    scratch_.write("moving.toml", manifest);
    const ProgramRun run =
        run_shell(fmt::format("{}--quiet identify '{}' --joint J1 --truth-runs 0 -o '{}'", program,
                              scratch_.file("moving.toml"), scratch_.file("c.json")));
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(read_text(scratch_.file("c.json")));
  }

  [[nodiscard]] const json& truth() const { return truth_; }

 private:
  ScratchDirectory scratch_;
  std::string manifest_;
  json truth_;
};

json quantity_in(const json& calibration, const std::string& key) {
  for (const json& q : calibration["verdict"]["quantities"]) {
    if (q["key"] == key) return q;
  }
  ADD_FAILURE() << key;
  return {};
}

void expect_in_expanded(const json& calibration, const std::string& key, double truth) {
  const json expanded = quantity_in(calibration, key)["budget"]["expanded"];
  EXPECT_LE(expanded["low"].get<double>(), truth) << key << expanded;
  EXPECT_GE(expanded["high"].get<double>(), truth) << key << expanded;
}

double uncertainty_by_description(const json& quantity) {
  for (const json& part : quantity["budget"]["parts"]) {
    if (part["influence"] == "description") return part["standard_uncertainty"];
  }
  return 0;
}

TEST(MovingJoints, ComeBackToTheTruthWithTheArmsMassesAndAreDoubtfulWithout) {
  const MovingArm arm;
  const double gravity_Nm = arm.truth()["gravity_torque_motor_Nm"];
  const json described = arm.identified(1);
  EXPECT_EQ(quantity_in(described, "gravity_torque")["verdict"], "usable");
  expect_in_expanded(described, "gravity_torque", gravity_Nm);
  expect_in_expanded(described, "cog_angle", peak_rad);
  const double by_masses = uncertainty_by_description(quantity_in(described, "gravity_torque"));
  EXPECT_GT(by_masses, 0);
  EXPECT_EQ(described["arm_gravity"]["matched_by"], "name");
  EXPECT_NEAR(described["arm_gravity"]["largest_joint_Nm"].get<double>(),
              mass_kg * g * centre_m * 0.25, 1);

  // Masses that are wrong by less than is stated: the numbers are off, and the interval holds them.
  const json off = arm.identified(1.08);
  expect_in_expanded(off, "gravity_torque", gravity_Nm);
  expect_in_expanded(off, "cog_angle", peak_rad);
  // What is stated is what the ends of the stated range of masses make of it.
  const auto angle_by = [&](double share) {
    return quantity_in(arm.identified(share), "cog_angle")["estimate"]["estimate"].get<double>();
  };
  const double angle = angle_by(1);
  const double largest = std::max(std::abs(angle_by(0.9) - angle), std::abs(angle_by(1.1) - angle));
  constexpr double coverage = 1.959964;
  EXPECT_GT(largest, 0.003);
  EXPECT_NEAR(coverage * uncertainty_by_description(quantity_in(described, "cog_angle")), largest,
              1e-4 * largest);

  // A description with another zero is told by the gravity that it gives the joint.
  const json turned = quantity_in(arm.identified(1, 0.4), "gravity_torque");
  EXPECT_NE(turned["verdict"], "usable");
  EXPECT_NE(turned["reasons"].dump().find("from the same zero"), std::string::npos);

  const json alone = arm.identified(0);
  for (const char* const key : {"gravity_torque", "cog_angle", "coulomb_torque"}) {
    const json q = quantity_in(alone, key);
    EXPECT_NE(q["verdict"], "usable") << key;
    // Friction turns with the direction: the model has a part for what J2's motion changes.
    if (std::string(key) == "coulomb_torque") continue;
    EXPECT_NE(q["reasons"].dump().find("joint 'J2' moves by 28"), std::string::npos)
        << q["reasons"];
  }
  EXPECT_EQ(uncertainty_by_description(quantity_in(alone, "gravity_torque")), 0);
}

}  // namespace
}  // namespace tribolog::test::moving_joints_test
