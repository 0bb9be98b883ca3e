#pragma once
// The numbers of a calibration that can be held against a known truth.

#include <optional>
#include <string>
#include <vector>

#include "calibration/calibration.h"

namespace tribolog::truth {

using calibration::ReadingName;

/// What a number is of; numbers of one kind share a unit and the bounds of what matters.
enum class ReadingKind {
  gravity,          ///< Gravity torque at the motor, centre of gravity level [N·m].
  peak_angle,       ///< q_peak [rad]
  stiffness,        ///< Bristle stiffness s0 [N·m/rad]
  static_torque,    ///< Ts [N·m]
  sweep_friction,   ///< Half the distance of the sweep's directions [N·m].
  coulomb,          ///< Of the model, or of the straight line [N·m].
  viscous,          ///< Its slope at high speed [N·m·s/rad].
  asperity_torque,  ///< Ta of eq. (6) [N·m]
  stribeck_speed,   ///< ws of the model, or of eq. (6) [rad/s]
  stribeck_power,   ///< da of eq. (6)
  viscous_factor,   ///< cv of eq. (6)
  viscous_power,    ///< dv of eq. (6)
};

/// "N·m", "rad"; empty: a pure number.
std::string unit_of(ReadingKind quantity);

struct Reading {
  ReadingName name{};
  ReadingKind quantity{ReadingKind::gravity};
  statistics::Estimate estimate;
};

/// All that were found, in the order of the names above.
std::vector<Reading> readings_of(const calibration::Calibration& calibration);

const Reading* find_reading(const std::vector<Reading>& readings, ReadingName name);

/// Whether the runs follow eq. (6) in a joint made of what was identified; else they follow the
/// law of the model.
bool runs_follow_waiboer(const calibration::Calibration& calibration);

/// The reading is one of the paper's single points or the same point of the steady loop: it keeps
/// the friction of its instant and is off by that, as its definition has it.
bool is_single_point(ReadingName name);

}  // namespace tribolog::truth
