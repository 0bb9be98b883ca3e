#pragma once
// The motion of a recorded oscillation: its frequency, its harmonics, its cycles.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"
#include "simulate/motion.h"

namespace tribolog::method::motion {

struct OscillationMotion {
  double frequency_Hz{};
  double centre_rad{};
  double amplitude_rad{};  ///< Of the first harmonic.
  double start_s{};        ///< Time of the first sample; harmonics count time from here.
  double residual_rad{};   ///< Standard deviation of q less the harmonics.
  double near_sine_rad{};  ///< The same, less the first three alone.
  std::size_t samples{};
  std::vector<simulate::HarmonicMotion::Harmonic> harmonics;  ///< Joint side.
  /// Beyond the orders that were fitted one by one, what a servo of finite stiffness gives way to
  /// the torque: two series of harmonics, like the torque's and like its rate's, whose sum the
  /// angle shows. Empty where it shows none, or where the recording is too coarse for them.
  std::vector<std::vector<simulate::HarmonicMotion::Harmonic>> of_torque;
  std::size_t one_by_one{};  ///< Number of the orders fitted one by one.

  /// Amplitude of a harmonic as a share of the first's. @param order from 1 on; 0 beyond those
  /// fitted.
  [[nodiscard]] double share_of_harmonic(std::size_t order) const;
  /// Whether the motion has an appreciable second harmonic, beyond what the noise of the angle
  /// explains.
  [[nodiscard]] bool has_even_harmonics() const;
  /// Whether the motion is about a sine: what three harmonics leave is below a fiftieth of the
  /// amplitude, or below a step of the encoder.
  [[nodiscard]] bool is_near_sine(double encoder_step_rad) const;
  /// Motor-side motion as a function of the time since start_s.
  [[nodiscard]] simulate::HarmonicMotion motor_motion(double gear_ratio) const;
};

/// Harmonics of the frequency of a motion, fitted again to other angles at the same times: what
/// noise of the angle does to a motion.
class HarmonicRefit {
 public:
  HarmonicRefit(const std::vector<double>& t_s, OscillationMotion motion);
  /// @param q_rad as many as the times.
  [[nodiscard]] OscillationMotion operator()(const std::vector<double>& q_rad) const;

 private:
  OscillationMotion motion_;
  Eigen::MatrixXd solved_;  ///< Coefficients by angles.
};

/// Fits three harmonics and their frequency to the angle, as many further ones as the angle shows
/// beyond its noise, and behind them those by which a servo gives way to the torque. Absent if the
/// angle does not complete at least one cycle.
std::optional<OscillationMotion> fit_oscillation_motion(const joint::Recording& recording);

}  // namespace tribolog::method::motion
