#pragma once
// Offset of the torque or friction that differs between the directions?
//
// The mean of both directions at equal speed and angle, less gravity, is
//   (T+ + T-)/2 - G cos(q - q_peak) = offset + asymmetry |Tf|(v)
// An offset is the same at every speed; friction that is larger in one direction by a share of
// itself follows the friction curve. Pairs of runs at different speeds, and the sweep, separate the
// two as far as friction changes with speed.

#include <cstddef>
#include <optional>

#include "method/gravity/cog_sweep.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

struct TorqueBalance {
  /// Motor side. From pairs and sweep together where there are enough pairs, else the sweep's mean
  /// of both directions, which may be either.
  std::optional<statistics::Estimate> offset_Nm;
  /// Half the difference of the directions' friction over its mean; absent where it is
  /// indistinguishable from an offset.
  std::optional<statistics::Estimate> asymmetry;
  std::size_t pairs{};
};

TorqueBalance balance_directions(const ViscousCurvesResult& curves,
                                 const gravity::CogSweepResult& rough);

}  // namespace tribolog::method::viscous
