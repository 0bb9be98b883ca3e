// Torque ripple: what it does to oscillations at few positions, and what it says of the gear ratio.

#include "stages/data_checks/torque_ripple.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include "stages/data_checks/check_list.h"

namespace tribolog {
namespace {

constexpr const char* too_short =
    "no rough sweep with torque turns the motor often enough to show a period";

std::string in_words(const std::vector<RippleLine>& lines) {
  std::string words;
  for (const RippleLine& line : lines) {
    words += fmt::format("{}{:.3g} N·m at {:.2f} periods", words.empty() ? "" : ", ",
                         line.amplitude_Nm, line.periods_per_turn);
  }
  return words + " a motor turn";
}

/// The share of a ripple that the mean over the oscillations' positions leaves.
double left_by_positions(const std::vector<const CheckedRecording*>& oscillations,
                         double periods_per_turn, double gear_ratio) {
  std::complex<double> sum = 0;
  for (const CheckedRecording* r : oscillations) {
    const double motor_rad = gear_ratio * (r->lowest_rad + r->highest_rad) / 2;
    sum += std::polar(1.0, periods_per_turn * motor_rad);
  }
  return std::abs(sum) / static_cast<double>(oscillations.size());
}

}  // namespace

DataCheck check_torque_ripple(const CheckedDataset& data) {
  // A ripple of this share shifts gravity torque by as much: what a good measurement wants.
  constexpr double most_percent = 0.3;
  DataCheck check;
  check.name = "torque_ripple";
  check.title = "Torque ripple in the oscillations";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  const TorqueRipple ripple = find_torque_ripple(data);
  if (ripple.motor_turns == 0) return not_applicable(check.name, check.title, too_short);
  const auto oscillations = data.with_role(Role::oscillation);
  check.recording = to_string(Role::rough_sweep);
  check.measure =
      "ripple that the oscillations' positions do not average out, of half the "
      "torque's range";
  check.unit = percent_sign;
  check.at_most = most_percent;
  double left_Nm = 0;
  const double n = data.manifest->drive.gear_ratio();
  for (const RippleLine& line : ripple.lines) {
    if (oscillations.empty()) break;
    left_Nm += line.amplitude_Nm * left_by_positions(oscillations, line.periods_per_turn, n);
  }
  check.measured = ripple.torque_range_Nm > 0 ? 200 * left_Nm / ripple.torque_range_Nm : 0.0;
  check.found = ripple.lines.empty() ? "no ripple stands out of the noise of the sweep"
                                     : "ripple of " + in_words(ripple.lines);
  check.state = *check.measured <= most_percent ? CheckState::passed : CheckState::fails;
  if (check.state == CheckState::passed) return check;
  check.found += fmt::format("; {} oscillation{} cannot average it out", oscillations.size(),
                             oscillations.size() == 1 ? " at one position" : "s");
  check.consequence = fmt::format(
      "over a micro-oscillation the ripple is a constant torque, up to {:.3g} N·m, that is taken "
      "for gravity",
      left_Nm);
  check.experiment =
      "repeat the oscillation at eight positions spread evenly over one turn of the "
      "motor";
  return check;
}

DataCheck check_ripple_period(const CheckedDataset& data) {
  // A motor's own ripple repeats a whole number of times a turn.
  constexpr double tolerated = 0.05;
  DataCheck check;
  check.name = "ripple_period";
  check.title = "Gear ratio against the ripple's period";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  const TorqueRipple ripple = find_torque_ripple(data);
  if (ripple.motor_turns == 0) return not_applicable(check.name, check.title, too_short);
  if (ripple.lines.empty()) {
    return not_applicable(check.name, check.title,
                          "no ripple stands out; without it nothing in these logs checks the gear "
                          "ratio");
  }
  double farthest = 0;
  for (const RippleLine& line : ripple.lines) {
    farthest =
        std::max(farthest, std::abs(line.periods_per_turn - std::round(line.periods_per_turn)));
  }
  check.recording = to_string(Role::rough_sweep);
  check.measure = "distance of the ripple's periods a motor turn from a whole number";
  check.unit = pure_number;
  check.at_most = tolerated;
  check.measured = farthest;
  check.found = "ripple of " + in_words(ripple.lines);
  check.state = farthest <= tolerated ? CheckState::passed : CheckState::warns;
  if (check.state == CheckState::passed) return check;
  check.found += fmt::format(
      "; the motor's own ripple repeats a whole number of times: is the gear ratio really {:.6g}?",
      data.manifest->drive.gear_ratio());
  check.consequence =
      "a wrong gear ratio leaves angles and motor torques as they are, and scales "
      "every torque, mass and speed of the other side";
  check.experiment = "turn the joint by a known angle and count the motor's turns";
  return check;
}

}  // namespace tribolog
