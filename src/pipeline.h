#pragma once
// The method's table of contents: a dataset to a calibration, one call per stage.

#include <functional>
#include <string>

#include "calibration.h"

namespace tribolog {

/// Called before each stage with its name in words and (done, all).
using StageProgress = std::function<void(const std::string& stage, int done, int all)>;

/// Runs every stage. Stages without data say so in their report; the rest still runs.
/// The dataset must outlive the calibration (figures refer to its recordings).
Calibration identify(const Dataset& dataset, const StageProgress& progress = {});

}  // namespace tribolog
