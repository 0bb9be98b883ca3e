#pragma once
// A joint that follows a plan: the log that a perfect recording of it would be.
//
// Friction in sweeps, runs and travels is the scenario's static law. Each oscillation is LuGre's,
// from a contact that the travel before left loaded; ramps slide from an unloaded one, are caught
// where they have travelled as far as the plan allows, and are led back.

#include "plan/experiment_plan.h"
#include "simulate/simulate_joint.h"

namespace tribolog::plan {

/// The whole log at a sampling rate, without noise. @param joint a LuGre contact and a static law
/// of sliding; its experiments and its noise are not looked at.
/// @throw std::invalid_argument if the plan has no segments or the joint is of another kind.
joint::Recording simulate_plan(const ExperimentPlan& plan, const simulate::Scenario& joint,
                               double sample_rate_Hz);

/// The recordings that a dataset would cut out of such a log by the plan's time windows, without
/// noise, in the order of time.
std::vector<simulate::IdealRecording> cut_by_plan(const ExperimentPlan& plan,
                                                  const joint::Recording& log,
                                                  double sample_rate_Hz);

/// Name of the log in the skeleton of a dataset.
inline constexpr const char* planned_log_name = "log.csv";

}  // namespace tribolog::plan
