#pragma once
// The truth behind simulated logs, for whoever judges an identification.

#include <string>

#include "simulate/scenario.h"

namespace tribolog {

/// JSON with the gravity peak, the mass and the true surrogate mass, gravity torque on both sides
/// of the gear, the parameters of both friction models, inertias, noise and seed. Keys carry their
/// units; their order is fixed.
std::string truth_json(const Scenario& scenario);

}  // namespace tribolog
