#pragma once
// What a recorded hysteresis loop shows without any model: whether it closes, how stiff the contact
// is right after a reversal, and the work that a cycle dissipates.
//
// The stiffness is the slope dT/dq over the first third of the loop's height behind each reversal
// of the angle, by regression of the angle on the torque (the angle of a micro-motion comes in
// steps, the torque does not). The tangent at the reversal itself is larger: of a LuGre contact
// that turns from sliding it is 2 s0, and this slope 1.64 s0.

#include <optional>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "statistics/estimate.h"

namespace tribolog {

struct LoopShape {
  std::string recording;
  double width_rad{};  ///< Largest less smallest joint angle of the steady cycles.
  double height_Nm{};  ///< The same of the motor torque.
  double cycles{};     ///< Steady ones, behind the start-up.
  /// Mean distance of the angle from where it was one cycle before, as a share of the width.
  double closing_gap{};
  bool closes{};          ///< closing_gap <= largest_closing_gap
  double dissipated_J{};  ///< Per steady cycle, at the joint: the area of T n over q.
  /// dT/dq behind a reversal, motor torque per joint angle [N·m/rad]; absent if no stroke shows it.
  std::optional<Estimate> stiffness_Nm_rad;
  std::size_t strokes{};  ///< That took part in the stiffness.
};

/// A loop that moves on by more than this share of its width from cycle to cycle is not closed.
inline constexpr double largest_closing_gap = 0.05;

/// Shape of each oscillation; those that do not swing through three cycles are left out.
std::vector<LoopShape> describe_loops(const std::vector<const Recording*>& oscillations,
                                      double gear_ratio);

}  // namespace tribolog
