#pragma once
// Gravity torque by methods that the chain itself does not use, for comparison with its result.
//
// sweep_directions: mean of the sweep's two directions at equal angle, T+ + T- = 2 G cos(q -
// q_peak):
//   friction that is the same in both directions drops out, whatever its law; a constant offset of
//   the torque is a term of the fit.
// run_directions: the same for pairs of constant-speed runs.
// classical: one linear least squares over everything that moves, sweeps and runs together,
//   T = G cos(q - q_peak) + Fc sgn(w) + Fv w + J dw/dt + offset, which the paper argues against: no
//   Stribeck effect and no bend of the viscous law fits into it.

#include <optional>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/estimate.h"

namespace tribolog::method::selection {

enum class IndependentMethod { sweep_directions, run_directions, classical };

/// Stable: "sweep_directions".
std::string to_string(IndependentMethod method);

/// A gravity torque with what its resampling needs.
struct IndependentGravity {
  IndependentMethod method{};
  statistics::Estimate gravity_Nm;  ///< Motor side.
  std::vector<double>
      block_shifts;  ///< What the error of each block does to it; see BlockRegression.
  double freedom{};
  double further_half_width_Nm{};  ///< Of the offset that was subtracted.
};

/// The other results of the classical regression; motor side.
struct ClassicalRegression {
  statistics::Estimate q_peak_rad;
  statistics::Estimate gravity_Nm;  ///< With the interval of blocks.
  statistics::Estimate
      textbook_gravity_Nm;  ///< With the interval for independent errors of equal size.
  statistics::Estimate coulomb_Nm;
  statistics::Estimate viscous_Nms_rad;
  statistics::Estimate inertia_kgm2;  ///< Reflected to the motor.
  double offset_Nm{};
  double residual_Nm{};   ///< Standard deviation of its residuals; rows as averaged.
  double row_noise_Nm{};  ///< Residual that the torque's white noise alone would leave.
};

struct IndependentGravities {
  std::vector<IndependentGravity> gravity;
  std::optional<ClassicalRegression> classical;

  [[nodiscard]] const IndependentGravity* find(IndependentMethod method) const;
};

/// @param sweep the rough one, @param runs recordings of that role; may be empty. Methods without
/// data are left out.
IndependentGravities independent_gravity(const motion::Sweep& sweep,
                                         const std::vector<const joint::Recording*>& runs,
                                         const gravity::CogSweepResult& rough,
                                         const viscous::ViscousCurvesResult& curves,
                                         const std::optional<statistics::Estimate>& q_peak_rad,
                                         double gear_ratio);

}  // namespace tribolog::method::selection
