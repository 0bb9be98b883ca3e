#pragma once
// A calibration with every quantity that an export knows, made up. Gear ratio 50.

#include <stdexcept>

#include "archive/sample_calibration.h"
#include "exports/results/archived_joint.h"

namespace tribolog::test {

/// Friction at the motor by hand: 0.3 N·m + 0.002 N·m·s/rad |w|, falling runs 0.02 N·m more.
inline exports::results::ArchivedJoint export_sample() {
  exports::results::ArchivedJoint joint;
  joint.entry.id = std::string(64, 'a');
  joint.entry.facts = sample_calibration(1, 2, 3, 0.3).facts;
  joint.entry.facts.gear_ratio = 50;
  const auto add = [&](const char* name, const char* words, const char* unit, double value,
                       double half_width) {
    joint.quantities.push_back({name, words, unit, calibration::Verdict::usable,
                                statistics::symmetric_estimate(value, half_width)});
  };
  add("cog_angle", "Angle of the centre of gravity", "rad", -0.4, 0.01);
  add("gravity_torque", "Gravity torque", "N·m", 4, 0.1);
  add("surrogate_mass", "Surrogate mass", "kg", 40, 1);
  add("break_away_torque", "Break-away torque", "N·m", 0.45, 0.02);
  add("bristle_stiffness", "Bristle stiffness", "N·m/rad", 500, 20);
  add("inertia", "Inertia at the motor", "kg·m²", 0.002, 0.0001);
  add("coulomb_torque", "Coulomb torque", "N·m", 0.31, 0.01);
  add("stribeck_speed", "Stribeck velocity", "rad/s", 5, 0.5);
  add("viscous_coefficient", "Viscous coefficient", "N·m·s/rad", 0.002, 0.0001);
  joint.quantities.push_back(
      {"viscous_curve", "Viscous curve", "", calibration::Verdict::usable, {}});
  joint.calibration = R"({"model": {"law": {"fastest_rad_s": 200}},
      "selection": {"recommended": "midline"}, "viscous": {"from_sweep": false,
      "runs": [{"speed_rad_s": -100.01}, {"speed_rad_s": -10}, {"speed_rad_s": 10},
               {"speed_rad_s": 99.99}, {"speed_rad_s": 200}],
      "curves": {"midline": [-0.52, -0.34, 0.32, 0.50, 0.70]}},
      "friction_at_speed": [
        {"speed_rad_s": 10, "estimate": 0.32, "low": 0.31, "high": 0.33, "verdict": "usable"},
        {"speed_rad_s": 20, "estimate": 0.34, "low": 0.33, "high": 0.35, "verdict": "usable"},
        {"speed_rad_s": 30, "estimate": 0.36, "low": 0.35, "high": 0.37, "verdict": "usable"},
        {"speed_rad_s": 50, "estimate": 0.4, "low": 0.39, "high": 0.41, "verdict": "usable"},
        {"speed_rad_s": 90, "estimate": 0.48, "low": 0.46, "high": 0.5, "verdict": "usable"},
        {"speed_rad_s": 160, "estimate": 0.625, "low": 0.5, "high": 0.75, "verdict": "doubtful",
         "reason": "known to ± 20 %"}]})";
  return joint;
}

/// The same of a current whose torque constant is not known.
inline exports::results::ArchivedJoint ampere_sample() {
  exports::results::ArchivedJoint joint = export_sample();
  for (calibration::Quantity& q : joint.quantities) q.unit = joint::in_amperes(q.unit);
  return joint;
}

inline calibration::Quantity& quantity_of(exports::results::ArchivedJoint& joint,
                                          const std::string& name) {
  for (calibration::Quantity& q : joint.quantities) {
    if (q.name == name) return q;
  }
  throw std::logic_error("no " + name);
}

/// Texts that try to leave the place where they stand.
inline exports::results::ArchivedJoint hostile_export_sample() {
  exports::results::ArchivedJoint joint = export_sample();
  joint.entry.facts.of.robot =
      "--><!DOCTYPE x [<!ENTITY e 'e'>]>&e;]]>\"'\xe2\x80\xae\n,=1+1;@x */";
  joint.entry.facts.of.joint = "J\"/><joint name='x\n\\end{tabular}%$#_^~{\x01\xff-- é 关节";
  joint.entry.facts.sentence = "a --- b\nmodel Evil end Evil; \\input{x}";
  quantity_of(joint, "coulomb_torque").words = "=HYPERLINK(\"x\"), ``a'' \\write18{x} --";
  return joint;
}

}  // namespace tribolog::test
