#pragma once
// Joints of known friction, as a calibration would have it.

#include <cmath>
#include <random>
#include <string>

#include <fmt/format.h>

#include "exports/export_sample.h"
#include "exports/results/simulator_numbers.h"

namespace tribolog::test {

/// T = coulomb + viscous |w| + excess exp(-|w| / stribeck), at the motor.
struct KnownFriction {
  double gear_ratio{};
  double coulomb_Nm{}, viscous_Nms_rad{}, excess_Nm{}, stribeck_rad_s{};

  [[nodiscard]] double motor_Nm(double motor_rad_s) const {
    return coulomb_Nm + viscous_Nms_rad * motor_rad_s +
           excess_Nm * std::exp(-motor_rad_s / stribeck_rad_s);
  }
  /// At a speed of the joint.
  [[nodiscard]] double joint_Nm(double joint_rad_s) const {
    return gear_ratio * motor_Nm(joint_rad_s * gear_ratio);
  }
};

inline KnownFriction random_friction(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
  };
  const double coulomb_Nm = between(0.01, 2);
  return {between(1, 160), coulomb_Nm, coulomb_Nm * between(1e-4, 0.05),
          coulomb_Nm * between(0.01, 0.8), between(0.5, 20)};
}

/// Known to 1 % at 40 speeds from 0.5 to 300 rad/s of the motor; Coulomb torque and viscous
/// coefficient are not identified, or as the law has them.
inline exports::results::ArchivedJoint joint_of(const KnownFriction& law, bool has_limits) {
  exports::results::ArchivedJoint joint = export_sample();
  joint.entry.facts.gear_ratio = law.gear_ratio;
  std::string speeds;
  for (int k = 0; k < 40; ++k) {
    const double speed = 0.5 * std::pow(600.0, k / 39.0);
    const double torque = law.motor_Nm(speed);
    speeds += fmt::format(
        "{}{{\"speed_rad_s\": {}, \"estimate\": {}, \"low\": {}, \"high\": {}, \"verdict\": "
        "\"usable\"}}",
        k == 0 ? "" : ",", speed, torque, 0.99 * torque, 1.01 * torque);
  }
  joint.calibration = "{\"friction_at_speed\": [" + speeds + "]}";
  for (calibration::Quantity& q : joint.quantities) {
    if (q.name == "coulomb_torque") {
      q.estimate = statistics::symmetric_estimate(law.coulomb_Nm, 0.01 * law.coulomb_Nm);
    } else if (q.name == "viscous_coefficient") {
      q.estimate = statistics::symmetric_estimate(law.viscous_Nms_rad, 0.01 * law.viscous_Nms_rad);
    } else if (q.name == "break_away_torque") {
      q.estimate = statistics::symmetric_estimate(law.motor_Nm(0), 0.01 * law.motor_Nm(0));
      continue;
    } else {
      continue;
    }
    if (!has_limits) q.verdict = calibration::Verdict::not_identifiable;
  }
  return joint;
}

}  // namespace tribolog::test
