#pragma once
// The truth behind simulated logs, for whoever judges an identification.

#include <string>

#include "simulate/scenario.h"

namespace tribolog {

/// JSON with the gravity peak, the mass and the true surrogate mass, gravity torque on both sides
/// of the gear, inertias, noise and seed. "presliding" and "sliding" name the friction models of
/// the oscillation and of sweeps and runs, with the parameters that were simulated; they are the
/// same where the dynamic model drove all. Keys carry their units; their order is fixed.
std::string truth_json(const Scenario& scenario);

}  // namespace tribolog
