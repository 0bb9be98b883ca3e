#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

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

Statement stated(const std::vector<gravity::RippleLine>& lines) {
  std::vector<Statement> all;
  for (const gravity::RippleLine& line : lines) {
    all.push_back({"ripple_lines.line",
                   {{"amplitude_Nm", line.amplitude_Nm}, {"periods", line.periods_per_turn}}});
  }
  return {"ripple_lines.found", {{"lines", all}}};
}

/// Why a sweep cannot show ripple; empty: it can.
Statement why_not(const gravity::CogSweepResult& sweep, double gear_ratio) {
  if (!sweep.found) return {"not_applicable.no_sweep_residual"};
  const double turns = gear_ratio * (sweep.highest_rad - sweep.lowest_rad) / (2 * std::numbers::pi);
  return turns < fewest_turns ? Statement{"not_applicable.sweep_too_short_for_ripple"}
                              : Statement{};
}

/// Whether the oscillations' positions average the ripple out.
DataCheck check_torque_ripple(const joint::Dataset& dataset, const gravity::CogSweepResult& sweep) {
  // A ripple of this share shifts gravity torque by as much: what a good measurement wants.
  constexpr double most_percent = 0.3;
  DataCheck check;
  check.name = CheckName::torque_ripple;
  const double n = dataset.manifest.drive.gear_ratio();
  const Statement why = why_not(sweep, n);
  if (!why.empty()) return not_applicable(check.name, why);
  const std::vector<gravity::RippleLine>& lines = sweep.ripple.lines;
  std::vector<double> motor_angles;
  for (const joint::Recording* r : dataset.with_role(joint::Role::oscillation)) {
    const auto [low, high] = std::minmax_element(r->q_rad.begin(), r->q_rad.end());
    motor_angles.push_back(n * (*low + *high) / 2);
  }
  check.recording = joint::to_string(joint::Role::rough_sweep);
  check.measure = {"measure.ripple_left_in_mean"};
  check.unit = percent_sign;
  check.at_most = most_percent;
  double left_Nm = 0;
  for (const gravity::RippleLine& line : lines) {
    if (motor_angles.empty()) break;
    left_Nm += line.amplitude_Nm * hysteresis::share_left_in_mean(line, motor_angles);
  }
  check.measured = 100 * left_Nm / sweep.gravity_Nm.value;
  check.found = lines.empty() ? Statement{"ripple_lines.none"} : stated(lines);
  check.state = passed_or_fails(check);
  if (check.state == CheckState::passed) return check;
  check.found.add({"torque_ripple.not_averaged_out", {{"oscillations", motor_angles.size()}}});
  check.consequence = {"torque_ripple.taken_for_gravity", {{"ripple_Nm", left_Nm}}};
  check.experiment = {"torque_ripple.oscillate_at_eight_positions"};
  return check;
}

/// Whether the ripple repeats a whole number of times per motor turn, given the stated gear ratio.
DataCheck check_ripple_period(const joint::Dataset& dataset, const gravity::CogSweepResult& sweep) {
  // A motor's own ripple repeats a whole number of times a turn.
  constexpr double tolerated = 0.05;
  DataCheck check;
  check.name = CheckName::ripple_period;
  const double n = dataset.manifest.drive.gear_ratio();
  const Statement why = why_not(sweep, n);
  if (!why.empty()) return not_applicable(check.name, why);
  const std::vector<gravity::RippleLine>& lines = sweep.ripple.lines;
  if (lines.empty()) {
    return not_applicable(check.name, {"not_applicable.no_ripple_for_gear_ratio"});
  }
  double farthest = 0;
  for (const gravity::RippleLine& line : lines) {
    farthest =
        std::max(farthest, std::abs(line.periods_per_turn - std::round(line.periods_per_turn)));
  }
  check.recording = joint::to_string(joint::Role::rough_sweep);
  check.measure = {"measure.ripple_periods_off"};
  check.unit = pure_number;
  check.at_most = tolerated;
  check.measured = farthest;
  check.found = stated(lines);
  check.state = farthest <= tolerated ? CheckState::passed : CheckState::warns;
  if (check.state == CheckState::passed) return check;
  check.found.add({"ripple_period.is_gear_ratio_right", {{"gear_ratio", n}}});
  check.consequence = {"ripple_period.other_side_wrong"};
  check.experiment = {"ripple_period.count_turns"};
  return check;
}

}  // namespace

// Checks that need angle and size of gravity, which the sweeps give.

