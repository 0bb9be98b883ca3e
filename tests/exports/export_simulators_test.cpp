// Formats of simulators: what is refused, and Modelica by its grammar. URDF and MJCF are loaded by
// their own parsers in export_parsers_test.cpp.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "exports/export_sample.h"
#include "exports/results/calibration_exports.h"
#include "exports/results/simulator_numbers.h"

namespace tribolog::archive::export_simulators_test {
namespace {

using test::export_sample;
using test::hostile_export_sample;
using test::quantity_of;
using test::refusal_of;

TEST(ExportForSimulators, RefusesWhatIsNotUsableAndSaysWhy) {
  exports::results::ArchivedJoint joint = test::export_sample();
  joint.calibration = "{}";  // without friction at speeds, to which a line could be laid
  test::quantity_of(joint, "coulomb_torque").verdict = calibration::Verdict::doubtful;
  for (auto* const make :
       {exports::results::urdf_joint, exports::results::sdf_joint, exports::results::mjcf_joint}) {
    const std::string refusal = test::refusal_of<UsageError>([&] { return make(joint, {}); });
    EXPECT_EQ(refusal,
              "aaaaaaaaaa: not exported: Coulomb torque of 0.31 N·m (95 %: 0.3 to 0.32) is "
              "doubtful; --doubtful-too exports it all the same; the calibration holds no friction "
              "at speeds");
    exports::results::SimulatorOptions options;
    options.doubtful_too = true;
    EXPECT_NE(make(joint, options).find("(95 %: 15 to 16), doubtful; archived × n"),
              std::string::npos);
    // What is not there, and what no simulator takes, cannot be asked for.
    exports::results::ArchivedJoint none = test::export_sample();
    none.calibration = "{}";
    test::quantity_of(none, "viscous_coefficient").estimate.reset();
    EXPECT_NE(test::refusal_of<UsageError>([&] {
                return make(none, options);
              }).find("Viscous coefficient was not identified"),
              std::string::npos);
    exports::results::ArchivedJoint negative = test::export_sample();
    negative.calibration = "{}";
    test::quantity_of(negative, "viscous_coefficient").estimate =
        statistics::Estimate{-1, -2, 0.1, {}};
    EXPECT_NE(
        test::refusal_of<UsageError>([&] { return make(negative, options); }).find("is below zero"),
        std::string::npos);
  }
}

// A simulator takes each number for one of newton metres: whatever the options, none of amperes.
TEST(ExportForSimulators, RefuseAmperes) {
  const exports::results::ArchivedJoint joint = test::ampere_sample();
  for (auto* const make :
       {exports::results::urdf_joint, exports::results::sdf_joint, exports::results::mjcf_joint,
        exports::results::ros2_parameters, exports::results::modelica_friction,
        exports::results::c_header, exports::results::python_module,
        exports::results::simscape_script, exports::results::isaac_lab_config,
        exports::results::usd_joint, exports::results::feed_forward_table,
        exports::results::bam_parameters, exports::results::mjcf_lugre}) {
    for (const bool doubtful_too : {false, true}) {
      exports::results::SimulatorOptions options;
      options.doubtful_too = doubtful_too;
      EXPECT_EQ(test::refusal_of<UsageError>([&] { return make(joint, options); }),
                "aaaaaaaaaa: not exported: the torques are in amperes, since the torque constant "
                "was not stated; expected N·m; identify the log again with --torque-constant "
                "NM_PER_A (in a manifest: torque_constant_Nm_A)");
    }
  }
}

// Curves of the model itself, whatever its numbers, are found again.
TEST(MjcfLuGre, FindsTheCurveOfALuGreJoint) {
  std::mt19937_64 random(11);
  const auto from = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
  };
  for (int k = 0; k < 200; ++k) {
    exports::results::SteadyLuGre truth;
    truth.coulomb_Nm = from(0.1, 100);
    truth.static_Nm = truth.coulomb_Nm * from(1.02, 3);
    truth.stribeck_rad_s = from(0.01, 1);
    truth.viscous_Nms_rad = truth.coulomb_Nm * from(0.01, 1);
    std::vector<exports::results::SpeedFriction> friction;
    for (double speed = 0.003; speed < 6; speed *= 1.04) {
      friction.push_back({speed, truth.torque_Nm(speed), 0, 0});
    }
    const exports::results::SteadyLuGre found =
        exports::results::nearest_lugre(friction, truth.static_Nm);
    for (const exports::results::SpeedFriction& f : friction) {
      EXPECT_NEAR(found.torque_Nm(f.speed_rad_s), f.torque_Nm, 0.01 * f.torque_Nm)
          << k << ": " << f.speed_rad_s;
    }
    EXPECT_NEAR(found.coulomb_Nm, truth.coulomb_Nm, 0.02 * truth.coulomb_Nm) << k;
    EXPECT_GE(found.static_Nm, found.coulomb_Nm);
    EXPECT_GE(found.viscous_Nms_rad, 0);
  }
}

TEST(MjcfLuGre, HasTheJointsNumbersAtTheJoint) {
  exports::results::ArchivedJoint joint = test::export_sample();
  const std::string text = exports::results::mjcf_lugre(joint, {});
  // 500 N·m/rad and 0.45 N·m at the motor, times 50² and 50.
  EXPECT_NE(text.find("lugre=\"1250000 0 "), std::string::npos) << text;
  EXPECT_NE(text.find(" 22.5 "), std::string::npos) << text;
  EXPECT_NE(text.find("input=\"none\" motorconst=\"0\" resistance=\"1\""), std::string::npos);
  EXPECT_NE(text.find("bristle damping is 0, for it is not usable: "), std::string::npos) << text;
  EXPECT_NE(text.find("the largest error there is "), std::string::npos) << text;
  test::quantity_of(joint, "bristle_stiffness").verdict = calibration::Verdict::doubtful;
  EXPECT_NE(test::refusal_of<UsageError>([&] {
              return exports::results::mjcf_lugre(joint, {});
            }).find("; mjcf has friction without pre-sliding"),
            std::string::npos);
}

// What the format has no place for stands beside it.
TEST(ExportForSimulators, SayTheSpeedsMeasuredAndTheBreakAwayTorque) {
  for (auto* const make :
       {exports::results::urdf_joint, exports::results::sdf_joint, exports::results::mjcf_joint}) {
    const std::string text = make(test::export_sample(), {});
    EXPECT_NE(text.find("beside it: Break-away torque at the joint"), std::string::npos) << text;
    EXPECT_NE(text.find("measured at the joint from "), std::string::npos) << text;
  }
}

TEST(ExportForSimulators, SdfHasTheDynamicsAtTheJoint) {
  const std::string text = exports::results::sdf_joint(test::export_sample(), {});
  EXPECT_NE(text.find("<damping>5</damping>"), std::string::npos) << text;
  EXPECT_NE(text.find("<friction>15.5</friction>"), std::string::npos) << text;
  EXPECT_NE(text.find("<joint name=\"J2\" type=\"revolute\">"), std::string::npos) << text;
}

// A parameter without a point would be an integer, which a node that declares a double refuses.
TEST(ExportForSimulators, ParametersOfRosAreDoublesAndWhatIsLeftOutHasAReason) {
  exports::results::ArchivedJoint joint = test::export_sample();
  const std::string text = exports::results::ros2_parameters(joint, {});
  EXPECT_NE(text.find("/**:\n  ros__parameters:\n    joint_friction:\n      joint: \"J2\"\n"
                      "      gear_ratio: 50.0\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("      coulomb_torque_Nm: 15.5  # Coulomb torque at the joint"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("      viscous_coefficient_Nms_rad: 5.0  # "), std::string::npos) << text;
  test::quantity_of(joint, "coulomb_torque").verdict = calibration::Verdict::doubtful;
  const std::string without = exports::results::ros2_parameters(joint, {});
  EXPECT_EQ(without.find("\n      coulomb_torque_Nm:"), std::string::npos) << without;
  EXPECT_NE(without.find("# coulomb_torque_Nm: left out: Coulomb torque of"), std::string::npos);
  EXPECT_NE(text.find("      friction_speeds_rad_s: [0.2, 0.4, 0.6, 1.0, 1.8]\n"
                      "      friction_torques_Nm: [16.0, 17.0, 18.0, 20.0, 24.0]\n"),
            std::string::npos)
      << text;
  for (calibration::Quantity& q : joint.quantities) q.verdict = calibration::Verdict::doubtful;
  EXPECT_NE(exports::results::ros2_parameters(joint, {}).find("friction_torques_Nm: [16.0"),
            std::string::npos);
  joint.calibration = "{}";
  EXPECT_NE(test::refusal_of<UsageError>([&] {
              return exports::results::ros2_parameters(joint, {});
            }).find("no number is usable"),
            std::string::npos);
  joint = test::hostile_export_sample();
  for (const std::string& name : {std::string("a\nb: 1"), std::string("\"x\\")}) {
    joint.entry.facts.of.joint = name;
    const std::string hostile = exports::results::ros2_parameters(joint, {});
    EXPECT_EQ(hostile.find("\nb: 1"), std::string::npos) << hostile;
  }
}

TEST(ExportForSimulators, ModelicaRefusesADoubtfulCurveAndNone) {
  exports::results::ArchivedJoint joint = test::export_sample();
  test::quantity_of(joint, "viscous_curve").verdict = calibration::Verdict::doubtful;
  EXPECT_NE(test::refusal_of<UsageError>([&] {
              return exports::results::modelica_friction(joint, {});
            }).find("Viscous curve is doubtful"),
            std::string::npos);
  exports::results::ArchivedJoint none = test::export_sample();
  none.calibration = "{}";
  EXPECT_NE(test::refusal_of<UsageError>([&] {
              return exports::results::modelica_friction(none, {});
            }).find("holds no friction curve"),
            std::string::npos);
  exports::results::ArchivedJoint negative = test::export_sample();
  negative.calibration.replace(negative.calibration.find("0.70"), 4, "-0.7");
  EXPECT_NE(test::refusal_of<UsageError>([&] {
              return exports::results::modelica_friction(negative, {});
            }).find("not above zero"),
            std::string::npos);
}

/// Reads `model JointFriction` by the grammar of the Modelica language (3.4, appendix A), as far as
/// an `extends` with modifications needs it. Throws where a compiler would refuse.
class ModelicaReader {
 public:
  explicit ModelicaReader(const std::string& text) : text_(text) {
    word("model");
    const std::string name = identifier();
    string();
    word("extends");
    base = identifier();
    while (accept('.')) base += "." + identifier();
    expect('(');
    do {
      const std::string parameter = identifier();
      expect('=');
      if (parameter == "peak") {
        peak = number();
      } else if (parameter == "tau_pos") {
        matrix();
      } else {
        throw std::runtime_error("no parameter " + parameter);
      }
    } while (accept(','));
    expect(')');
    expect(';');
    word("end");
    word(name);
    expect(';');
    skip();
    if (at_ != text_.size()) throw std::runtime_error("text behind the model");
  }

  std::string base;
  double peak{1};
  std::vector<std::pair<double, double>> tau_pos;

 private:
  void skip() {
    for (;;) {
      while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
      if (text_.compare(at_, 2, "//") == 0) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        return;
      }
    }
  }
  bool accept(char c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!accept(c)) throw std::runtime_error(std::string("expected ") + c + rest());
  }
  std::string rest() const { return " at: " + text_.substr(at_, 40); }
  std::string identifier() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) {
      ++at_;
    }
    if (begin == at_ || std::isdigit(static_cast<unsigned char>(text_[begin]))) {
      throw std::runtime_error("expected a name" + rest());
    }
    return text_.substr(begin, at_ - begin);
  }
  void word(const std::string& wanted) {
    if (identifier() != wanted) throw std::runtime_error("expected " + wanted + rest());
  }
  void string() {
    expect('"');
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    expect('"');
  }
  double number() {
    skip();
    const std::size_t begin = at_;
    const auto digits = [&] {
      const std::size_t first = at_;
      while (std::isdigit(static_cast<unsigned char>(text_[at_]))) ++at_;
      if (at_ == first) throw std::runtime_error("expected digits" + rest());
    };
    digits();
    if (text_[at_] == '.') {
      ++at_;
      if (std::isdigit(static_cast<unsigned char>(text_[at_]))) digits();
    }
    if (text_[at_] == 'e' || text_[at_] == 'E') {
      ++at_;
      if (text_[at_] == '+' || text_[at_] == '-') ++at_;
      digits();
    }
    return std::stod(text_.substr(begin, at_ - begin));
  }
  void matrix() {
    expect('[');
    do {
      const double speed = number();
      expect(',');
      tau_pos.emplace_back(speed, number());
    } while (accept(';'));
    expect(']');
  }

  const std::string text_;
  std::size_t at_{};
};

