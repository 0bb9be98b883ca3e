#pragma once
// The numbers of a calibration that can be compared with a known truth, by name.

#include <optional>
#include <string>

#include "method/hysteresis/estimator.h"

namespace tribolog::calibration {

enum class ReadingName {
  A,  ///< A to F: the gravity torque at the paper's points.
  B,
  C,
  D,
  E,
  F,
  A_steady,  ///< The same point of the steady loop.
  B_steady,
  AB,
  CD,
  EF,
  midline,
  model,
  fit,  ///< The last of the gravity torques.
  q_peak,
  bristle_stiffness,
  static_torque,
  sweep_friction,
  coulomb,  ///< Of the straight line through the curve; its slope is `viscous`.
  viscous,
  asperity_torque,  ///< This and what follows: of eq. (6).
  stribeck_speed,
  stribeck_power,
  viscous_coefficient,
  viscous_power,
  break_away,  ///< Of ramps; used by plans, not by studies.
};

/// Stable, in files and in message codes: "A_steady", "q_peak".
std::string to_string(ReadingName name);

/// The estimator whose gravity torque the reading is; nothing for other readings.
std::optional<method::hysteresis::Estimator> estimator_of(ReadingName name);

}  // namespace tribolog::calibration
