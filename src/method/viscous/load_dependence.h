#pragma once
// Does friction grow with the load? From a sweep in both directions over the same angles.
//
// Half the difference of the two directions' torques at equal angle is friction; gravity cannot
// enter it. It is regressed on the magnitude of the gravity torque there, and on the speed where
// that varies along the sweep:
//   (T(+) - T(-))/2 = unloaded + viscous |w| + per_load |G/n cos(q - q_peak)|
// Rows are means over cells of the angle, one for each pair of strokes. The residuals repeat with
// the angle, so intervals are taken over blocks of the angle, and a term counts only if it also
// reduces the error at held-out angles.
//
// It cannot distinguish load from angle: friction that depends on the angle itself in the same
// pattern looks the same. In a sine about the angle of no load, speed is a function of the load
// too; a cubic in speed without any load is therefore fitted as a rival.
//
// A torque that is logged out of proportion looks the same as well, but bends the sum of the
// directions too. At a constant speed the torques of both directions are fitted together,
//   T = G cos(q - q_peak) + offset +- friction, and one term more:
//   +- per_load |cos|   friction that grows with the load,
//   (T/G)^3, T|T|/G^2   a drive whose torque constant falls with its current,
//   sgn T               a dead zone: what it takes before the output moves.
// Friction that changes with the angle in sines and cosines of q and 2q is the rival of the cube.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "method/gravity/cog_sweep.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

/// One cell of the angle, mean of all pairs of strokes. Motor side; the angle is the joint's.
struct LoadPoint {
  double q_rad{};
  double load_Nm{};  ///< |G/n cos(q - q_peak)|
  double speed_rad_s{};
  double friction_Nm{};
  double fit_Nm{};
};

/// The last: an offset of the torque describes the sweep as well as a saturation without one.
enum class OutOfProportion { saturation, dead_zone, saturation_or_offset };

/// As in JSON.
std::string to_string(OutOfProportion form);

/// A torque that is not in proportion to the joint's.
struct TorqueProportion {
  OutOfProportion form{};
  statistics::Estimate share;  ///< What it adds at the gravity peak, of the gravity torque.
};

struct LoadDependenceResult {
  bool examined{false};           ///< The numbers below are valid.
  bool found{false};              ///< Friction was found to depend on the load.
  Statement sentence;             ///< The outcome in words; never empty.
  statistics::Estimate per_load;  ///< N·m of friction per N·m of gravity torque.
  statistics::Estimate
      unloaded_Nm;  ///< Friction without load, and at standstill where `viscous` is fitted.
  std::optional<statistics::Estimate>
      viscous_Nms_rad;  ///< Present where the speed varies along the sweep.
  double lowest_load_Nm{};
  double highest_load_Nm{};
  /// Root mean square error at held-out angles: with the load, without it, and of the cubic in
  /// speed without load (NaN where the speed does not vary).
  double held_out_Nm{};
  double held_out_without_load_Nm{};
  double held_out_speed_alone_Nm{};
  std::vector<LoadPoint> points;  ///< By angle.
  /// Present where it describes the sweep no worse than friction that grows with the load.
  std::optional<TorqueProportion> out_of_proportion;
};

/// @param sweep the rough one. @param rough what was found in it. @param q_peak_rad the angle of
/// the gravity peak.
LoadDependenceResult identify_load_dependence(const motion::Sweep& sweep,
                                              const gravity::CogSweepResult& rough,
                                              const std::optional<statistics::Estimate>& q_peak_rad,
                                              double gear_ratio);

}  // namespace tribolog::method::viscous
