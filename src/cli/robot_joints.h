#pragma once
// A whole robot's joints, identified at the same time: each on its own, whatever becomes of the
// others.

#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/archiving.h"
#include "cli/console.h"
#include "cli/identification.h"
#include "tribolog/calibration.h"
#include "tribolog/dataset.h"

namespace tribolog::cli {

/// Progress of several joints, each with a line of its own, from several threads.
class JointProgress {
 public:
  JointProgress(const std::vector<std::string>& names, Console& console);
  Progress of(std::size_t joint);

 private:
  Console& console_;
  std::vector<Console::Step> steps_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point drawn_;
};

/// What became of one joint.
struct IdentifiedJoint {
  std::string name;
  std::string file_name;           ///< The joint's name as one of a file; no two are the same.
  std::optional<Dataset> dataset;  ///< Absent: it could not be read.
  std::optional<Calibration> calibration;  ///< Absent: see refusal.
  std::string refusal;
  ExitStatus status{ExitStatus::done};  ///< Of the refusal.
  std::string archived_as;              ///< Empty: it is not.
};

/// The joints that a command is to do one after the other; empty: the manifest's only one, or the
/// one that was asked for by name.
std::vector<std::string> joints_to_do(const DatasetChoice& choice);

/// What a file system might not take is an underscore, and what is too long is cut off.
std::string as_file_name(const std::string& name);

/// Names of files for the joints: what a file system might not take is an underscore.
std::vector<std::string> file_names_of(const std::vector<std::string>& joints);

/// On all cores. Remarks are printed in the joints' order; a refused joint is warned of.
/// @throw UsageError as run_identification().
std::vector<IdentifiedJoint> identify_joints(const std::string& manifest,
                                             const std::vector<std::string>& names,
                                             const IdentificationSettings& settings,
                                             Console& console);

/// Refuses a directory whose files would replace an input.
void protect_inputs(const std::vector<IdentifiedJoint>& joints, const std::string& directory);

/// All numbers in one transaction; fills archived_as.
void keep_numbers(std::vector<IdentifiedJoint>& joints, const std::string& manifest,
                  Archiving& archiving, Console& console);

/// The worst of the joints': refused input, then a verdict that fails.
ExitStatus status_of(const std::vector<IdentifiedJoint>& joints,
                     const std::optional<Verdict>& fail_on);

/// A line for each joint, and one with how many are usable.
void tell_outcome(const std::vector<IdentifiedJoint>& joints, Console& console);

/// "J1.calibration.json"
std::string calibration_name(const IdentifiedJoint& joint);

}  // namespace tribolog::cli
