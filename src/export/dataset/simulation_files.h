#pragma once
// A simulated dataset on disk.

#include <string>
#include <vector>

#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog {

/// Writes one CSV a recording, the robot's description (as the scenario holds its text), truth.json
/// and, last, dataset.toml: where dataset.toml is, everything it names is complete. The directory
/// is made where it is missing; files of these names are replaced, others stay.
/// @param inputs files that must not be replaced: the scenario's.
/// @throw UsageError for one of the inputs. OutputError if a file cannot be written; every file is
/// as it was then.
/// @throw std::invalid_argument if a recording's name is no plain file name.
void write_simulation(const Scenario& scenario, const std::vector<Recording>& recordings,
                      const std::string& directory, const std::vector<std::string>& inputs = {});

}  // namespace tribolog
