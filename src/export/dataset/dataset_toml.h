#pragma once
// The manifest of a simulated dataset.

#include <string>
#include <vector>

#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog {

/// A manifest that read_dataset accepts, for recordings written by recording_csv() beside it under
/// their names, and for the robot's description beside it, if the scenario names one. It states the
/// torque as motor torque before the gear, and the friction of the scenario's sweeps and runs as
/// the known reference, where speed alone says it.
std::string dataset_toml(const Scenario& scenario, const std::vector<Recording>& recordings);

/// Name of the copy of the robot's description beside the manifest; empty where there is none.
std::string description_beside(const Scenario& scenario);

}  // namespace tribolog
