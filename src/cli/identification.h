#pragma once
// What identify, figures and report have in common: reading a dataset and identifying it with
// progress, and telling the outcome. All of it through the door.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/console.h"
#include "joint/dataset.h"
#include "tribolog/calibration.h"
#include "tribolog/dataset.h"
#include "tribolog/values.h"

namespace tribolog::cli {

/// What is to be read.
struct DatasetChoice {
  std::string manifest;
  std::string joint;  ///< Of a whole robot's manifest, by name; empty: it is a single joint's.
};

/// Reads the manifest and its recordings; notes go to the console.
Dataset load_dataset(const DatasetChoice& choice, Console& console);

/// What the reader noticed. @param before each.
void tell_notes(const Dataset& dataset, const std::string& before, Console& console);

/// Refuses an output that is one of the dataset's own files.
/// @throw UsageError
void protect_inputs(const Dataset& dataset, const std::string& output);

/// How a dataset is to be identified, as the command line has it.
struct IdentificationSettings {
  std::optional<std::uint64_t> seed;   ///< Wins over the manifest's.
  std::size_t truth_runs{};            ///< Of the known-truth check; 0: none.
  std::vector<std::string> arguments;  ///< The whole command line, for the provenance.
};

/// Without progress. @throw UsageError for a number of resamples that gives no interval.
IdentifyOptions options_of(const IdentificationSettings& settings);

/// @throw UsageError as options_of().
Calibration run_identification(const Dataset& dataset, const IdentificationSettings& settings,
                               Console& console);

/// A few lines for the terminal: verdict, angle, mass, friction, and rows left out.
void tell_outcome(const Calibration& calibration, Console& to);

/// 1 if the verdict is the given one or worse.
ExitStatus status_of(const Calibration& calibration, const std::optional<Verdict>& fail_on);

/// What is done, on the console.
Progress progress_on(Console& console);

}  // namespace tribolog::cli
