#pragma once
// Checks on the recordings before any fit: what can be wrong with a log, each with its number and
// its limit.
//
// A check that fails lowers the verdict of the quantities it affects (see verdict/judge.cpp). One
// that warns is reported, and lowers nothing.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"

namespace tribolog::method::checks {

enum class CheckState { passed, warns, fails, not_applicable };

std::string to_string(CheckState state);

/// In the order of the report.
enum class CheckName {
  effort_provenance,
  angle_provenance,
  speed_provenance,
  effort_column,
  link_side_torque,
  joint_moves,
  angle_unit,
  motor_speed,
  angle_jumps,
  clock_jitter,
  clock_gaps,
  angle_interpolated,
  torque_interpolated,
  speed_scale,
  speed_noise,
  sweep_directions,
  run_directions,
  sweep_common_angles,
  run_common_angles,
  run_speeds,
  stick_slip,
  torque_alive,
  torque_held,
  torque_noise,
  torque_saturation,
  torque_step,
  friction_dissipates,
  power,
  friction_drift,
  temperature,
  encoder_step,
  oscillation_cycles,
  oscillation_slides,
  oscillation_at_peak,
  gravity_within_torque,
  static_torque,
  torque_ripple,
  ripple_period,
};

/// Stable, in files and in message codes: "speed_scale".
std::string to_string(CheckName name);

struct DataCheck {
  CheckName name{};
  std::string recording;           ///< The recording that the number is from, a role, or "all";
                                   ///< empty: none.
  Statement measure;               ///< What was measured.
  std::optional<double> measured;  ///< In `unit`; absent where not applicable.
  std::optional<double> at_least;  ///< Limits of what passes, in `unit`.
  std::optional<double> at_most;
  std::string unit;  ///< "1" for a pure number.
  CheckState state{CheckState::not_applicable};
  Statement found;          ///< A clause stating what was found, or why the check does not apply.
  Statement consequence;    ///< Its effect on the results; empty if it passed.
  Statement experiment;     ///< What to record instead; empty if it passed.
  bool is_of_whole_role{};  ///< `recording` is a role: the number is of all its recordings.
};

struct DataChecksResult {
  std::vector<DataCheck> checks;  ///< In the order of the report.

  [[nodiscard]] const DataCheck* find(CheckName name) const;
  [[nodiscard]] bool fails(CheckName name) const;
  /// Those in this state, in order.
  [[nodiscard]] std::vector<const DataCheck*> in_state(CheckState state) const;
};

}  // namespace tribolog::method::checks
