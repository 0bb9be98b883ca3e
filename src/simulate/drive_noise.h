#pragma once
// What a real drive makes of the true signals: ripple, white noise, quantised torque and angle,
// speed from the filtered difference of the angle, stamps beside their ticks, samples that are
// lost.

#include <cstdint>

#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog::simulate {

/// Lays the noise on a recording of true signals. All-zero noise leaves it bit for bit as it was.
/// @param stream number of the recording, so that each has its own random numbers.
/// @throw Refusal if a noise quantity is negative or not finite.
void add_drive_noise(joint::Recording& recording, const Noise& noise, double gear_ratio,
                     double sample_rate_Hz, std::uint64_t stream);

}  // namespace tribolog::simulate
