#pragma once
// A simulated dataset on disk: recordings, manifest, and the truth behind them.

#include <string>
#include <vector>

#include "joint/recording.h"
#include "simulate/robot_log.h"
#include "simulate/scenario.h"

namespace tribolog::exports::simulation {

/// A manifest that read_dataset accepts, for recordings written by recording_csv() beside it under
/// their names, and for the robot's description beside it, if the scenario names one. It states the
/// torque as motor torque before the gear, and the friction of the scenario's sweeps and runs as
/// the known reference, where speed alone says it.
std::string dataset_toml(const simulate::Scenario& scenario,
                         const std::vector<joint::Recording>& recordings);

/// Name of the copy of the robot's description beside the manifest; empty where there is none.
std::string description_beside(const simulate::Scenario& scenario);

// A recording as CSV, in SI: t_s,q_rad[,dq_rad_s],torque_Nm[,z_rad][,dz_rad_s]; i_A instead of
// torque_Nm where the controller logs current.

/// One header row and one row a sample, LF line ends. Every number is the shortest that reads back
/// to the same double, or has the decimals of `form`. Signals that the recording does not have are
/// left out.
/// @throw std::invalid_argument if a signal is not as long as the time.
std::string recording_csv(const joint::Recording& recording, const simulate::LogForm& form = {});

// The truth behind simulated logs, for whoever judges an identification.

/// JSON with the gravity peak, the mass and the true surrogate mass, gravity torque on both sides
/// of the gear, inertias, noise and seed. "presliding" and "sliding" name the friction models of
/// the oscillation and of sweeps and runs, with the parameters that were simulated; they are the
/// same where the dynamic model drove all. Keys carry their units; their order is fixed.
std::string truth_json(const simulate::Scenario& scenario);

// A simulated dataset on disk.

/// Writes one CSV a recording, the robot's description (as the scenario holds its text), truth.json
/// and, last, dataset.toml: where dataset.toml is, everything it names is complete. The directory
/// is made where it is missing; files of these names are replaced, others stay.
/// @param inputs files that must not be replaced: the scenario's.
/// @throw UsageError for one of the inputs. OutputError if a file cannot be written; every file is
/// as it was then.
/// @throw std::invalid_argument if a recording's name is no plain file name.
void write_simulation(const simulate::Scenario& scenario,
                      const std::vector<joint::Recording>& recordings, const std::string& directory,
                      const std::vector<std::string>& inputs = {});

/// Writes a robot's log, robot.csv, with its manifest, robot.toml, and the truth of each joint,
/// truth.json: {"schema", "joints"}. As write_simulation() otherwise.
void write_robot_simulation(const std::vector<simulate::Scenario>& joints,
                            const simulate::RobotLog& log, const std::string& directory,
                            const std::vector<std::string>& inputs = {});

}  // namespace tribolog::exports::simulation
