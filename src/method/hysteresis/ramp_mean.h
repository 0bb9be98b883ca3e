#pragma once
// Break-away torque from all ramps of a joint in one model, with the effects of the catalogue
// (joint/effects.h) that act on them.
//
//   y = T(direction) + sum_k c_k cos(k phi) + s_k sin(k phi) + u(position) + common + e
//
// y: friction that a ramp held [N·m]. T: of its direction, the mean over all motor angles phi.
// c, s: friction over the motor's turn, of the orders that a sweep shows, at an unknown phase. u:
// what else a motor angle has of its own. common: gravity, inertia and damping, which are known to
// an interval each and shift all ramps together. e: scatter of the ramps. A ramp that did not break
// away counts with the probability that it holds more than its bound (Tobin 1958).
//
// The sizes of u and e are not known either: both are integrated on a grid, so that the interval of
// few ramps is as wide as Student's, and that of ramps at few angles as wide as their sizes' prior.

#include <cstddef>
#include <optional>
#include <vector>

#include "joint/effects.h"
#include "method/gravity/ripple_spectrum.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

struct RampRow {
  double held_Nm{};        ///< In the ramp's direction, a bound where the ramp is censored.
  bool broke_away{true};   ///< false: more than `held_Nm` was held.
  bool is_rising{};        ///< Direction.
  std::size_t position{};  ///< Number of its motor angle (position_numbers()).
  double motor_angle_rad{};
  // Half widths of what shifts all ramps together, signed as the ramp is.
  double gravity_Nm{};
  double inertia_Nm{};
  double damping_Nm{};
};

/// How friction changes over the motor's turn, in shares of itself.
struct FrictionOverTurn {
  std::vector<gravity::RippleLine> orders;  ///< Amplitudes are shares; one side.
  double share{};                           ///< Of u: typical standard deviation; 0: there is none.
  double elsewhere{};  ///< Of what no ramp shows, of friction at other angles: standard deviation.
};

struct RampMeans {
  /// A direction has a mean from two ramps on that broke away. No method is stated.
  std::optional<statistics::Estimate> rising_Nm, falling_Nm;
  std::optional<statistics::Estimate> both_Nm;  ///< Mean of the directions.
  std::size_t positions{};                      ///< At which ramps broke away.
  /// By how much positions differ beyond the scatter of the ramps: standard deviation, as a share.
  double between_positions{};
};

/// @param rows of any number and order.
RampMeans mean_of_ramps(const std::vector<RampRow>& rows, const FrictionOverTurn& over_turn);

}  // namespace tribolog::method::hysteresis
