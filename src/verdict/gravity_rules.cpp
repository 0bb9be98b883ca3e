// Rules on gravity and its angle.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/closest_match.h"
#include "base/error.h"
#include "joint/degrees.h"
#include "verdict/effect_findings.h"
#include "verdict/quantity_rooms.h"
#include "verdict/rules.h"

namespace tribolog::verdict {
namespace {

using calibration::Calibration;
using calibration::Verdict;
using joint::Quantity;

/// The largest friction that the joint has shown [N·m, motor side]; 0: none.
double largest_friction_Nm(const Calibration& c) {
  double friction = c.hysteresis.midline_friction_Nm;
  if (c.rough.coulomb_Nm) friction = std::max(friction, c.rough.coulomb_Nm->value);
  if (c.break_away.mean_Nm) friction = std::max(friction, c.break_away.mean_Nm->value);
  return friction;
}

/// Friction as a share of the gravity torque.
std::optional<Measured> friction_over_gravity(const Calibration& c) {
  const double friction = largest_friction_Nm(c);
  constexpr double no_gravity_at_all = 1e6;
  if (has_stated_no_gravity(c)) {
    return Measured{no_gravity_at_all, why_no_gravity(c)};
  }
  // A sweep that shows no gravity has to be sure that there is none.
  const double gravity = c.rough.found ? c.rough.gravity_Nm.value : c.rough.gravity_Nm.high;
  if (!(friction > 0) || c.rough.samples_used == 0 || !(gravity > 0)) return std::nullopt;
  const double percent = std::min(no_gravity_at_all, 100 * friction / std::max(gravity, 1e-300));
  // Controllers take it off a torque at the joint.
  const bool may_be_removed = c.manifest.drive.kind() == joint::EffortKind::joint_torque;
  return Measured{percent,
                  {may_be_removed ? Code{"cause.no_gravity_or_removed"} : Code{"cause.no_gravity"},
                   {{"gravity_Nm", gravity}, {"friction_Nm", friction}}}};
}

std::optional<Measured> motion_harmonics(const Calibration& c) {
  double second = 0;
  double third = 0;
  for (const method::hysteresis::Oscillation& o : c.hysteresis.oscillations) {
    second = std::max(second, o.second_harmonic);
    third = std::max(third, o.third_harmonic);
  }
  if (c.hysteresis.oscillations.empty()) return std::nullopt;
  return Measured{
      100 * std::max(second, third),
      {"cause.motion", {{"second_percent", 100 * second}, {"third_percent", 100 * third}}}};
}

/// In percent of the gravity torque.
std::optional<Measured> ripple(const Calibration& c) {
  if (!c.rough.found) return std::nullopt;
  const std::size_t lines = c.rough.ripple.lines.size();
  Statement said =
      lines > 0 ? Statement{"cause.ripple", {{"ripple_Nm", c.rough.ripple_Nm}, {"lines", lines}}}
                : Statement{"cause.ripple_without_lines", {{"ripple_Nm", c.rough.ripple_Nm}}};
  return Measured{100 * c.rough.ripple_Nm / c.rough.gravity_Nm.value, std::move(said)};
}

/// Below this frequency nothing in the joint itself vibrates.
constexpr double slowest_vibration_Hz = 0.5;

const method::gravity::VibrationLine* largest_line(const Calibration& c, bool is_slow) {
  const method::gravity::VibrationLine* largest = nullptr;
  for (const method::gravity::VibrationLine& line : c.rough.vibration) {
    if ((line.frequency_Hz < slowest_vibration_Hz) != is_slow) continue;
    if (largest == nullptr || line.amplitude_Nm > largest->amplitude_Nm) largest = &line;
  }
  return largest;
}

std::optional<Measured> periodic_in_time(const Calibration& c, bool is_slow) {
  if (!c.rough.found || !c.rough.both_directions) return std::nullopt;
  const method::gravity::VibrationLine* line = largest_line(c, is_slow);
  if (line == nullptr) return Measured{0, {}};
  const double percent = 100 * line->amplitude_Nm / c.rough.gravity_Nm.value;
  return Measured{percent,
                  {is_slow ? Code{"cause.other_joint"} : Code{"cause.vibration"},
                   {{"amplitude_Nm", line->amplitude_Nm},
                    {"frequency_Hz", line->frequency_Hz},
                    {"period_s", 1 / line->frequency_Hz},
                    {"percent", percent}}}};
}

std::optional<Measured> vibration(const Calibration& c) { return periodic_in_time(c, false); }

/// Near a harmonic of an oscillation it does not average out over its cycles: what of its amplitude
/// is left in the mean loop, in percent of friction.
std::optional<Measured> vibration_in_loops(const Calibration& c) {
  const double friction = c.hysteresis.midline_friction_Nm;
  if (!(friction > 0) || c.hysteresis.oscillations.empty()) return std::nullopt;
  Measured largest{0, {}};
  for (const method::gravity::VibrationLine& line : c.rough.vibration) {
    double left = 1;  // the least that one of the oscillations leaves
    for (const method::hysteresis::Oscillation& o : c.hysteresis.oscillations) {
      const double order = std::max(1.0, std::round(line.frequency_Hz / o.frequency_Hz));
      const double away_cycles =
          std::abs(line.frequency_Hz / o.frequency_Hz - order) * std::max(1.0, o.steady_cycles);
      left = std::min(left, 1 / std::max(1.0, std::numbers::pi * away_cycles));
    }
    const double percent = 100 * left * line.amplitude_Nm / friction;
    if (percent < largest.value) continue;
    largest = {percent,
               {"cause.vibration_in_loops",
                {{"amplitude_Nm", line.amplitude_Nm}, {"frequency_Hz", line.frequency_Hz}}}};
  }
  return largest;
}

/// How far apart the loops' mid-line and the model put gravity, in percent of it, where they
/// disagree: torques that are not logged to the same scale.
std::optional<Measured> scale_of_loops(const Calibration& c) {
  for (const method::selection::CrossCheck& check : c.cross_checks.checks) {
    if (check.estimator != method::hysteresis::Estimator::midline || !check.counts()) continue;
    const double apart = std::abs(check.difference_percent) - check.difference_half_width_percent;
    return Measured{std::max(0.0, apart),
                    {"cause.scale_of_loops", {{"percent", check.difference_percent}}}};
  }
  return std::nullopt;
}

/// A course of the torque over the joint's angle, slower than the motor turns, that no term
/// describes: of a linkage, a worn rail, a hose that catches. In percent of friction.
std::optional<Measured> course_of_angle(const Calibration& c) {
  const double friction = largest_friction_Nm(c);
  if (!c.rough.found || !(friction > 0)) return std::nullopt;
  constexpr double of_motor = 0.9;  // periods to its turn
  double amplitude_Nm = 0;
  for (const method::gravity::RippleLine& line : c.rough.ripple.lines) {
    if (line.periods_per_turn < of_motor) {
      amplitude_Nm = std::max(amplitude_Nm, line.amplitude_Nm);
    }
  }
  return Measured{100 * amplitude_Nm / friction,
                  {"cause.course_of_angle",
                   {{"amplitude_Nm", amplitude_Nm}, {"percent", 100 * amplitude_Nm / friction}}}};
}

/// An offset of the torque, which the curves of each direction contain, in percent of friction.
std::optional<Measured> offset_in_curves(const Calibration& c) {
  return measure_effect(c, "offset", largest_friction_Nm(c));
}

std::optional<Measured> other_joint(const Calibration& c) { return periodic_in_time(c, true); }

/// The same as a share of the friction.
std::optional<Measured> other_joint_on_friction(const Calibration& c) {
  std::optional<Measured> found = other_joint(c);
  const double friction = largest_friction_Nm(c);
  if (!found || !(friction > 0)) return std::nullopt;
  found->value *= c.rough.gravity_Nm.value / friction;
  return found;
}

/// Null where no other joint's angle is logged.
const joint::OtherJoint* farthest_of_others(const Calibration& c) {
  const joint::OtherJoint* farthest = nullptr;
  for (const joint::OtherJoint& other : c.manifest.other_joints) {
    if (other.samples == 0) continue;
    if (farthest == nullptr || other.travel_rad() > farthest->travel_rad()) farthest = &other;
  }
  return farthest;
}

/// How far another joint moved, by the logs, where no description says what that does.
std::optional<Measured> others_move(const Calibration& c) {
  const joint::OtherJoint* const farthest = farthest_of_others(c);
  if (farthest == nullptr) return std::nullopt;
  if (c.manifest.arm_gravity) return Measured{0, {}};
  const double travel_deg = joint::degrees_per_rad * farthest->travel_rad();
  return Measured{
      travel_deg,
      {"cause.others_move", {{"joint", in_quotes(farthest->name)}, {"travel_deg", travel_deg}}}};
}

/// How far another joint moved whose effect on gravity a description takes off: its inertia acts
/// all the same.
std::optional<Measured> others_move_beside_description(const Calibration& c) {
  const joint::OtherJoint* const farthest = farthest_of_others(c);
  if (farthest == nullptr || !c.manifest.arm_gravity) return std::nullopt;
  const double travel_deg = joint::degrees_per_rad * farthest->travel_rad();
  return Measured{
      travel_deg,
      {"cause.others_inertia", {{"joint", in_quotes(farthest->name)}, {"travel_deg", travel_deg}}}};
}

/// What the others' motion changed of gravity and was taken off, in percent of gravity.
std::optional<Measured> others_taken_off(const Calibration& c) {
  const std::optional<joint::ArmGravity>& arm = c.manifest.arm_gravity;
  if (!arm || arm->samples == 0 || !c.rough.found) return std::nullopt;
  const double gravity_Nm = c.manifest.drive.gear_ratio() * c.rough.gravity_Nm.value;
  return Measured{100 * arm->largest_Nm / gravity_Nm,
                  {"cause.others_taken_off",
                   {{"largest_Nm", arm->largest_Nm},
                    {"file", printable(arm->description)},
                    {"percent", arm->description_percent}}}};
}

/// How far gravity by the description is from what the recordings show, in percent of that: of both
/// as vectors, by size and angle.
std::optional<Measured> description_differs(const Calibration& c) {
  const std::optional<joint::ArmGravity>& arm = c.manifest.arm_gravity;
  if (!arm || !arm->own || arm->samples == 0 || !c.rough.found || !c.q_peak_rad) {
    return std::nullopt;
  }
  const double found_Nm = c.manifest.drive.gear_ratio() * c.rough.gravity_Nm.value;
  const double own_Nm = arm->own->amplitude_Nm();
  const double turned_rad = arm->own->q_peak_rad() - c.q_peak_rad->value;
  const double apart_Nm =
      std::hypot(own_Nm * std::cos(turned_rad) - found_Nm, own_Nm * std::sin(turned_rad));
  return Measured{100 * apart_Nm / found_Nm,
                  {"cause.description_differs",
                   {{"file", printable(arm->description)},
                    {"own_Nm", own_Nm},
                    {"own_deg", joint::degrees_per_rad * arm->own->q_peak_rad()},
                    {"found_Nm", found_Nm},
                    {"found_deg", joint::degrees_per_rad * c.q_peak_rad->value}}}};
}

std::optional<Measured> coloured_noise(const Calibration& c) {
  if (!c.rough.found || !c.rough.both_directions || !(c.rough.white_Nm > 0)) return std::nullopt;
  return Measured{100 * c.rough.coloured_Nm / c.rough.white_Nm,
                  {"cause.coloured_noise",
                   {{"coloured_Nm", c.rough.coloured_Nm}, {"white_Nm", c.rough.white_Nm}}}};
}

}  // namespace

std::vector<Rule> gravity_rules() {
  const auto reported = Verdict::usable;  // and corrected, or in the interval
  const auto doubtful = Verdict::doubtful;
  const auto unknown = Verdict::not_identifiable;
  return {
      // A twentieth of the friction, with some margin: friction that changes with the angle by a
      // twentieth is common, and looks like gravity.
      {{"friction_over_gravity", "%", 1250, friction_over_gravity},
       unknown,
       of_gravity,
       of_gravity,
       "record.with_load"},
      // Joints that are held move by less. Friction turns with the direction; gravity and inertia
      // are others with each posture.
      {{"others_move", "deg", 1, others_move},
       doubtful,
       of_gravity + of_friction,
       of_gravity + of_inertia,
       "record.others_at_rest_or_described"},
      // What changes slowly in time, by more than a small share, is gravity that changes.
      {{"gravity_in_time", "%", 0.5, other_joint},
       doubtful,
       of_gravity,
       of_gravity,
       "record.other_joints_at_rest"},
      // Against friction it need not be small beside gravity to be large; a law over few runs makes
      // several times as much of it.
      {{"gravity_in_time_on_friction", "%", 2, other_joint_on_friction},
       doubtful,
       of_friction,
       none,
       "record.other_joints_at_rest"},
      {{"others_inertia", "deg", 1, others_move_beside_description},
       doubtful,
       of_inertia,
       of_inertia,
       "record.other_joints_at_rest"},
      {{"others_taken_off", "%", 0.01, others_taken_off},
       reported,
       of_gravity,
       none,
       "record.other_joints_at_rest"},
      // Hoses and what a description leaves out are less; another zero, another sign or a payload
      // that it does not have are more, and make what is taken off wrong.
      {{"description_differs", "%", 30, description_differs},
       doubtful,
       of_gravity,
       of_gravity,
       "record.other_joints_at_rest"},
      {{"scale_of_loops", "%", 2, scale_of_loops},
       doubtful,
       of_loops,
       none,
       "record.torque_measured"},
      {{"course_of_angle", "%", 1, course_of_angle},
       doubtful,
       of_curve_alone,
       none,
       "record.sweep"},
      {{"offset_in_curves", "%", 2, offset_in_curves},
       doubtful,
       of_curve_alone,
       none,
       "record.sweep"},
      {{"motion_harmonics", "%", 0.5, motion_harmonics, true},
       reported,
       of_mass,
       none,
       "record.better_motion"},
      {{"ripple", "%", 0.1, ripple}, reported, of_gravity, none, "record.eight_positions"},
      {{"vibration", "%", 0.1, vibration}, reported, of_gravity, none, "record.sweep"},
      {{"vibration_in_loops", "%", 0.5, vibration_in_loops},
       doubtful,
       of_loops,
       none,
       "record.other_frequency"},
      {{"coloured_noise", "%", 50, coloured_noise}, reported, of_gravity, none, "record.sweep"}};
}

bool has_stated_no_gravity(const Calibration& c) {
  return c.manifest.known_gravity && c.manifest.known_gravity->amplitude_Nm() == 0;
}

Statement why_no_gravity(const Calibration& c) {
  if (has_points_alone(c)) return {"cause.gravity_taken_off"};
  return c.manifest.gravity_is_removed ? Statement{"cause.gravity_removed"}
                                       : Statement{"cause.no_gravity_stated"};
}

bool has_points_alone(const Calibration& c) {
  const auto& runs = c.viscous.runs;
  return c.speed_sources.empty() && !runs.empty() &&
         std::none_of(runs.begin(), runs.end(),
                      [](const method::viscous::ConstantSpeedRun& run) { return run.has_angle(); });
}

}  // namespace tribolog::verdict
