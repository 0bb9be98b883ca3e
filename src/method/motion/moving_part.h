#pragma once
// The part of a recording in which the joint moves.

#include "joint/recording.h"

namespace tribolog {

/// The recording without the rest before and after its motion, which would spoil a fit of cycles.
/// What is cut is counted among the skipped rows. A recording without rest comes back as it is.
Recording moving_part(const Recording& recording);

}  // namespace tribolog
