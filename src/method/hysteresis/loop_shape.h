#pragma once
// Stiffness just after a reversal, without a model: the slope of torque over angle where the torque
// has changed by no more than a third of its change up to the next reversal. The angle of a
// micro-motion is quantised, the torque is not: the angle is regressed on the torque.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

/// Samples of one stroke, [first, last): from one reversal to the next.
struct StrokeSamples {
  std::size_t first{};
  std::size_t last{};
};

/// Share of a loop's height that counts as "after a reversal".
inline constexpr double part_behind_turn = 1.0 / 3;
/// Fewest samples of a stroke's part after its reversal.
inline constexpr std::size_t fewest_samples_behind_turn = 4;

/// Slope dq/dT [rad/(N·m)] of the regression over samples [first, last); 0 where the torque is
/// constant.
double compliance(const std::vector<double>& torque_Nm, const std::vector<double>& q_rad,
                  std::size_t first, std::size_t last);

/// 1 / mean of compliances, with the interval from their scatter; needs at least two.
statistics::Estimate stiffness_of(const std::vector<double>& compliances_rad_Nm);

/// dT/dq after the reversals at which strokes begin, by joint angle [N·m/rad]; absent where fewer
/// than two strokes show it.
/// @param measured_Nm determines how far "after the reversal" extends.
/// @param torque_Nm whose slope is taken: the same, or a model's over the same samples.
std::optional<statistics::Estimate> stiffness_behind_turns(
    const std::vector<double>& q_rad, const std::vector<double>& measured_Nm,
    const std::vector<double>& torque_Nm, const std::vector<StrokeSamples>& strokes);

// What a recorded hysteresis loop shows without any model: whether it closes, how stiff the contact
// is right after a reversal, and the work that a cycle dissipates.
//
// The stiffness is the slope dT/dq over the first third of the loop's height after each reversal of
// the angle, by regression of the angle on the torque (the angle of a micro-motion is quantised,
// the torque is not). The tangent at the reversal itself is larger: for a LuGre contact that
// reverses from sliding it is 2 s0, and this slope 1.64 s0.

struct LoopShape {
  std::string recording;
  double width_rad{};  ///< Largest minus smallest joint angle of the steady cycles.
  double height_Nm{};  ///< The same of the motor torque.
  double cycles{};     ///< Steady ones, after the start-up.
  /// Mean distance of the angle from where it was one cycle before, as a share of the width.
  double closing_gap{};
  bool closes{};          ///< closing_gap <= largest_closing_gap
  double dissipated_J{};  ///< Per steady cycle, at the joint: the area of n T over q.
  /// dT/dq after a reversal, motor torque per joint angle [N·m/rad]; absent if no stroke shows it.
  std::optional<statistics::Estimate> stiffness_Nm_rad;
  std::size_t strokes{};  ///< Number of strokes used for the stiffness.
};

/// A loop that shifts by more than this share of its width from cycle to cycle is not closed.
inline constexpr double largest_closing_gap = 0.05;

/// Shape of each oscillation; those with fewer than three cycles are left out.
std::vector<LoopShape> describe_loops(const std::vector<const joint::Recording*>& oscillations,
                                      double gear_ratio);

}  // namespace tribolog::method::hysteresis
