#pragma once
// One recording with everything in it: simulated experiments one after the other, with rests and
// transfers between.

#include <cstdint>
#include <string>
#include <vector>

#include "inspect/motion/motion_segments.h"
#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog::test {

struct TrueSegment {
  std::string name;  ///< Of the simulated recording.
  joint::Role role{};
  double from_s{};  ///< From the start of its motion to the end.
  double to_s{};
};

struct LongRecording {
  inspect::motion::AngleTrace trace;
  std::vector<TrueSegment> truth;
};

/// The scenario's recordings in their order, every `keep`-th sample of them.
/// @param rest_s before and behind each transfer.
LongRecording long_recording(const simulate::Scenario& scenario, std::size_t keep, double rest_s);

/// The paper's joint with a ramp of break-away torque, and all the noise of a real drive.
simulate::Scenario everything(std::uint64_t seed);

}  // namespace tribolog::test