namespace {

DataCheck check_oscillation_at_peak(const joint::Dataset& dataset,
                                    const std::optional<statistics::Estimate>& q_peak_rad) {
  constexpr double warning_deg = 2;  // costs 6e-4 of gravity torque
  constexpr double most_deg = 45;
  DataCheck check;
  check.name = CheckName::oscillation_at_peak;
  const auto oscillations = dataset.with_role(joint::Role::oscillation);
  if (oscillations.empty() || !q_peak_rad) {
    return not_applicable(check.name, oscillations.empty() ? Code{"not_applicable.no_oscillation"}
                                                           : Code{"not_applicable.peak_unknown"});
  }
  double centre = 0;
  for (const joint::Recording* r : oscillations) {
    const auto [low, high] = std::minmax_element(r->q_rad.begin(), r->q_rad.end());
    centre += (*low + *high) / 2 / static_cast<double>(oscillations.size());
  }
  const double off = std::remainder(centre - q_peak_rad->value, std::numbers::pi);  // or the trough
  check.recording = oscillations.size() == 1 ? oscillations.front()->name : "all";
  check.measure = {"measure.distance_from_peak"};
  check.unit = "deg";
  check.at_most = warning_deg;
  check.measured = std::abs(off) * joint::degrees_per_rad;
  check.found = {"oscillation_at_peak.centre",
                 {{"centre_deg", centre * joint::degrees_per_rad},
                  {"peak_deg", q_peak_rad->value * joint::degrees_per_rad},
                  {"smaller_percent", 100 * (1 - std::cos(off))}}};
  check.state = passed_or_warns_up_to(most_deg, check);
  if (check.state == CheckState::passed) return check;
  // What the peak's own interval leaves open: the interval of the mass has it.
  const double cost_percent = 100 * std::abs(std::tan(off)) * q_peak_rad->half_width();
  check.consequence = {"oscillation_at_peak.error_of_peak_costs",
                       {{"angle_deg", q_peak_rad->half_width() * joint::degrees_per_rad},
                        {"cost_percent", cost_percent}}};
  check.experiment = {"oscillation_at_peak.repeat_about",
                      {{"peak_deg", q_peak_rad->value * joint::degrees_per_rad}}};
  return check;
}

DataCheck check_gravity_within_torque(const joint::Dataset& dataset,
                                      const gravity::CogSweepResult& sweep) {
  constexpr double warning_ratio = 1.5;
  constexpr double most_ratio = 3;
  DataCheck check;
  check.name = CheckName::gravity_within_torque;
  if (!sweep.found) {
    return not_applicable(check.name, {"not_applicable.no_gravity_in_sweep"});
  }
  double largest_torque = 0;
  double largest_cos = 0;
  const std::vector<const joint::Recording*> recordings =
      dataset.with_role(joint::Role::rough_sweep);
  for (const joint::Recording* r : recordings) {
    for (std::size_t i = 0; i < r->size(); ++i) {
      largest_torque = std::max(largest_torque, std::abs(r->torque_Nm[i]));
      largest_cos = std::max(largest_cos, std::abs(std::cos(r->q_rad[i] - sweep.q_peak_rad.value)));
    }
  }
  check.recording = recordings.size() == 1 ? recordings.front()->name : "all";
  check.measure = {"measure.fitted_of_largest_torque"};
  check.unit = pure_number;
  check.at_most = warning_ratio;
  check.measured = sweep.gravity_Nm.value * largest_cos / largest_torque;
  check.found = {
      "gravity_within_torque.fitted",
      {{"fitted_Nm", sweep.gravity_Nm.value * largest_cos}, {"measured_Nm", largest_torque}}};
  check.state = passed_or_warns_up_to(most_ratio, check);
  if (check.state == CheckState::passed) return check;
  check.found.add({"gravity_within_torque.offset_would_balance"});
  check.consequence = {"gravity_within_torque.does_not_follow_cosine"};
  check.experiment = {"gravity_within_torque.sweep_farther"};
  return check;
}

}  // namespace

std::vector<DataCheck> gravity_checks(const joint::Dataset& dataset,
                                      const GravityResults& gravity) {
  const gravity::CogSweepResult& sweep = gravity.rough;
  std::optional<FoundGravity> found;
  if (sweep.found) found = FoundGravity{sweep.gravity_Nm, sweep.q_peak_rad.value};
  if (const auto* of_model = gravity.masses.find(hysteresis::Estimator::model)) {
    found = FoundGravity{of_model->gravity_Nm, of_model->q_rad};
  }
  // A gravity that is hardly there has no peak to speak of (the verdict's friction_over_gravity).
  constexpr double least_of_friction = 0.08;
  const bool has_peak = !sweep.found || !sweep.coulomb_Nm ||
                        sweep.gravity_Nm.value > least_of_friction * sweep.coulomb_Nm->value;
  return {check_oscillation_at_peak(dataset, has_peak ? gravity.q_peak_rad : std::nullopt),
          check_gravity_within_torque(dataset, sweep), check_static_torque(dataset.manifest, found),
          check_torque_ripple(dataset, sweep), check_ripple_period(dataset, sweep)};
}

}  // namespace tribolog::method::checks
