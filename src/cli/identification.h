#pragma once
// What identify, figures and report have in common: reading a dataset and running the stages with
// progress, and telling the outcome.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "calibration/calibration.h"
#include "calibration/provenance.h"
#include "cli/console.h"
#include "render/workers/renderer.h"

namespace tribolog::cli {

/// What a renderer may prepare for while the numbers are computed: scenes too, if the manifest
/// names a description of the robot.
/// @throw InputError as load_dataset, for the manifest alone.
render::workers::Prepared drawings_of(const std::string& manifest);

/// Reads the manifest and its recordings; notes go to the console.
joint::Dataset load_dataset(const std::string& manifest, Console& console);

/// Refuses an output that is one of the dataset's own files.
/// @throw UsageError
void protect_inputs(const joint::Dataset& dataset, const std::string& manifest,
                    const std::string& output);

/// Runs every stage.
/// How a dataset is to be identified, as the command line has it.
struct IdentificationSettings {
  joint::IntervalSettings intervals;  ///< Win over the manifest's.
  std::size_t truth_runs{};           ///< Of the known-truth check; 0: none.
};

/// @throw UsageError for a number of resamples that gives no interval.
calibration::Calibration run_identification(const joint::Dataset& dataset,
                                            const IdentificationSettings& settings,
                                            Console& console);

/// What the provenance says about the intervals.
std::vector<calibration::Setting> interval_configuration(
    const method::intervals::IntervalsResult& intervals);

/// A few lines for the terminal: verdict, angle, mass, friction, and rows left out.
void tell_outcome(const calibration::Calibration& calibration, Console& console);

/// 1 if the verdict is the given one or worse.
ExitStatus status_of(const calibration::Calibration& calibration,
                     const std::optional<calibration::Verdict>& fail_on);

}  // namespace tribolog::cli
