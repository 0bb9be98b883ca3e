#pragma once
// Stage 8, first half: LuGre friction and gravity torque fitted to one recorded loop T(t).
//
// In a micro-oscillation the speed stays far below the Stribeck velocity, so that
// s0 g(w) is one level Ts; Tc and the Stribeck velocity do not show and are not fitted.
// The motion is a harmonic series fitted to q(t); the bristle equation is integrated once per
// model evaluation, with its exact derivatives by the parameters carried along.

#include <memory>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "stages/estimate.h"
#include "stages/oscillation_motion.h"

namespace tribolog {

struct LinearisedFit;

struct LuGreFit {
  bool converged{false};
  Estimate bristle_stiffness_Nm_rad;
  Estimate bristle_damping_Nms_rad;
  Estimate viscous_Nms_rad;
  Estimate static_Nm;     ///< Level s0 g at the loop's speeds, break-away torque.
  Estimate inertia_kgm2;  ///< Motor, gear and arm, at the motor; slow loops hardly show it.
  Estimate gravity_Nm;    ///< Motor side, at the gravity peak.
  double residual_Nm{};   ///< Standard deviation of T - model.
  int iterations{};
  std::string reason;         ///< Why not converged, or what the loop cannot show.
  std::vector<double> z_rad;  ///< The model's bristle at the recording's samples.
  std::vector<double> dz_rad_s;
  std::vector<double> torque_Nm;  ///< The model's torque there.
  /// Of a fit that converged, for resampling (stages/linearised_fit.h); not stored.
  std::shared_ptr<const LinearisedFit> linearised;
};

/// @param motion of the recording.
/// @param q_peak_rad angle at which gravity is largest.
LuGreFit fit_lugre(const Recording& oscillation, const OscillationMotion& motion, double gear_ratio,
                   double q_peak_rad);

}  // namespace tribolog
