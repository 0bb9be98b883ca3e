#pragma once
// A scenario to a dataset, without files in between.

#include "joint/dataset.h"
#include "simulate/scenario.h"

namespace tribolog {

/// The recordings of simulate_joint() with the facts that a manifest would state: motor torque at
/// the motor, and the friction that was simulated as the known curve. Inputs are empty.
/// @throw std::invalid_argument as simulate_joint().
Dataset simulated_dataset(const Scenario& scenario);

/// The same for recordings of it that were made already.
Dataset simulated_dataset(const Scenario& scenario, std::vector<Recording> recordings);

}  // namespace tribolog
