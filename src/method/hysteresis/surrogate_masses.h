#pragma once
// Stage 4: the surrogate mass of every estimator, eq. (12) as corrected.
// A loop far from the gravity peak, where little of the gravity torque shows, gives no mass.

#include <optional>
#include <vector>

#include "joint/gravity_load.h"
#include "method/gravity/cog_sweep.h"
#include "method/gravity/run_gravity.h"
#include "method/hysteresis/estimator.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

/// A loop's torque is divided by this cosine of its distance from the peak at least: further away
/// an error of the friction grows to more than twice its size in the mass.
inline constexpr double least_loop_cosine = 0.5;

/// Gravity that comes from neither sweep nor readings of the loop.
struct OtherGravity {
  std::optional<statistics::Estimate> loop_fit_Nm{};  ///< At the peak, motor side; of LuGreFit.
  const gravity::RunGravityResult* runs{nullptr};
  std::optional<joint::StatedGravity> stated;
};

struct SurrogateMass {
  Estimator estimator{};
  statistics::Estimate torque_Nm;  ///< Motor side.
  double q_rad{};                  ///< Joint angle it was read at.
  statistics::Estimate mass_kg;
  statistics::Estimate gravity_Nm;  ///< Amplitude G/n that it stands for: torque / cos(q - q_peak).
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
