#pragma once
// The verdict over all stages, with one sentence and the findings that it rests on.

#include "calibration.h"

namespace tribolog {

/// Usable: mass and angle are known, each stage that had data is done. Doubtful: they are known,
/// but something is missing or does not agree. Not identifiable: no angle or no gravity torque.
Judgement judge(const Calibration& calibration);

}  // namespace tribolog
