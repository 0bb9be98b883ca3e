// Torque ripple: what it does to oscillations at few positions, and what it says of the gear ratio.

#include "method/checks/torque_ripple.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "method/checks/check_outcome.h"
#include "method/checks/checked_recordings.h"
#include "method/hysteresis/position_mean.h"

namespace tribolog {
namespace {

constexpr double fewest_turns = 5;  // of the motor, to show a period

std::string in_words(const std::vector<RippleLine>& lines) {
  std::string words;
  for (const RippleLine& line : lines) {
    words += fmt::format("{}{:.3g} N·m at {:.2f} periods", words.empty() ? "" : ", ",
                         line.amplitude_Nm, line.periods_per_turn);
  }
  return words + " a motor turn";
}

/// Why a sweep cannot tell of ripple; empty: it can.
std::string why_not(const CogSweepResult& sweep, double gear_ratio) {
  if (!sweep.found)
    return "no gravity was found in a rough sweep, whose residual would show ripple";
  const double turns = gear_ratio * (sweep.highest_rad - sweep.lowest_rad) / (2 * std::numbers::pi);
  return turns < fewest_turns
             ? "the rough sweep does not turn the motor often enough to show a period"
             : "";
}

}  // namespace

DataCheck check_torque_ripple(const Dataset& dataset, const CogSweepResult& sweep) {
  // A ripple of this share shifts gravity torque by as much: what a good measurement wants.
  constexpr double most_percent = 0.3;
  DataCheck check;
  check.name = "torque_ripple";
  check.title = "Torque ripple in the oscillations";
  const double n = dataset.manifest.drive.gear_ratio();
  const std::string why = why_not(sweep, n);
  if (!why.empty()) return not_applicable(check.name, check.title, why);
  const std::vector<RippleLine>& lines = sweep.ripple.lines;
  std::vector<double> motor_angles;
  for (const Recording* r : dataset.with_role(Role::oscillation)) {
    const auto [low, high] = std::minmax_element(r->q_rad.begin(), r->q_rad.end());
    motor_angles.push_back(n * (*low + *high) / 2);
  }
  check.recording = to_string(Role::rough_sweep);
  check.measure =
      "ripple that the oscillations' positions do not average out, of the gravity torque";
  check.unit = percent_sign;
  check.at_most = most_percent;
  double left_Nm = 0;
  for (const RippleLine& line : lines) {
    if (motor_angles.empty()) break;
    left_Nm += line.amplitude_Nm * share_left_in_mean(line, motor_angles);
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

DataCheck check_ripple_period(const Dataset& dataset, const CogSweepResult& sweep) {
  // A motor's own ripple repeats a whole number of times a turn.
  constexpr double tolerated = 0.05;
  DataCheck check;
  check.name = "ripple_period";
  check.title = "Gear ratio against the ripple's period";
  const double n = dataset.manifest.drive.gear_ratio();
  const std::string why = why_not(sweep, n);
  if (!why.empty()) return not_applicable(check.name, check.title, why);
  const std::vector<RippleLine>& lines = sweep.ripple.lines;
  if (lines.empty()) {
    return not_applicable(check.name, check.title,
                          "no ripple stands out; without it nothing in these logs checks the gear "
                          "ratio");
  }
  double farthest = 0;
  for (const RippleLine& line : lines) {
    farthest =
        std::max(farthest, std::abs(line.periods_per_turn - std::round(line.periods_per_turn)));
  }
  check.recording = to_string(Role::rough_sweep);
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

}  // namespace tribolog
