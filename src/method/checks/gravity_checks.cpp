// Checks that need the place and size of gravity, which the sweeps give.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "joint/degrees.h"
#include "method/checks/check_outcome.h"
#include "method/checks/checked_recordings.h"
#include "method/checks/data_checks.h"
#include "method/checks/static_torque.h"
#include "method/checks/torque_ripple.h"

namespace tribolog {
namespace {

DataCheck check_oscillation_at_peak(const Dataset& dataset,
                                    const std::optional<Estimate>& q_peak_rad) {
  constexpr double warning_deg = 2;  // costs 6e-4 of gravity torque
  constexpr double most_deg = 10;    // from here on an angle's error of 1° costs 0.3 % and more
  DataCheck check;
  check.name = "oscillation_at_peak";
  check.title = "Oscillation at the gravity peak";
  const auto oscillations = dataset.with_role(Role::oscillation);
  if (oscillations.empty() || !q_peak_rad) {
    return not_applicable(check.name, check.title,
                          oscillations.empty() ? "no oscillation was recorded"
                                               : "the angle of the gravity peak is not known");
  }
  double centre = 0;
  for (const Recording* r : oscillations) {
    const auto [low, high] = std::minmax_element(r->q_rad.begin(), r->q_rad.end());
    centre += (*low + *high) / 2 / static_cast<double>(oscillations.size());
  }
  const double off = std::remainder(centre - q_peak_rad->value, 2 * std::numbers::pi);
  check.recording = oscillations.size() == 1 ? oscillations.front()->name : "all";
  check.measure = "distance of the oscillation's centre from the gravity peak";
  check.unit = "deg";
  check.at_most = warning_deg;
  check.measured = std::abs(off) * degrees_per_rad;
  check.found = fmt::format("centre at {:.3f}°, peak at {:.3f}°: gravity is {:.3g} % smaller there",
                            centre * degrees_per_rad, q_peak_rad->value * degrees_per_rad,
                            100 * (1 - std::cos(off)));
  check.state = passed_or_warns_up_to(most_deg, check);
  if (check.state == CheckState::passed) return check;
  check.consequence = fmt::format(
      "the cosine corrects for it, but an error of 0.1° of the peak's angle then costs {:.2g} % of "
      "gravity torque and mass, at the peak nothing",
      100 * std::abs(std::tan(off)) * 0.1 / degrees_per_rad);
  check.experiment =
      fmt::format("repeat the oscillation about {:.2f}°", q_peak_rad->value * degrees_per_rad);
  return check;
}

DataCheck check_gravity_within_torque(const CogSweepResult& sweep) {
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
  for (const Recording* r : sweep.recordings) {
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

void add_gravity_checks(const Dataset& dataset, const CogSweepResult& sweep,
                        const RunGravityResult& runs, const std::optional<Estimate>& q_peak_rad,
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

}  // namespace tribolog
