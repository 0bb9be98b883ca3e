#include "plan/experiment_plan.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/requirements.h"
#include "plan/plan_builder.h"

namespace tribolog::plan {
namespace {

ExperimentPlan plan_with(const AssumedJoint& joint, double effort) {
  ExperimentPlan plan;
  plan.joint = joint;
  plan.effort = effort;
  const WorkingRange range = working_range(joint, plan.remarks);
  Timeline timeline(plan, range);
  add_rough_sweep(range, timeline, plan);
  add_precise_sweep(range, timeline, plan);
  add_oscillations(range, timeline, plan);
  add_runs(range, timeline, plan);
  add_ramps(range, timeline, plan);
  return plan;
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
    case PartState::impossible:
      break;
  }
  return {"plan_state.impossible"};
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
    return plan_with(joint, *options.effort);
  }
  if (!facts.time_budget_s) return plan_with(joint, 1);
  constexpr std::array efforts{4.0, 3.0, 2.0, 1.5, 1.0, 0.7, 0.5, 0.35, 0.25};
  for (const double effort : efforts) {
    ExperimentPlan plan = plan_with(joint, effort);
    if (plan.duration_s() <= *facts.time_budget_s) return plan;
  }
  ExperimentPlan shortest = plan_with(joint, efforts.back());
  shortest.remarks.push_back(
      {"plan.longer_than_budget",
       {{"duration", shortest.duration_s()}, {"budget", *facts.time_budget_s}}});
  return shortest;
}

}  // namespace tribolog::plan