TEST(ModelicaFriction, IsWhatTheBearingOfTheLibraryTakes) {
  for (const exports::results::ArchivedJoint& joint :
       {test::export_sample(), test::hostile_export_sample()}) {
    for (const joint::Side side : {joint::Side::joint, joint::Side::motor}) {
      exports::results::SimulatorOptions options;
      options.side = side;
      const ModelicaReader read(exports::results::modelica_friction(joint, options));
      EXPECT_EQ(read.base, "Modelica.Mechanics.Rotational.Components.BearingFriction");
      ASSERT_EQ(read.tau_pos.size(), 4U);
      EXPECT_EQ(read.tau_pos[0].first, 0.0);
      for (std::size_t k = 1; k < 4; ++k) {
        EXPECT_GT(read.tau_pos[k].first, read.tau_pos[k - 1].first);
      }
      const double n = side == joint::Side::joint ? 50 : 1;
      EXPECT_NEAR(read.tau_pos[3].first, 200 / n, 1e-9);
      EXPECT_NEAR(read.tau_pos[3].second, 0.70 * n, 1e-9);
      // The largest torque at rest is peak times the first row: the break-away torque.
      EXPECT_NEAR(read.peak * read.tau_pos[0].second, 0.45 * n, 1e-9);
    }
  }
}

