#pragma once
// From a dataset to a calibration: the list of the method's steps.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "calibration/calibration.h"

namespace tribolog::identify {

struct IdentifyOptions {
  std::uint64_t seed{1};   ///< Of everything random: the same seed gives the same numbers.
  std::size_t threads{0};  ///< 0: as many as the machine has cores. Results do not depend on it.
  /// Simulations of what was identified, each identified again: truth/truth_check.h. 0: none.
  std::size_t truth_runs{0};
};

/// Called before each stage with its name in words and (done, all).
using StageProgress = std::function<void(const std::string& stage, int done, int all)>;

/// Runs every stage. Stages without data say so in their report; the others still run. The
/// calibration holds copies only, no reference to the dataset; figures take both.
calibration::Calibration identify(const joint::Dataset& dataset,
                                  const IdentifyOptions& options = {},
                                  const StageProgress& progress = {});

}  // namespace tribolog::identify
