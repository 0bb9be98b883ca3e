#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "joint/dataset.h"
#include "joint/degrees.h"
#include "method/checks/check_outcome.h"
#include "method/checks/checked_recordings.h"
#include "method/checks/data_check.h"
#include "method/checks/data_checks.h"
#include "method/checks/scale_causes.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/position_mean.h"

namespace tribolog::method::checks {

// Torque ripple as the sweep's residual shows it.

namespace {

constexpr double fewest_turns = 5;  // of the motor, to show a period

std::string in_words(const std::vector<gravity::RippleLine>& lines) {
  std::string words;
  for (const gravity::RippleLine& line : lines) {
    words += fmt::format("{}{:.3g} N·m at {:.2f} periods", words.empty() ? "" : ", ",
                         line.amplitude_Nm, line.periods_per_turn);
  }
  return words + " a motor turn";
}

/// Why a sweep cannot tell of ripple; empty: it can.
std::string why_not(const gravity::CogSweepResult& sweep, double gear_ratio) {
  if (!sweep.found)
    return "no gravity was found in a rough sweep, whose residual would show ripple";
  const double turns = gear_ratio * (sweep.highest_rad - sweep.lowest_rad) / (2 * std::numbers::pi);
  return turns < fewest_turns
             ? "the rough sweep does not turn the motor often enough to show a period"
             : "";
}

/// Whether the oscillations' positions average the ripple out.
DataCheck check_torque_ripple(const joint::Dataset& dataset, const gravity::CogSweepResult& sweep) {
  // A ripple of this share shifts gravity torque by as much: what a good measurement wants.
  constexpr double most_percent = 0.3;
  DataCheck check;
  check.name = "torque_ripple";
  check.title = "Torque ripple in the oscillations";
  const double n = dataset.manifest.drive.gear_ratio();
  const std::string why = why_not(sweep, n);
  if (!why.empty()) return not_applicable(check.name, check.title, why);
  const std::vector<gravity::RippleLine>& lines = sweep.ripple.lines;
  std::vector<double> motor_angles;
  for (const joint::Recording* r : dataset.with_role(joint::Role::oscillation)) {
    const auto [low, high] = std::minmax_element(r->q_rad.begin(), r->q_rad.end());
    motor_angles.push_back(n * (*low + *high) / 2);
  }
  check.recording = joint::to_string(joint::Role::rough_sweep);
  check.measure =
      "ripple that the oscillations' positions do not average out, of the gravity torque";
  check.unit = percent_sign;
  check.at_most = most_percent;
  double left_Nm = 0;
  for (const gravity::RippleLine& line : lines) {
    if (motor_angles.empty()) break;
    left_Nm += line.amplitude_Nm * hysteresis::share_left_in_mean(line, motor_angles);
  }
  check.measured = 100 * left_Nm / sweep.gravity_Nm.value;
  check.found = lines.empty() ? "no ripple stands out of the noise of the sweep"
                              : "ripple of " + in_words(lines);
  check.state = passed_or_fails(check);
  if (check.state == CheckState::passed) return check;
  check.found += fmt::format("; {} oscillation{} cannot average it out", motor_angles.size(),
                             motor_angles.size() == 1 ? " at one position" : "s");
  check.consequence = fmt::format(
      "over a micro-oscillation the ripple is a constant torque, up to {:.3g} N·m, that is taken "
      "for gravity",
      left_Nm);
  check.experiment =
      "repeat the oscillation at eight positions spread evenly over one turn of the "
      "motor";
  return check;
}

/// Whether the ripple repeats a whole number of times a motor turn, as the stated gear ratio has
/// it.
DataCheck check_ripple_period(const joint::Dataset& dataset, const gravity::CogSweepResult& sweep) {
  // A motor's own ripple repeats a whole number of times a turn.
  constexpr double tolerated = 0.05;
  DataCheck check;
  check.name = "ripple_period";
  check.title = "Gear ratio against the ripple's period";
  const double n = dataset.manifest.drive.gear_ratio();
  const std::string why = why_not(sweep, n);
  if (!why.empty()) return not_applicable(check.name, check.title, why);
  const std::vector<gravity::RippleLine>& lines = sweep.ripple.lines;
  if (lines.empty()) {
    return not_applicable(check.name, check.title,
                          "no ripple stands out; without it nothing in these logs checks the gear "
                          "ratio");
  }
  double farthest = 0;
  for (const gravity::RippleLine& line : lines) {
    farthest =
        std::max(farthest, std::abs(line.periods_per_turn - std::round(line.periods_per_turn)));
  }
  check.recording = joint::to_string(joint::Role::rough_sweep);
  check.measure = "distance of the ripple's periods a motor turn from a whole number";
  check.unit = pure_number;
  check.at_most = tolerated;
  check.measured = farthest;
  check.found = "ripple of " + in_words(lines);
  check.state = farthest <= tolerated ? CheckState::passed : CheckState::warns;
  if (check.state == CheckState::passed) return check;
  check.found += fmt::format(
      "; the motor's own ripple repeats a whole number of times: is the gear ratio really {:.6g}?",
      n);
  check.consequence =
      "a wrong gear ratio leaves angles and motor torques as they are, and scales "
      "every torque, mass and speed of the other side";
  check.experiment = "turn the joint by a known angle and count the motor's turns";
  return check;
}

}  // namespace

// Checks that need the place and size of gravity, which the sweeps give.

namespace {

DataCheck check_oscillation_at_peak(const joint::Dataset& dataset,
                                    const std::optional<statistics::Estimate>& q_peak_rad) {
  constexpr double warning_deg = 2;  // costs 6e-4 of gravity torque
  constexpr double most_deg = 10;    // from here on an angle's error of 1° costs 0.3 % and more
  DataCheck check;
  check.name = "oscillation_at_peak";
  check.title = "Oscillation at the gravity peak";
  const auto oscillations = dataset.with_role(joint::Role::oscillation);
  if (oscillations.empty() || !q_peak_rad) {
    return not_applicable(check.name, check.title,
                          oscillations.empty() ? "no oscillation was recorded"
                                               : "the angle of the gravity peak is not known");
  }
  double centre = 0;
  for (const joint::Recording* r : oscillations) {
    const auto [low, high] = std::minmax_element(r->q_rad.begin(), r->q_rad.end());
    centre += (*low + *high) / 2 / static_cast<double>(oscillations.size());
  }
  const double off = std::remainder(centre - q_peak_rad->value, 2 * std::numbers::pi);
  check.recording = oscillations.size() == 1 ? oscillations.front()->name : "all";
  check.measure = "distance of the oscillation's centre from the gravity peak";
  check.unit = "deg";
  check.at_most = warning_deg;
  check.measured = std::abs(off) * joint::degrees_per_rad;
  check.found = fmt::format("centre at {:.3f}°, peak at {:.3f}°: gravity is {:.3g} % smaller there",
                            centre * joint::degrees_per_rad,
                            q_peak_rad->value * joint::degrees_per_rad, 100 * (1 - std::cos(off)));
  check.state = passed_or_warns_up_to(most_deg, check);
  if (check.state == CheckState::passed) return check;
  check.consequence = fmt::format(
      "the cosine corrects for it, but an error of 0.1° of the peak's angle then costs {:.2g} % of "
      "gravity torque and mass, at the peak nothing",
      100 * std::abs(std::tan(off)) * 0.1 / joint::degrees_per_rad);
  check.experiment = fmt::format("repeat the oscillation about {:.2f}°",
                                 q_peak_rad->value * joint::degrees_per_rad);
  return check;
}

DataCheck check_gravity_within_torque(const gravity::CogSweepResult& sweep) {
  constexpr double warning_ratio = 1.5;
  constexpr double most_ratio = 3;
  DataCheck check;
  check.name = "gravity_within_torque";
  check.title = "Gravity within the measured torque";
  if (!sweep.found) {
    return not_applicable(check.name, check.title, "no gravity was found in a sweep");
  }
  double largest_torque = 0;
  double largest_cos = 0;
  for (const joint::Recording* r : sweep.recordings) {
    for (std::size_t i = 0; i < r->size(); ++i) {
      largest_torque = std::max(largest_torque, std::abs(r->torque_Nm[i]));
      largest_cos = std::max(largest_cos, std::abs(std::cos(r->q_rad[i] - sweep.q_peak_rad.value)));
    }
  }
  check.recording = sweep.recordings.size() == 1 ? sweep.recordings.front()->name : "all";
  check.measure = "gravity torque that was fitted / largest torque measured";
  check.unit = pure_number;
  check.at_most = warning_ratio;
  check.measured = sweep.gravity_Nm.value * largest_cos / largest_torque;
  check.found = fmt::format("{:.4g} N·m fitted, {:.4g} N·m measured, at the motor",
                            sweep.gravity_Nm.value * largest_cos, largest_torque);
  check.state = passed_or_warns_up_to(most_ratio, check);
  if (check.state == CheckState::passed) return check;
  check.found += "; a large offset would have to balance it";
  check.consequence =
      "the torque does not follow the cosine of this angle: an angle in radians "
      "taken for degrees, a range too short, or a spring that carries the arm";
  check.experiment = "state the angle's unit as it is, and sweep over at least 60°";
  return check;
}

}  // namespace

void add_gravity_checks(const joint::Dataset& dataset, const gravity::CogSweepResult& sweep,
                        const gravity::RunGravityResult& runs,
                        const std::optional<statistics::Estimate>& q_peak_rad,
                        DataChecksResult& result) {
  result.checks.push_back(check_oscillation_at_peak(dataset, q_peak_rad));
  result.checks.push_back(check_gravity_within_torque(sweep));
  std::optional<FoundGravity> found;
  if (runs.found) found = FoundGravity{runs.gravity_Nm, runs.q_peak_rad.value};
  if (sweep.found) found = FoundGravity{sweep.gravity_Nm, sweep.q_peak_rad.value};
  result.checks.push_back(check_static_torque(dataset.manifest, found));
  result.checks.push_back(check_torque_ripple(dataset, sweep));
  result.checks.push_back(check_ripple_period(dataset, sweep));
}

}  // namespace tribolog::method::checks
