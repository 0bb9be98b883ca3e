#pragma once
// A dataset and a calibration written by hand: round numbers, no stage involved.

#include "calibration/calibration.h"
#include "joint/dataset.h"

namespace tribolog::test {

/// What the hand-made joint is. All torques at the motor.
namespace known {
inline constexpr double gear_ratio = 100.0;
inline constexpr double q_peak_rad = -0.4;
inline constexpr double gravity_Nm = 4.0;
inline constexpr double friction_Nm = 0.5;
inline constexpr double centre_rad = -0.4;
inline constexpr double amplitude_rad = 100e-6;
inline constexpr double frequency_Hz = 1.0;
inline constexpr int cycles = 4;
inline constexpr int samples_per_cycle = 200;
inline constexpr double loop_Nm = 0.8;  ///< Half the loop's height.
inline constexpr double z_rad = 2e-3;   ///< Largest bristle deflection.
inline constexpr double dz_rad_s = 12e-3;
/// Surrogate mass [kg] per newton metre at the motor: n / (g r).
inline constexpr double kg_per_Nm = 100.0 / (9.81 * 0.5);
}  // namespace known

/// Rough and precise sweeps (up and down), one oscillation.
joint::Dataset hand_made_dataset();

/// Every stage done. Refers to the dataset's recordings.
calibration::Calibration hand_made_calibration(const joint::Dataset& dataset);

/// Only a rough sweep of varying speed, as an industrial robot's log gives: no loop, no precise
/// sweep, angle bins for runs, one candidate.
calibration::Calibration sweep_only_calibration(const joint::Dataset& dataset);

}  // namespace tribolog::test
