// The exported numbers, run where they are used, give the friction that was identified: 200 joints
// drawn at random, no unit, side or sign astray.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "exports/random_joint.h"
#include "exports/results/calibration_exports.h"
#include "support/run_program.h"

#ifdef TRIBOLOG_URDFDOM
#include <urdf_parser/urdf_parser.h>
#endif
#ifdef TRIBOLOG_SDFORMAT
#include <sdf/sdf.hh>
#endif

namespace tribolog::exports::results::round_trip_test {
namespace {

constexpr int joints = 200;

struct Sample {
  test::KnownFriction law;
  ArchivedJoint joint;
};

std::vector<Sample> samples(bool has_limits) {
  std::mt19937_64 random(7);
  std::vector<Sample> all;
  for (int k = 0; k < joints; ++k) {
    const test::KnownFriction law = test::random_friction(random);
    all.push_back({law, test::joint_of(law, has_limits)});
    all.back().joint.entry.facts.of.joint = fmt::format("J{}", k);
  }
  return all;
}

/// Of a target that knows dry friction and a coefficient: the largest error at the speeds.
double largest_error_Nm(const Sample& sample, double dry_Nm, double viscous_Nms_rad) {
  std::string why_not;
  double largest = 0;
  for (const SpeedFriction& f : usable_friction(sample.joint, {}, why_not)) {
    EXPECT_NEAR(f.torque_Nm, sample.law.joint_Nm(f.speed_rad_s), 1e-9 * f.torque_Nm);
    largest = std::max(largest, std::abs(dry_Nm + viscous_Nms_rad * f.speed_rad_s - f.torque_Nm));
  }
  return largest;
}

/// The smallest largest error of any line, by trying slopes: half the spread of what is left.
double least_error_Nm(const Sample& sample) {
  std::string why_not;
  const std::vector<SpeedFriction> friction = usable_friction(sample.joint, {}, why_not);
  const double n = sample.law.gear_ratio;
  double least = std::numeric_limits<double>::infinity();
  constexpr int tried = 4000;
  for (int k = 0; k <= tried; ++k) {
    const double slope = 1.2 * k / tried * sample.law.viscous_Nms_rad * n * n;
    double low = least;
    double high = -low;
    for (const SpeedFriction& f : friction) {
      low = std::min(low, f.torque_Nm - slope * f.speed_rad_s);
      high = std::max(high, f.torque_Nm - slope * f.speed_rad_s);
    }
    least = std::min(least, (high - low) / 2);
  }
  return least;
}

TEST(RoundTrip, NoLineIsNearerToTheFriction) {
  for (const Sample& sample : samples(false)) {
    const DryAndViscous line = dry_and_viscous(sample.joint, {}, "friction", "damping");
    EXPECT_TRUE(line.is_approximation);
    const double error_Nm = largest_error_Nm(sample, line.dry_Nm, line.viscous_Nms_rad);
    EXPECT_LE(error_Nm, least_error_Nm(sample) * (1 + 1e-6));
    EXPECT_NE(
        line.comments.back().find(fmt::format("the largest error there is {:.3g} N·m (", error_Nm)),
        std::string::npos)
        << line.comments.back();
    EXPECT_GE(line.static_Nm, sample.law.joint_Nm(0) * (1 - 1e-12));
  }
}

// Where both are usable they are handed on as they are, with what they miss beside them.
TEST(RoundTrip, LimitsThatAreUsableAreKept) {
  for (const Sample& sample : samples(true)) {
    const DryAndViscous line = dry_and_viscous(sample.joint, {}, "friction", "damping");
    const double n = sample.law.gear_ratio;
    EXPECT_FALSE(line.is_approximation);
    EXPECT_DOUBLE_EQ(line.dry_Nm, sample.law.coulomb_Nm * n);
    EXPECT_DOUBLE_EQ(line.viscous_Nms_rad, sample.law.viscous_Nms_rad * n * n);
  }
}

// A stated range is answered by the line nearest there, and a joint that barely slipped by what
// holds.
TEST(RoundTrip, ARangeWithoutTheDipHasASmallerError) {
  for (const Sample& sample : samples(false)) {
    SimulatorOptions fast;
    fast.range_rad_s = {100 / sample.law.gear_ratio, 300 / sample.law.gear_ratio};
    const DryAndViscous line = dry_and_viscous(sample.joint, fast, "friction", "damping");
    for (const double motor_rad_s : {100.0, 200.0, 300.0}) {
      const double joint_rad_s = motor_rad_s / sample.law.gear_ratio;
      EXPECT_NEAR(line.torque_Nm(joint_rad_s), sample.law.joint_Nm(joint_rad_s),
                  0.01 * sample.law.joint_Nm(joint_rad_s));
    }
    EXPECT_LE(line.dry_Nm, sample.law.joint_Nm(0));
    fast.range_rad_s = {400.0, 500.0};
    EXPECT_NE(test::refusal_of<UsageError>([&] {
                return urdf_joint(sample.joint, fast);
              }).find("no friction was measured within --range"),
              std::string::npos);
  }
}

#ifdef TRIBOLOG_URDFDOM
TEST(RoundTrip, Urdfdom) {
  for (const Sample& sample : samples(false)) {
    const DryAndViscous line = dry_and_viscous(sample.joint, {}, "friction", "damping");
    const auto model = urdf::parseURDF(urdf_joint(sample.joint, {}));
    ASSERT_TRUE(model);
    const auto& dynamics = model->joints_.begin()->second->dynamics;
    ASSERT_TRUE(dynamics);
    EXPECT_DOUBLE_EQ(dynamics->friction, line.dry_Nm);
    EXPECT_DOUBLE_EQ(dynamics->damping, line.viscous_Nms_rad);
  }
}
#endif

#ifdef TRIBOLOG_SDFORMAT
TEST(RoundTrip, Sdformat) {
  constexpr std::size_t every = 5;  // its parser takes a fifth of a second
  const std::vector<Sample> all = samples(false);
  for (std::size_t k = 0; k < all.size(); k += every) {
    const Sample& sample = all[k];
    const DryAndViscous line = dry_and_viscous(sample.joint, {}, "friction", "damping");
    sdf::Root root;
    EXPECT_TRUE(root.LoadSdfString(sdf_joint(sample.joint, {})).empty());
    ASSERT_NE(root.Model(), nullptr);
    const sdf::JointAxis* axis = root.Model()->JointByIndex(0)->Axis(0);
    EXPECT_NEAR(axis->Friction(), line.dry_Nm, 1e-12 * line.dry_Nm);
    EXPECT_NEAR(axis->Damping(), line.viscous_Nms_rad, 1e-12 * line.viscous_Nms_rad);
  }
}
#endif

/// What a program prints: of each joint a line for each speed of both directions.
void expect_friction(const std::vector<Sample>& all, const std::vector<double>& speeds_of_motor,
                     const std::string& printed, double float_error) {
  std::istringstream lines(printed);
  std::size_t count = 0;
  double largest = 0;
  for (const Sample& sample : all) {
    for (const double motor_rad_s : speeds_of_motor) {
      double torque_Nm = 0;
      ASSERT_TRUE(lines >> torque_Nm) << count;
      ++count;
      const double joint_rad_s = motor_rad_s / sample.law.gear_ratio;
      const double sign = motor_rad_s < 0 ? -1 : 1;
      const double wanted_Nm =
          motor_rad_s == 0 ? 0 : sign * sample.law.joint_Nm(std::abs(joint_rad_s));
      // Between 32 of 40 speeds the curve bends: the header states how much that adds.
      EXPECT_NEAR(torque_Nm, wanted_Nm, (0.01 + float_error) * std::abs(wanted_Nm)) << motor_rad_s;
      largest = std::max(largest, wanted_Nm == 0 ? 0 : std::abs(torque_Nm / wanted_Nm - 1));
    }
  }
  EXPECT_EQ(count, all.size() * speeds_of_motor.size());
  ::testing::Test::RecordProperty("largest_deviation_percent", std::to_string(100 * largest));
}

const std::vector<double> tried_speeds{-300, -40, -3, -0.5, 0, 0.5, 0.7, 3, 40, 170, 300};

TEST(RoundTrip, ACompilerOfC) {
  const std::vector<Sample> all = samples(false);
  const test::ScratchDirectory directory;
  std::string program = "#include <stdio.h>\n";
  std::string calls;
  for (std::size_t k = 0; k < all.size(); ++k) {
    directory.write(fmt::format("j{}.h", k), c_header(all[k].joint, {}));
    program += fmt::format("#include \"j{}.h\"\n", k);
    for (const double motor_rad_s : tried_speeds) {
      calls += fmt::format("  printf(\"%.9g\\n\", j{}_friction_Nm((float)({:.17g})));\n", k,
                           motor_rad_s / all[k].law.gear_ratio);
    }
  }
  directory.write("a.c", program + "int main(void) {\n" + calls + "  return 0;\n}\n");
  const test::ProgramRun compiled = test::run_shell(fmt::format(
      "cd {} && cc -std=c99 -Wall -Wextra -Werror -pedantic -Wno-unused-variable a.c -o a",
      directory.path()));
  ASSERT_EQ(compiled.status, 0) << compiled.err;
  expect_friction(all, tried_speeds, test::run_shell(directory.file("a")).out, 1e-5);
}

TEST(RoundTrip, Python) {
  const std::vector<Sample> all = samples(false);
  const test::ScratchDirectory directory;
  std::string program = "import importlib\n";
  for (std::size_t k = 0; k < all.size(); ++k) {
    directory.write(fmt::format("j{}.py", k), python_module(all[k].joint, {}));
    program += fmt::format("m = importlib.import_module('j{}')\n", k);
    for (const double motor_rad_s : tried_speeds) {
      program +=
          fmt::format("print(repr(m.friction_Nm({:.17g})))\n", motor_rad_s / all[k].law.gear_ratio);
    }
  }
  directory.write("a.py", program);
  const test::ProgramRun run =
      test::run_shell(fmt::format("cd {} && python3 -B a.py", directory.path()));
  ASSERT_EQ(run.status, 0) << run.err;
  expect_friction(all, tried_speeds, run.out, 1e-12);
}

// Isaac Lab's arguments as Python has them, USD's viscous coefficient for degrees, bam's JSON.
TEST(RoundTrip, IsaacUsdAndBamHaveTheSameLine) {
  SimulatorOptions options;
  options.doubtful_too = true;
  for (const Sample& sample : samples(true)) {
    const DryAndViscous line = dry_and_viscous(sample.joint, options, "a", "b");
    const auto number_behind = [](const std::string& text, const std::string& name) {
      const std::size_t at = text.rfind(name);
      EXPECT_NE(at, std::string::npos) << name << " in\n" << text;
      return std::stod(text.substr(at + name.size()));
    };
    const std::string isaac = isaac_lab_config(sample.joint, options);
    EXPECT_DOUBLE_EQ(number_behind(isaac, "    friction="), line.static_Nm);
    EXPECT_DOUBLE_EQ(number_behind(isaac, "    dynamic_friction="), line.dry_Nm);
    EXPECT_DOUBLE_EQ(number_behind(isaac, "    viscous_friction="), line.viscous_Nms_rad);
    const std::string usd = usd_joint(sample.joint, options);
    EXPECT_DOUBLE_EQ(number_behind(usd, "staticFrictionEffort = "), line.static_Nm);
    EXPECT_DOUBLE_EQ(number_behind(usd, "dynamicFrictionEffort = "), line.dry_Nm);
    EXPECT_NEAR(number_behind(usd, "viscousFrictionCoefficient = ") * 180 / std::acos(-1.0),
                line.viscous_Nms_rad, 1e-12 * line.viscous_Nms_rad);
    const auto bam = nlohmann::json::parse(bam_parameters(sample.joint, options));
    EXPECT_EQ(bam.at("friction_base"), line.dry_Nm);
    EXPECT_EQ(bam.at("friction_viscous"), line.viscous_Nms_rad);
  }
}

TEST(RoundTrip, TheTableForFeedForwardIsOdd) {
  for (const Sample& sample : samples(false)) {
    std::istringstream lines(feed_forward_table(sample.joint, {}));
    std::string line;
    std::vector<std::array<double, 4>> rows;
    while (std::getline(lines, line)) {
      if (line.starts_with("#") || line.starts_with("speed")) continue;
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream cells(line);
      std::array<double, 4> row{};
      for (double& cell : row) cells >> cell;
      rows.push_back(row);
    }
    ASSERT_EQ(rows.size(), 80U);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto& [speed, torque, low, high] = rows[k];
      EXPECT_NEAR(torque, std::copysign(sample.law.joint_Nm(std::abs(speed)), speed),
                  1e-9 * std::abs(torque));
      EXPECT_LT(low, torque);
      EXPECT_LT(torque, high);
      EXPECT_EQ(torque, -rows[rows.size() - 1 - k][1]);
    }
  }
}

// No text of anybody's leaves its comment, and every name is one that the language takes.
TEST(RoundTrip, HostileTextsStayInTheirComments) {
  const test::ScratchDirectory directory;
  ArchivedJoint joint = test::hostile_export_sample();
  directory.write("a.h", c_header(joint, {}));
  directory.write("a.c", "#include \"a.h\"\nint main(void) { return 0; }\n");
  directory.write("a.py", python_module(joint, {}) + isaac_lab_config(joint, {}));
  const test::ProgramRun c =
      test::run_shell("cd " + directory.path() + " && cc -std=c99 -Wno-unused a.c -o a");
  EXPECT_EQ(c.status, 0) << c.err;
  const test::ProgramRun python = test::run_shell("cd " + directory.path() + " && python3 -B a.py");
  EXPECT_EQ(python.status, 0) << python.err;
  for (const std::string& text : {simscape_script(joint, {}), usd_joint(joint, {})}) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const bool is_comment = line.starts_with("%") || line.starts_with("#");
      EXPECT_TRUE(is_comment || line.find("Evil") == std::string::npos) << line;
    }
  }
}

}  // namespace
}  // namespace tribolog::exports::results::round_trip_test
