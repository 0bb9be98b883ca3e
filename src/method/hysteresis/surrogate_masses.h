#pragma once
// Stage 4: the surrogate mass of every estimator, eq. (12) as corrected.
// A loop far from the gravity peak, where little of the gravity torque shows, gives no mass.
//
// A loop at the peak cannot distinguish gravity from an offset of the torque, nor from friction
// that differs between the directions; the model of sweeps and runs can. Its offset is subtracted
// from mid-line, pair means and loop fit, with its interval. An offset is the same everywhere,
// asymmetric friction is proportional to friction, and the loop's friction is not the sweep's: the
// offset is scaled by the mean of 1 and the ratio of the two frictions, and the range between these
// counts as uncertainty. The paper's six readings are left as in the paper.

#include <optional>
#include <vector>

#include "joint/gravity_load.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/estimator.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

/// Least cosine of a loop's angle from the peak, by which its torque is divided: further away an
/// error of the friction more than doubles in the mass.
inline constexpr double least_loop_cosine = 0.5;

/// Gravity from other sources than the sweep and the loop's readings, motor side.
struct OtherGravity {
  std::optional<statistics::Estimate> loop_fit_Nm{};  ///< At the peak; of LuGreFit.
  std::optional<statistics::Estimate> model_Nm{};     ///< Of the model of sweeps and runs.
  std::optional<statistics::Estimate> offset_Nm{};    ///< Of the torque, by the same.
  double offset_drift_Nm{};                           ///< Its change over the session.
  double friction_Nm{};                               ///< Of the sweeps and runs.
  std::optional<joint::StatedGravity> stated{};
};

/// What was subtracted from a torque for its offset; zero where nothing was.
struct OffsetTaken {
  double value_Nm{};
  double share{};         ///< Of the model's offset.
  double ambiguity_Nm{};  ///< Half width: offset of the torque, or friction by direction?
};

struct SurrogateMass {
  Estimator estimator{};
  statistics::Estimate torque_Nm;  ///< Motor side, as read.
  double q_rad{};                  ///< Joint angle at which it was read.
  statistics::Estimate mass_kg;
  statistics::Estimate gravity_Nm;  ///< Amplitude G/n that it stands for: (torque - offset) /
                                    ///< cos(q - q_peak).
  double mean_cosine{1.0};          ///< Mean cosine of the angle from the peak, by which it was
                                    ///< divided.
  OffsetTaken offset;
};

struct SurrogateMassesResult {
  statistics::StageReport stage;
  std::vector<SurrogateMass> masses;  ///< In the order of the estimators.
  double distance_m{};                ///< r_REPL
  double gravity_m_s2{};

  [[nodiscard]] const SurrogateMass* find(std::optional<Estimator> estimator) const;
};

SurrogateMassesResult identify_surrogate_masses(
    const gravity::CogSweepResult& rough, const HysteresisResult& hysteresis,
    const std::optional<statistics::Estimate>& q_peak_rad, double gear_ratio, double distance_m,
    double gravity_m_s2, const OtherGravity& other = {});

}  // namespace tribolog::method::hysteresis
