#pragma once
// Where to oscillate next: positions over which the ripple that the sweep shows averages out.

#include <optional>
#include <vector>

#include "base/statement.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/hysteresis_loop.h"

namespace tribolog::method::hysteresis {

struct PositionPlan {
  double spread_motor_rad{};        ///< Motor angle over which the positions are evenly spread.
  std::vector<double> further_rad;  ///< Joint angles of the oscillations still to be recorded.
  double half_width_now_Nm{};       ///< Of the mid-line's torque, motor side, at present.
  double ripple_half_width_Nm{};    ///< The part of it due to the ripple.
  double expected_half_width_Nm{};  ///< With all positions recorded.
};

/// Total number of positions that a plan aims at.
inline constexpr std::size_t planned_positions = 8;

/// Absent where no ripple shows, where there is no loop, or where three positions or more were
/// recorded.
/// @param cycles steady ones, whose scatter determines the mid-line's interval.
std::optional<PositionPlan> plan_positions(const gravity::CogSweepResult& rough,
                                           const HysteresisResult& hysteresis, std::size_t cycles,
                                           double gear_ratio);

/// Why the interval is as wide as it is, and what would narrow it.
Statement why_more_positions(const PositionPlan& plan, const gravity::Ripple& ripple);

}  // namespace tribolog::method::hysteresis