TEST(ModelicaFriction, HasNoPeakBelowOneAndNoneThatIsNotUsable) {
  exports::results::ArchivedJoint joint = test::export_sample();
  test::quantity_of(joint, "break_away_torque").estimate = statistics::Estimate{0.2, 0.1, 0.3, {}};
  EXPECT_EQ(ModelicaReader(exports::results::modelica_friction(joint, {})).peak, 1);
  joint = test::export_sample();
  test::quantity_of(joint, "break_away_torque").verdict = calibration::Verdict::doubtful;
  const std::string text = exports::results::modelica_friction(joint, {});
  EXPECT_EQ(ModelicaReader(text).peak, 1);
  EXPECT_NE(text.find("// peak is 1: Break-away torque of 0.45 N·m"), std::string::npos) << text;
}

TEST(ModelicaFriction, TakesTheLineWhereThereAreNoRuns) {
  exports::results::ArchivedJoint joint = test::export_sample();
  joint.calibration.replace(joint.calibration.find("false"), 5, "true");
  exports::results::SimulatorOptions options;
  options.side = joint::Side::motor;
  const ModelicaReader read(exports::results::modelica_friction(joint, options));
  ASSERT_EQ(read.tau_pos.size(), 2U);
  EXPECT_NEAR(read.tau_pos[0].second, 0.31, 1e-12);
  EXPECT_NEAR(read.tau_pos[1].first, 200, 1e-12);
  EXPECT_NEAR(read.tau_pos[1].second, 0.31 + 0.002 * 200, 1e-12);
}

TEST(MjcfJoint, HasAnArmatureOnlyWhereItIsKnown) {
  // Identified: 0.002 kg·m² · 50² = 5 kg·m² ± 0.25 of rotor, gear and arm.
  const exports::results::ArchivedJoint joint = test::export_sample();
  exports::results::SimulatorOptions options;
  EXPECT_EQ(exports::results::mjcf_joint(joint, options).find("armature=\""), std::string::npos);
  EXPECT_NE(exports::results::mjcf_joint(joint, options).find("armature is left out"),
            std::string::npos);
  options.arm_inertia_kgm2 = 4.5;
  EXPECT_NE(exports::results::mjcf_joint(joint, options).find(" armature=\"0.5\"/>"),
            std::string::npos);
  options.arm_inertia_kgm2 = 4.8;  // within the interval: nothing is shown
  EXPECT_EQ(exports::results::mjcf_joint(joint, options).find("armature=\""), std::string::npos);
}

}  // namespace
}  // namespace tribolog::archive::export_simulators_test
