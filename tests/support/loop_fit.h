#pragma once
// Oscillations of a scenario fitted with LuGre, and what should come back.

#include <map>
#include <string>
#include <vector>

#include "method/hysteresis/lugre_fit.h"
#include "simulate/scenario.h"

namespace tribolog::test {

/// Its oscillations alone; z is recorded as the scenario says.
std::vector<Recording> oscillations_of(const Scenario& scenario);

LuGreFit fit_loops(const std::vector<Recording>& oscillations);
inline LuGreFit fit_loops(const Scenario& scenario) { return fit_loops(oscillations_of(scenario)); }

/// What LuGreFit::parameters should hold for a scenario with LuGre in pre-sliding, by name.
std::map<std::string, double> true_parameters(const Scenario& scenario);

/// The oscillation at eight motor positions, with ripple of 1 and 6 periods a turn at the phases.
Scenario at_eight_positions(Scenario scenario, double phase_1_rad, double phase_6_rad);

}  // namespace tribolog::test
