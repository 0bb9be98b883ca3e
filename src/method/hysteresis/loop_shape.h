#pragma once
// Stiffness right behind a reversal, with no model: the slope of torque over angle where the torque
// has changed by no more than a third of its way to the next turn. The angle of a micro-motion
// comes in steps, the torque does not: the angle is regressed on the torque.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

/// Samples of one stroke, [first, last): from its turn to the next.
struct StrokeSamples {
  std::size_t first{};
  std::size_t last{};
};

/// Share of a loop's height that "behind a reversal" means.
inline constexpr double part_behind_turn = 1.0 / 3;
/// Of a stroke's part behind its turn.
inline constexpr std::size_t fewest_samples_behind_turn = 4;

/// Slope dq/dT of the regression over samples [first, last); 0 where the torque stands.
double compliance(const std::vector<double>& torque_Nm, const std::vector<double>& q_rad,
                  std::size_t first, std::size_t last);

/// 1 / mean of compliances, with the interval of their scatter; at least two.
statistics::Estimate stiffness_of(const std::vector<double>& compliances_rad_Nm);

/// dT/dq behind the turns at which strokes begin, by joint angle [N·m/rad]; absent where fewer than
/// two strokes show it.
/// @param measured_Nm says how far "behind the turn" reaches.
/// @param torque_Nm whose slope is taken: the same, or a model's over the same samples.
std::optional<statistics::Estimate> stiffness_behind_turns(
    const std::vector<double>& q_rad, const std::vector<double>& measured_Nm,
    const std::vector<double>& torque_Nm, const std::vector<StrokeSamples>& strokes);

// What a recorded hysteresis loop shows without any model: whether it closes, how stiff the contact
// is right after a reversal, and the work that a cycle dissipates.
//
// The stiffness is the slope dT/dq over the first third of the loop's height behind each reversal
// of the angle, by regression of the angle on the torque (the angle of a micro-motion comes in
// steps, the torque does not). The tangent at the reversal itself is larger: of a LuGre contact
// that turns from sliding it is 2 s0, and this slope 1.64 s0.

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
  std::optional<statistics::Estimate> stiffness_Nm_rad;
  std::size_t strokes{};  ///< That took part in the stiffness.
};

/// A loop that moves on by more than this share of its width from cycle to cycle is not closed.
inline constexpr double largest_closing_gap = 0.05;

/// Shape of each oscillation; those that do not swing through three cycles are left out.
std::vector<LoopShape> describe_loops(const std::vector<const joint::Recording*>& oscillations,
                                      double gear_ratio);

}  // namespace tribolog::method::hysteresis
