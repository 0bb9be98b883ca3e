#pragma once
// Joints drawn at random, with all small effects at once.

#include <cstddef>
#include <cstdint>

#include "simulate/scenario.h"

namespace tribolog::study {

struct MixedJoint {
  simulate::Scenario undisturbed;
  simulate::Scenario laid;
};

/// The joint of that number. Joints are the same for any size, and so are the draws of their
/// effects.
/// @param size of the effects, in terms of their usual standard deviations.
MixedJoint mixed_joint(std::uint64_t seed, std::size_t number, double size);

}  // namespace tribolog::study
