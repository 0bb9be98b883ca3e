// What a failing check on the data does to each quantity.

#include "calibration/headline.h"
#include "method/checks/data_check.h"
#include "verdict/quantity_rooms.h"
#include "verdict/rules.h"

namespace tribolog::verdict {
namespace {

using calibration::Calibration;
using joint::Quantity;
using method::checks::CheckName;
using method::hysteresis::Estimator;

const Quantities slopes{Quantity::stribeck_speed, Quantity::viscous_coefficient,
                        Quantity::viscous_curve};
const Quantities per_speed = of_damping + of_inertia;

// From which recordings the quantities come: a failing check of other recordings does not affect
// them.

/// Of a controller: its gravity, too, is the controller's own.
bool effort_is_target(const Calibration& c) {
  return c.manifest.drive.kind() == joint::EffortKind::target_torque;
}

bool effort_is_measured(const Calibration& c) { return !effort_is_target(c); }

/// No torque depends on the angle where there is no gravity.
bool has_gravity(const Calibration& c) { return !has_stated_no_gravity(c); }

bool break_away_from_ramps(const Calibration& c) {
  const bool loops_show_level =
      c.lugre && c.lugre->shown(method::hysteresis::LuGreParameterName::static_torque);
  return c.break_away.mean_Nm || (!loops_show_level && c.break_away.of_one_direction_Nm());
}

bool break_away_from_loops(const Calibration& c) { return !break_away_from_ramps(c); }

bool mass_from_sweep(const Calibration& c) { return c.selection.recommended == Estimator::sweep; }

bool mass_from_loops(const Calibration& c) { return !mass_from_sweep(c); }

/// For want of runs at constant speed.
bool friction_from_sweep(const Calibration& c) {
  return c.viscous.runs.empty() || c.viscous.from_sweep;
}

/// Where the torque changes in no recording, all numbers are made of one that was held.
bool torque_is_dead(const Calibration& c) {
  const method::checks::DataCheck* alive = c.data_checks.find(CheckName::torque_alive);
  return alive != nullptr && alive->measured == 0.0;
}

bool torque_lives_somewhere(const Calibration& c) { return !torque_is_dead(c); }

}  // namespace

std::vector<Rule> check_rules() {
  const Quantities torque = of_mass + of_loops + of_curve + of_break_away + of_inertia;
  const Quantities everything = torque + of_angle;
  const auto doubtful = calibration::Verdict::doubtful;
  const auto unknown = calibration::Verdict::not_identifiable;
  using enum CheckName;
  return {
      // What is not confirmed may be wrong by a factor, which leaves the angle.
      {effort_provenance, doubtful, everything, everything, effort_is_target},
      {effort_provenance, doubtful, torque, torque, effort_is_measured},
      {angle_provenance, doubtful, everything, everything, has_gravity},
      {angle_provenance, doubtful, slopes + per_speed + of_stiffness, slopes + per_speed,
       has_stated_no_gravity},
      {speed_provenance, doubtful, slopes + per_speed, slopes + per_speed},
      {effort_column, doubtful, everything, everything},
      {static_torque, doubtful, torque, torque},
      {joint_moves, doubtful, everything, none},
      {angle_unit, doubtful, everything, everything},
      {motor_speed, doubtful, everything, everything},
      // Where the angle jumps, its zero is another; what else changes with it is in the intervals.
      {angle_jumps, doubtful, of_gravity + of_loops + of_curve_alone, of_angle},
      {clock_jitter, doubtful, slopes + per_speed + of_stiffness, none},
      {clock_gaps, doubtful, slopes + per_speed + of_break_away, none},
      {angle_interpolated, doubtful, per_speed + of_stiffness, none},
      {torque_interpolated, doubtful, per_speed, none},
      {speed_scale, doubtful, slopes + per_speed + of_stiffness, none},
      {run_directions, unknown, of_coulomb, none},
      {run_directions, doubtful, of_curve_alone, none},
      {run_common_angles, doubtful, of_curve, none},
      {run_speeds, unknown, slopes, none},
      {run_speeds, doubtful, of_coulomb, none},
      // A slip is an acceleration too, as fast as the drive's own control.
      {stick_slip, doubtful, of_curve + of_inertia, of_curve + of_inertia},
      {torque_alive, unknown, torque, torque, torque_is_dead},
      {torque_alive, doubtful, torque, none, torque_lives_somewhere},
      {torque_held, doubtful, everything, none},
      {torque_noise, unknown, everything, everything},
      {torque_saturation, doubtful, everything, everything},
      {torque_step, doubtful, torque, torque},
      {friction_dissipates, unknown, everything, everything},
      {power, doubtful, torque, torque},
      {friction_drift, doubtful, of_curve + of_break_away, none},
      {temperature, doubtful, of_curve + of_break_away, none},
      {encoder_step, unknown, of_loops, none},
      {encoder_step, unknown, of_break_away, none, break_away_from_loops},
      {oscillation_cycles, doubtful, of_loops, none},
      {oscillation_cycles, doubtful, of_break_away, none, break_away_from_loops},
      {gravity_within_torque, unknown, of_gravity, of_gravity},
      {sweep_directions, doubtful, of_angle, none},
      {oscillation_slides, unknown, of_break_away, none, break_away_from_loops},
      {sweep_directions, doubtful, of_mass, none, mass_from_sweep},
      {torque_ripple, doubtful, of_mass, none, mass_from_loops},
      {oscillation_cycles, doubtful, of_mass, none, mass_from_loops},
      {oscillation_at_peak, doubtful, of_mass, none, mass_from_loops},
      {sweep_directions, unknown, of_coulomb, none, friction_from_sweep},
      {sweep_directions, doubtful, of_curve_alone, none, friction_from_sweep},
      {sweep_common_angles, doubtful, of_curve, none, friction_from_sweep}};
}

}  // namespace tribolog::verdict
