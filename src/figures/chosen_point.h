#pragma once
// The point that the paper's rule chose on the loop, beside the mid-line: data and words.

#include <string>

#include "calibration/calibration.h"
#include "wording/axis_scale.h"

namespace tribolog::figures {

/// Pointers into the calibration, null where there is none; must not outlive it.
struct Choice {
  const LoopPoint* chosen{};  ///< The paper's, in the first strokes.
  const LoopPoint* other{};   ///< Its opposite there.
  const LoopPoint* chosen_steady{};
  const LoopPoint* other_steady{};
  const Estimate* midline{};
};

Choice choice_of(const Calibration& calibration);

/// "the paper's rule reads 3.866 N·m at B (78.81 kg); the mid-line ... averages ...": for caption,
/// alt.
std::string choice_words(const Calibration& calibration, const Choice& choice,
                         const AxisScale& torque);

/// Eq. (14) in a sentence, with the uncertainty of the peak itself. Empty
/// without a chosen point or a peak.
std::string shift_words(const Calibration& calibration, const Choice& choice);

}  // namespace tribolog::figures
