#pragma once
// Effect of a recorded angle's noise on a fit along the motion through it.
//
// The motion is taken as the truth, recorded again with the noise that was found (its steps
// elsewhere, for all recordings by the same, or other white noise), fitted or traced anew, and the
// fit takes one step from its solution. The steps over several such recordings show the error that
// no scatter of the torque shows: a motion that is wrong at the reversals is so in the same way in
// all half loops, for an encoder reads each cycle of a steady oscillation alike.
//
// For long recordings a part suffices: the shift by the noise of the part, divided by the square
// root of the number of parts. The initial deflection, which the first strokes alone determine,
// keeps its own shift.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/statement.h"
#include "joint/recording.h"
#include "method/hysteresis/lugre_ladder.h"
#include "method/hysteresis/lugre_problem.h"
#include "method/motion/traced_motion.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

/// Columns whose outer products add up to the parameters' covariance due to that noise, rows in the
/// order of the climb's columns.
Eigen::MatrixXd shifts_by_motion_noise(const std::vector<LuGreInput>& loops,
                                       const LuGreClimb& climb, double gear_ratio,
                                       double q_peak_rad);

// What the fit of a loop along a traced motion shows besides the parameters: how well the motion is
// known, how much of the scatter its noise explains, and whether the model is as stiff after a
// reversal as the measured joint.

struct TracedLoop {
  double noise_rad{};      ///< Of the angle, standard deviation, joint side.
  Statement noise_source;  ///< Where it comes from.
  std::size_t strokes{};   ///< Number of strokes between reversals.
  /// Scatter of the torque that the noise of angle and torque can explain: the angle's noise times
  /// the model's slope, and the torque's white noise.
  double explained_Nm{};
  /// Motor torque over joint angle after the reversals (loop_shape.h), measured and of the model
  /// over the same samples; absent where fewer than two strokes show it.
  std::optional<statistics::Estimate> turn_stiffness_Nm_rad;
  std::optional<statistics::Estimate> model_turn_stiffness_Nm_rad;
};

/// @param model_Nm torque of the model at the recording's samples.
/// @param slope_Nm_rad of the model there, by motor angle.
TracedLoop describe_traced_loop(const joint::Recording& recording,
                                const motion::TracedMotion& motion,
                                const std::vector<double>& model_Nm,
                                const std::vector<double>& slope_Nm_rad, double gear_ratio);

/// States the misfit where noise does not explain it; empty where it does.
Statement described_misfit(const std::string& recording, const TracedLoop& loop,
                           double residual_Nm);

}  // namespace tribolog::method::hysteresis
