#include "plan/experiment_plan.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/requirements.h"
#include "plan/plan_builder.h"

namespace tribolog::plan {
namespace {

ExperimentPlan plan_with(const AssumedJoint& joint, double effort,
                         const std::vector<joint::Role>& roles) {
  ExperimentPlan plan;
  plan.joint = joint;
  plan.effort = effort;
  const WorkingRange range = working_range(joint, plan.remarks);
  Timeline timeline(plan, range);
  const auto add = [&](joint::Role role, auto add_part) {
    if (roles.empty() || std::find(roles.begin(), roles.end(), role) != roles.end()) {
      add_part(range, timeline, plan);
    } else {
      PlannedPart& part = plan.parts.emplace_back();
      part.role = role;
      part.state = PartState::not_asked;
    }
  };
  add(joint::Role::rough_sweep, add_rough_sweep);
  add(joint::Role::precise_sweep, add_precise_sweep);
  add(joint::Role::oscillation, add_oscillations);
  add(joint::Role::constant_speed, add_runs);
  add(joint::Role::break_away, add_ramps);
  return plan;
}

std::vector<joint::Role> roles_of(joint::Quantity quantity) {
  using joint::Quantity;
  using joint::Role;
  switch (quantity) {
    case Quantity::cog_angle:
    case Quantity::gravity_torque:
    case Quantity::surrogate_mass:
      return {Role::rough_sweep, Role::precise_sweep};
    case Quantity::break_away_torque:
      return {Role::oscillation, Role::break_away};
    case Quantity::bristle_stiffness:
    case Quantity::bristle_damping:
      return {Role::oscillation};
    case Quantity::inertia:
    case Quantity::coulomb_torque:
    case Quantity::stribeck_speed:
    case Quantity::viscous_coefficient:
    case Quantity::viscous_curve:
      break;
  }
  return {Role::constant_speed};
}

}  // namespace

Statement stated(PartState state) {
  switch (state) {
    case PartState::planned:
      return {"plan_state.planned"};
    case PartState::later:
      return {"plan_state.later"};
    case PartState::limited:
      return {"plan_state.limited"};
    case PartState::not_asked:
      return {"plan_state.not_asked"};
    case PartState::impossible:
      break;
  }
  return {"plan_state.impossible"};
}

std::vector<joint::Role> roles_that_show(const std::vector<joint::Quantity>& quantities) {
  std::vector<joint::Role> roles;
  for (const joint::Quantity quantity : quantities) {
    for (const joint::Role role : roles_of(quantity)) {
      if (std::find(roles.begin(), roles.end(), role) == roles.end()) roles.push_back(role);
    }
  }
  return roles;
}

double ExperimentPlan::duration_s() const {
  return segments.empty() ? 0.0 : segments.back().end_s();
}

const PlannedPart& ExperimentPlan::part(joint::Role role) const {
  const auto it = std::find_if(parts.begin(), parts.end(),
                               [&](const PlannedPart& p) { return p.role == role; });
  if (it == parts.end())
    throw std::out_of_range("the plan has no row for " + joint::to_string(role));
  return *it;
}

bool ExperimentPlan::is_first_of_two() const {
  return std::any_of(parts.begin(), parts.end(),
                     [](const PlannedPart& p) { return p.state == PartState::later; });
}

std::size_t ExperimentPlan::segment_at(double t_s) const {
  const auto next =
      std::upper_bound(segments.begin(), segments.end(), t_s,
                       [](double t, const PlannedSegment& s) { return t < s.start_s; });
  return next == segments.begin() ? 0 : static_cast<std::size_t>(next - segments.begin()) - 1;
}

double ExperimentPlan::angle_rad(double t_s) const {
  if (segments.empty()) return 0;
  const PlannedSegment& s = segments[segment_at(t_s)];
  return s.motion->angle(t_s - s.start_s);
}

double ExperimentPlan::speed_rad_s(double t_s) const {
  if (segments.empty() || t_s < 0 || t_s > duration_s()) return 0;
  const PlannedSegment& s = segments[segment_at(t_s)];
  return s.motion->speed(t_s - s.start_s);
}

ExperimentPlan plan_experiment(const joint::JointFacts& facts, const PlanOptions& options) {
  const AssumedJoint joint = assume_joint(facts);
  if (options.effort) {
    require_positive(*options.effort, "effort", "");
    return plan_with(joint, *options.effort, options.roles);
  }
  if (!facts.time_budget_s) return plan_with(joint, 1, options.roles);
  constexpr std::array efforts{4.0, 3.0, 2.0, 1.5, 1.0, 0.7, 0.5, 0.35, 0.25};
  for (const double effort : efforts) {
    ExperimentPlan plan = plan_with(joint, effort, options.roles);
    if (plan.duration_s() <= *facts.time_budget_s) return plan;
  }
  ExperimentPlan shortest = plan_with(joint, efforts.back(), options.roles);
  shortest.remarks.push_back(
      {"plan.longer_than_budget",
       {{"duration", shortest.duration_s()}, {"budget", *facts.time_budget_s}}});
  return shortest;
}

}  // namespace tribolog::plan
