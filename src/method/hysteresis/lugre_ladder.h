#pragma once
// How much of LuGre a set of loops supports: from a spring to the whole model, and no further than
// the data justify.
//
//   elastic    s0, s1                         the loop does not bend
//   level      s0, Ts, s1, s2, J              it bends, at speeds far below the Stribeck velocity
//   curvature  + (Ts - Tc)/ws^2               friction falls with speed, only the start of it
//   whole      + Tc and ws apart              the speed passes the Stribeck velocity
//
// Where loops hold a trace of a fall but too little of it for a rung, whether there is one stays
// open: what it would change in the others is in their intervals. Left out, it makes s1 too large.
//
// Damping, viscous coefficient or inertia may come out below zero, which no joint has: a torque
// that is logged late makes s1 smaller by s0 times the lag. Such a parameter is not held at zero,
// which would bias the others; it is not shown, with the reason (lugre_identifiability.cpp).
//
// G and the initial deflection are separate for each recording on all rungs (on the first they
// cannot be distinguished, and neither is found).

#include <string>
#include <vector>

#include "method/hysteresis/lugre_problem.h"
#include "statistics/block_regression.h"

namespace tribolog::method::hysteresis {

enum class LuGreRung { elastic, level, curvature, whole };

/// Stable: "curvature".
std::string to_string(LuGreRung rung);

/// How well the data alone determine a parameter.
struct LuGreStanding {
  double half_width{};  ///< 95 %, in the fit's variable.
  double relative{};    ///< Half width over the size; for a logarithm the half width itself.
  double effect_Nm{};   ///< Torque (rms) of its size that no other parameter can imitate.
};

/// Largest relative half width of a parameter that is stated as a number.
inline constexpr double widest_shown = 0.5;
/// Of one that justifies a rung: its interval excludes zero, or a factor of e.
inline constexpr double widest_climbed = 1.0;
/// Smallest effect that counts, as a share of the loop's height: no drive follows a friction model
/// more closely.
inline constexpr double smallest_effect = 1e-4;

struct LuGreClimb {
  LuGreRung rung{LuGreRung::elastic};
  bool converged{false};
  LuGreFreedom free;
  LuGrePoint point;
  LuGreProblem::Linearisation linear;
  statistics::BlockRegression
      around;          ///< The next step of the fit, which is zero, and its covariance.
  double height_Nm{};  ///< Largest height of a loop.
  int evaluations{};

  /// Column of a shared parameter, or -1 where it is held.
  [[nodiscard]] Eigen::Index column(LuGreShared::Index parameter) const;
  [[nodiscard]] LuGreStanding standing(Eigen::Index column, double size) const;
  /// By the size of a shared parameter: 1 for a logarithm, else its value.
  [[nodiscard]] LuGreStanding standing(LuGreShared::Index parameter) const;
  [[nodiscard]] bool stands(LuGreShared::Index parameter, double widest) const;
};

/// Share of Ts at which Tc is held while only the curvature shows: the fit does not depend on it.
inline constexpr double held_share = 0.6;
/// Ts is held at this many heights of the loop where it does not bend.
inline constexpr double elastic_heights = 1e3;

/// The same recordings, from coarse to fine.
struct LuGreProblems {
  const LuGreProblem& thinned;           ///< A few hundred samples each, for first guesses.
  const LuGreProblem* halfway{nullptr};  ///< For long recordings: its solution starts the last fit.
  const LuGreProblem& whole;             ///< All samples.
};

/// The same rung from a solution nearby. @param block_of_row of the problem's rows.
LuGreClimb solved_again(LuGreClimb nearby, const LuGreProblem& problem,
                        const std::vector<std::size_t>& block_of_row);

/// @param block_of_row of the rows of the whole problem.
LuGreClimb climb_lugre_ladder(const LuGreProblems& problems,
                              const std::vector<std::size_t>& block_of_row);

}  // namespace tribolog::method::hysteresis
