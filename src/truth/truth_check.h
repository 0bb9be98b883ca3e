#pragma once
// The known-truth check: simulate with what was identified, at the noise that was found, identify
// again with the same chain, and see whether it comes back.
//
// It shows whether the method can find its own answer on these motions at this noise. It does not
// tell whether the answer is right: a joint that is not of the model's kind shows in the residuals
// and in the disagreement of estimators, not here. It never calls itself: the identification it is
// given must not make the check.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "truth/readings.h"

namespace tribolog::truth {

struct IdentifiedJoint;

/// Identifies a dataset without a known-truth check of its own. Its numbers, readings_of it, are
/// all that is compared: what else a calibration holds may be left out.
using PlainIdentification =
    std::function<calibration::Calibration(const joint::Dataset&, std::uint64_t seed)>;

struct TruthCheckOptions {
  std::size_t runs{6};  ///< > 0
  std::uint64_t seed{1};
  std::size_t threads{0};  ///< 0: as many as the machine has cores. Changes no number.
};

/// @param calibration of the dataset.
calibration::TruthCheckResult check_known_truth(const joint::Dataset& dataset,
                                                const calibration::Calibration& calibration,
                                                const PlainIdentification& identify,
                                                const TruthCheckOptions& options = {});

/// The same for a joint made elsewhere: what its `put_in` says is held against what comes back.
calibration::TruthCheckResult check_known_truth(const IdentifiedJoint& joint,
                                                const PlainIdentification& identify,
                                                const TruthCheckOptions& options = {});

}  // namespace tribolog::truth
