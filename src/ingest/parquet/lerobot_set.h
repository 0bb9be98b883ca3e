#pragma once
// Data sets of LeRobot (https://github.com/huggingface/lerobot), versions 2.0 to 3.0: a folder with
// meta/info.json, which names the elements of the lists in data/chunk-000/*.parquet.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::parquet {

struct LeRobotSet {
  double rate_Hz{};  ///< 0: not stated.
  /// By feature, "observation.state": the names of its elements.
  std::map<std::string, std::vector<std::string>> elements;
};

/// Whether a table is one of LeRobot's, by its columns.
bool is_of_lerobot(const std::vector<std::string>& columns);

/// The set that a file stands in, up to three folders above it; nothing where there is none.
/// @throw InputError: its meta/info.json is no JSON, or nothing like what LeRobot writes.
std::optional<LeRobotSet> lerobot_set_around(const std::string& path);

/// "elbow.pos" of the state stays so, "elbow" becomes "elbow.position"; of observation.velocity
/// "elbow.velocity", of .effort, .torque and .current likewise; of an action, "elbow.pos" or
/// "elbow", "elbow.position_command". Features and elements without names: "observation.state_0".
std::string lerobot_column(const std::optional<LeRobotSet>& set, const std::string& feature,
                           std::size_t element, std::size_t elements);

/// A clock by the frames where the table has none, and what the user should know.
void complete_lerobot_table(const std::optional<LeRobotSet>& set, log::LogTable& table);

}  // namespace tribolog::ingest::parquet
