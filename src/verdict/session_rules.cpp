#include "verdict/session_rules.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "joint/degrees.h"
#include "verdict/gravity_rules.h"

namespace tribolog::verdict {
namespace {

using calibration::Calibration;
using calibration::Verdict;
using joint::Quantity;
using method::session::SessionFriction;

constexpr Code no_load{"record.friction_without_load"};
constexpr Code warm_up{"record.warmed_up"};

/// Percent of a share that was found; 0 of one that was sought and not found.
double percent_if(bool found, double share) { return found ? 100 * std::abs(share) : 0.0; }

// The load.

/// Of a sweep of varying speed, where there are no strokes of constant speed to compare.
std::optional<Measured> by_load_of_sweep(const method::viscous::LoadDependenceResult& l) {
  if (!l.examined) return std::nullopt;
  const double load = (l.lowest_load_Nm + l.highest_load_Nm) / 2;
  return Measured{percent_if(l.found, l.per_load.value * load / l.unloaded_Nm.value),
                  {"cause.load",
                   {{"share_percent", 100 * l.per_load.value},
                    {"low_percent", 100 * l.per_load.low},
                    {"high_percent", 100 * l.per_load.high},
                    {"at_peak_Nm", l.unloaded_Nm.value + l.per_load.value * l.highest_load_Nm},
                    {"unloaded_Nm", l.unloaded_Nm.value}}}};
}

/// Friction that the load adds to that recorded, as a share of the unloaded friction.
std::optional<Measured> by_load(const Calibration& c) {
  const auto& l = c.session.load;
  if (!l.examined) {
    // Where friction falls with speed, a sweep that is fastest under the largest load cannot
    // distinguish the two.
    const bool has_dip = c.curve_model.sliding.fitted && c.curve_model.sliding.has_dip;
    return has_dip && !c.viscous.from_sweep ? std::nullopt : by_load_of_sweep(c.load_dependence);
  }
  return Measured{percent_if(l.found, (l.friction_Nm - l.unloaded_Nm) / l.unloaded_Nm),
                  {"cause.load",
                   {{"share_percent", 100 * l.per_load.value},
                    {"low_percent", 100 * l.per_load.low},
                    {"high_percent", 100 * l.per_load.high},
                    {"at_peak_Nm", l.at_peak_Nm},
                    {"unloaded_Nm", l.unloaded_Nm}}}};
}

/// Effect of the load on the slope over speed: where runs at different speeds cross different
/// loads, and as large as that on friction as a whole, which the load may add to or multiply.
std::optional<Measured> by_load_on_slope(const Calibration& c) {
  std::optional<Measured> found = by_load(c);
  // In a sweep of varying speed the effects of speed and load cannot be separated.
  if (!found || (!c.session.load.examined && c.viscous.from_sweep)) return found;
  const auto& line = c.friction.coulomb_viscous;
  if (!c.session.load.examined || !line || !(line->viscous_Nms_rad.value > 0)) return std::nullopt;
  found->value =
      std::max(found->value, percent_if(c.session.load.found, c.session.load.viscous_Nms_rad /
                                                                  line->viscous_Nms_rad.value));
  return found;
}

// The joint's angle.

std::optional<Measured> by_angle(const Calibration& c) {
  const auto& a = c.session.angle;
  if (!a.examined) return std::nullopt;
  return Measured{percent_if(a.found, a.amplitude.value),
                  {"cause.angle",
                   {{"percent", 100 * a.amplitude.value},
                    {"low_percent", 100 * a.amplitude.low},
                    {"high_percent", 100 * a.amplitude.high}}}};
}

// The motor's angle, along the sweep.

/// Amplitude of a sine with the standard deviation that the sweep shows.
std::optional<Measured> by_motor_angle(const Calibration& c) {
  if (!c.rough.found || !c.rough.both_directions || !c.rough.coulomb_Nm) return std::nullopt;
  const double percent =
      100 * std::sqrt(2.0) * c.rough.friction_by_angle_Nm / std::abs(c.rough.coulomb_Nm->value);
  // Fewer periods along the whole sweep are a course of the joint's angle, or of the load.
  constexpr double fewest_periods = 10;
  const double turns = c.manifest.drive.gear_ratio() * (c.rough.highest_rad - c.rough.lowest_rad) /
                       (2 * std::numbers::pi);
  const std::vector<method::gravity::RippleLine>& lines = c.rough.friction_of_angle.lines;
  const auto line =
      std::find_if(lines.begin(), lines.end(), [&](const method::gravity::RippleLine& one) {
        return one.periods_per_turn * turns > fewest_periods;
      });
  if (line != lines.end()) {
    return Measured{percent,
                    {"cause.friction_by_motor_angle",
                     {{"percent", percent}, {"periods", line->periods_per_turn}}}};
  }
  const bool is_told = c.session.angle.found || c.session.load.found;
  if (is_told && !lines.empty()) return std::nullopt;
  return Measured{percent, {"cause.friction_along_angle", {{"percent", percent}}}};
}

/// Friction that follows the joint's angle in lines slower than the motor turns, as worn spots do,
/// in percent of Coulomb's.
std::optional<Measured> along_angle(const Calibration& c) {
  if (!c.rough.found || !c.rough.coulomb_Nm) return std::nullopt;
  constexpr double of_motor = 0.9;  // periods to its turn
  double squares = 0;
  for (const method::gravity::RippleLine& line : c.rough.friction_of_angle.lines) {
    if (line.periods_per_turn < of_motor) squares += line.amplitude_Nm * line.amplitude_Nm;
  }
  const double percent = 100 * std::sqrt(squares) / std::abs(c.rough.coulomb_Nm->value);
  return Measured{percent, {"cause.friction_along_angle", {{"percent", percent}}}};
}

std::optional<Measured> between_ramps(const Calibration& c) {
  const method::hysteresis::BreakAwayResult& ramps = c.break_away;
  if (ramps.positions < 2) return std::nullopt;
  const double percent = 100 * ramps.between_positions;
  return Measured{percent,
                  {"cause.friction_by_motor_angle_of_ramps",
                   {{"percent", percent}, {"positions", ramps.positions}}}};
}

// The direction.

std::optional<Measured> by_direction(const Calibration& c) {
  const auto& d = c.session.direction;
  if (!d.examined) return std::nullopt;
  if (d.asymmetry_found && !d.told_apart) {
    const double share = d.offset_Nm.value / c.session.mean_friction_Nm;
    return Measured{percent_if(true, share),
                    {"cause.asymmetry_or_offset",
                     {{"percent", 100 * share}, {"offset_Nm", d.offset_Nm.value}}}};
  }
  // Where the runs say it too, it is said once.
  const std::optional<statistics::Estimate>& of_runs = c.torque_balance.asymmetry;
  if (of_runs && of_runs->value * d.asymmetry.value > 0 &&
      std::abs(of_runs->value) > of_runs->half_width()) {
    return Measured{
        percent_if(d.asymmetry_found, d.asymmetry.value),
        {"cause.asymmetry_of_runs",
         {{"percent", 100 * of_runs->value}, {"half_width", 100 * of_runs->half_width()}}}};
  }
  return Measured{percent_if(d.asymmetry_found, d.asymmetry.value),
                  {"cause.asymmetry",
                   {{"percent", 100 * d.asymmetry.value},
                    {"low_percent", 100 * d.asymmetry.low},
                    {"high_percent", 100 * d.asymmetry.high}}}};
}

std::optional<Measured> of_offset(const Calibration& c) {
  const auto& d = c.session.direction;
  if (!d.examined) return std::nullopt;
  const double share = d.offset_Nm.value / c.session.gravity_Nm;
  return Measured{percent_if(d.offset_found && d.told_apart, share),
                  offset_found(c, d.offset_Nm.value, d.offset_Nm.half_width())};
}

// The time.

Statement drift_found(const SessionFriction& s) {
  return {"cause.drift",
          {{"percent", 100 * s.drift.change},
           {"low_percent", 100 * s.drift.low},
           {"high_percent", 100 * s.drift.high},
           {"minutes", s.whole_s / 60},
           {"levels", s.drift.levels}}};
}

std::optional<Measured> over_time(const Calibration& c) {
  const SessionFriction& s = c.session;
  if (!s.drift.examined) return std::nullopt;
  return Measured{percent_if(s.drift.found, s.drift.change), drift_found(s)};
}

/// Of the sweep that the angle comes from.
const method::session::SweepShift* shift_of_angle(const Calibration& c) {
  const SessionFriction& s = c.session;
  const bool precise = c.q_peak_source == method::gravity::PeakSource::precise_sweep;
  const auto& shift = precise ? s.precise_shift : s.rough_shift;
  return shift ? &*shift : nullptr;
}

/// What remains of it in the angle, which was corrected for the most likely change.
std::optional<Measured> drift_on_angle(const Calibration& c) {
  if (!c.session.drift.examined || !c.q_peak_rad) return std::nullopt;
  const auto* shift = shift_of_angle(c);
  if (shift == nullptr) return Measured{0, {}};
  return Measured{joint::degrees_per_rad * shift->q_peak_slack_rad,
                  {"cause.drift_within_sweep",
                   {{"percent", 100 * c.session.drift.change},
                    {"shift_deg", joint::degrees_per_rad * shift->q_peak_rad},
                    {"slack_deg", joint::degrees_per_rad * shift->q_peak_slack_rad}}}};
}

std::optional<Measured> drift_on_gravity(const Calibration& c) {
  const SessionFriction& s = c.session;
  if (!s.drift.examined || c.selection.recommended != method::hysteresis::Estimator::sweep) {
    return std::nullopt;
  }
  if (!s.rough_shift) return Measured{0, {}};
  return Measured{
      100 * (std::abs(s.rough_shift->gravity_Nm) + s.rough_shift->gravity_slack_Nm) / s.gravity_Nm,
      drift_found(s)};
}

Statement offset_drift_found(const SessionFriction& s) {
  const statistics::Estimate& change = s.offset_drift.change_Nm;
  return {"cause.drift_of_offset",
          {{"change_Nm", change.value},
           {"half_width_Nm", change.half_width()},
           {"percent", 100 * change.value / s.gravity_Nm},
           {"minutes", s.whole_s / 60}}};
}

std::optional<Measured> offset_drift(const Calibration& c) {
  const SessionFriction& s = c.session;
  if (!s.offset_drift.examined) return std::nullopt;
  return Measured{percent_if(s.offset_drift.found, s.offset_drift.change_Nm.value / s.gravity_Nm),
                  offset_drift_found(s)};
}

/// Between the sweep, whose offset is known, and the oscillations.
std::optional<Measured> offset_drift_on_gravity(const Calibration& c) {
  const SessionFriction& s = c.session;
  const auto recommended = c.selection.recommended;
  if (!s.offset_drift.examined || !recommended ||
      recommended == method::hysteresis::Estimator::sweep ||
      recommended == method::hysteresis::Estimator::runs ||
      recommended == method::hysteresis::Estimator::stated) {
    return std::nullopt;
  }
  return Measured{
      percent_if(s.offset_drift.found, s.offset_drift.to_oscillations_Nm / s.gravity_Nm),
      offset_drift_found(s)};
}

/// As a share of friction, whose curve comes from both directions of each run at different times.
std::optional<Measured> offset_drift_on_friction(const Calibration& c) {
  const SessionFriction& s = c.session;
  if (!s.offset_drift.examined) return std::nullopt;
  return Measured{
      percent_if(s.offset_drift.found, s.offset_drift.change_Nm.value / s.mean_friction_Nm),
      offset_drift_found(s)};
}

}  // namespace

std::vector<Rule> session_rules() {
  // Half of what makes a quantity wrong: 2 % of a friction torque or stiffness, 5 % of a slope,
  // 0.1 % of gravity, 0.05 degrees.
  constexpr double of_friction = 1;
  constexpr double of_slope = 2.5;
  constexpr double of_gravity = 0.05;
  constexpr double of_angle_deg = 0.05;
  const auto doubtful = Verdict::doubtful;
  const std::vector<Quantity> friction{Quantity::coulomb_torque, Quantity::break_away_torque,
                                       Quantity::bristle_stiffness, Quantity::viscous_curve};
  const std::vector<Quantity> slopes{Quantity::viscous_coefficient, Quantity::stribeck_speed};
  const std::vector<Quantity> gravity{Quantity::gravity_torque, Quantity::surrogate_mass};
  std::vector<Quantity> loaded = friction;
  loaded.push_back(Quantity::bristle_damping);
  std::vector<Quantity> drifting = loaded;
  drifting.insert(drifting.end(), slopes.begin(), slopes.end());
  return {
      {"friction_by_load", "%", of_friction, doubtful, loaded, no_load, by_load, {}},
      {"friction_by_load_slope", "%", of_slope, doubtful, slopes, no_load, by_load_on_slope, {}},
      {"friction_by_angle", "%", of_friction, doubtful, friction, no_load, by_angle, {}},
      {"friction_by_angle_slope", "%", 2 * of_slope, doubtful, slopes, no_load, by_angle, {}},
      {"friction_along_angle",
       "%",
       3 * of_friction,
       doubtful,
       {Quantity::coulomb_torque, Quantity::stribeck_speed, Quantity::viscous_curve},
       no_load,
       along_angle,
       {}},
      // Both are in the intervals of what loops and ramps show.
      {"friction_by_motor_angle",
       "%",
       of_friction,
       Verdict::usable,
       {},
       no_load,
       by_motor_angle,
       {}},
      {"break_away_by_motor_angle",
       "%",
       of_friction,
       Verdict::usable,
       {},
       no_load,
       between_ramps,
       {}},
      {"friction_by_direction",
       "%",
       of_friction / 2,
       Verdict::usable,
       {},
       no_load,
       by_direction,
       {}},
      {"friction_by_direction_large",
       "%",
       10 * of_friction,
       doubtful,
       drifting,
       no_load,
       by_direction,
       {}},
      {"torque_offset", "%", of_gravity, Verdict::usable, {}, no_load, of_offset, {}},
      {"friction_drift", "%", of_friction, doubtful, drifting, warm_up, over_time, {}},
      {"friction_drift_angle",
       "deg",
       of_angle_deg,
       doubtful,
       {Quantity::cog_angle},
       warm_up,
       drift_on_angle,
       {}},
      {"friction_drift_gravity", "%", of_gravity, doubtful, gravity, warm_up, drift_on_gravity, {}},
      {"offset_drift", "%", of_gravity, Verdict::usable, {}, warm_up, offset_drift, {}},
      {"offset_drift_gravity",
       "%",
       of_gravity,
       doubtful,
       gravity,
       warm_up,
       offset_drift_on_gravity,
       {}},
      {"offset_drift_friction",
       "%",
       2 * of_friction,
       doubtful,
       {Quantity::coulomb_torque, Quantity::viscous_coefficient, Quantity::viscous_curve},
       warm_up,
       offset_drift_on_friction,
       {}},
  };
}

}  // namespace tribolog::verdict
