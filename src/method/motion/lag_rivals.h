#pragma once
// What a lag between torque and angle comes from: four rivals in one fit.
//
//   delay         T(t) = f(t - d)
//   filter        tau dT/dt + T = f(t)                               first order
//   moving mean   T(t) = mean of f over t - 2 d .. t                 of the torque alone
//   elastic gear  T(t) = f(t) - J r d^4 q/dt^4                       the link follows the motor's
//                                                                    angle as q - (d^2 q/dt^2) /
//                                                                    w^2
//   with f = J q'' + Tf(|v|) sgn v + b cos q + c sin q + offset
//
// d, tau < 0: it is the angle that comes late. d and tau are found by least squares over the rows
// of starts and stops; what each rival leaves of the torque there is compared block by block, one
// block for each start or stop (Q. H. Vuong, Econometrica 57 (1989) 307-333, with the scatter
// between blocks). A rival is named only where it beats all others beyond doubt, and a delay, a
// mean or a filter only where it leaves little of what tells these from each other.

#include <optional>
#include <string>
#include <vector>

#include "method/motion/transients.h"
#include "statistics/estimate.h"

namespace tribolog::method::motion {

enum class LagShape { delay, filter, moving_mean, elastic_gear };

/// Stable: "elastic_gear".
std::string to_string(LagShape shape);

struct LagRival {
  LagShape shape{};
  /// d, tau, half the window of a mean, or, of an elastic gear, the shortest time that the link's
  /// oscillation against a motor held still may take, over 2 pi: sqrt(r), for r of at most 1/w^2
  /// [s].
  double size_s{};
  double half_width_s{};        ///< 95 %.
  double inertia_kgm2{};        ///< Coefficient of the joint's acceleration.
  double inertia_half_width{};  ///< 95 %.
  double residual_Nm{};         ///< What it leaves of the torque of starts and stops, rms.
};

struct LagCompetition {
  std::vector<LagRival> rivals;  ///< Those that describe a lag at all; none: no rival was fitted.
  std::optional<LagShape> winner;
  /// Time constant of the first-order filter that rounds a torque as much as the winner does, or as
  /// the one that rounds most of those that none beats beyond doubt [s]; a delay rounds nothing.
  double rounds_as_filter_s{};
};

/// @param knots of the friction polygon. @param lag_s about as large.
LagCompetition let_rivals_compete(const Transients& transients, const std::vector<double>& knots,
                                  double lag_s);

}  // namespace tribolog::method::motion
