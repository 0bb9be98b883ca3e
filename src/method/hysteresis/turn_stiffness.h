#pragma once
// Stiffness right behind a reversal, with no model: the slope of torque over angle where the torque
// has changed by no more than a third of its way to the next turn. The angle of a micro-motion
// comes in steps, the torque does not: the angle is regressed on the torque.

#include <cstddef>
#include <optional>
#include <vector>

#include "statistics/estimate.h"

namespace tribolog {

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
Estimate stiffness_of(const std::vector<double>& compliances_rad_Nm);

/// dT/dq behind the turns at which strokes begin, by joint angle [N·m/rad]; absent where fewer than
/// two strokes show it.
/// @param measured_Nm says how far "behind the turn" reaches.
/// @param torque_Nm whose slope is taken: the same, or a model's over the same samples.
std::optional<Estimate> stiffness_behind_turns(const std::vector<double>& q_rad,
                                               const std::vector<double>& measured_Nm,
                                               const std::vector<double>& torque_Nm,
                                               const std::vector<StrokeSamples>& strokes);

}  // namespace tribolog
