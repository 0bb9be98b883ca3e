#pragma once
// Oscillations of a scenario fitted with LuGre, and what should come back.

#include <map>
#include <string>
#include <vector>

#include "method/hysteresis/lugre_fit.h"
#include "simulate/scenario.h"

namespace tribolog::test {

/// Its oscillations alone; z is recorded as the scenario says.
std::vector<joint::Recording> oscillations_of(const simulate::Scenario& scenario);

/// Nothing acts beside the contact.
method::hysteresis::KnownOfLoops contact_alone();

/// The fit with its signals.
method::hysteresis::FittedLuGre fitted_loops(
    const std::vector<joint::Recording>& oscillations,
    const method::hysteresis::KnownOfLoops& known = contact_alone());
inline method::hysteresis::LuGreFit fit_loops(const std::vector<joint::Recording>& oscillations) {
  return fitted_loops(oscillations).fit;
}
inline method::hysteresis::LuGreFit fit_loops(const simulate::Scenario& scenario) {
  return fit_loops(oscillations_of(scenario));
}

/// What LuGreFit::parameters should hold for a scenario with LuGre in pre-sliding, by name.
std::map<method::hysteresis::LuGreParameterName, double> true_parameters(
    const simulate::Scenario& scenario);

/// The oscillation at eight motor positions, with ripple of 1 and 6 periods a turn at the phases.
simulate::Scenario at_eight_positions(simulate::Scenario scenario, double phase_1_rad,
                                      double phase_6_rad);

}  // namespace tribolog::test
