#pragma once
// Torque ripple: the part of a sweep's residual that repeats with the motor's angle.
//
// The residual, averaged over narrow bins of the motor's angle, is searched for periods in its
// spectrum over that angle; each line found is removed before the next is sought. A line has to
// exceed what white noise gives at the best of all periods, and to hold a share of the ripple's
// power. What remains besides lines (friction that varies with the angle) is stated as a standard
// deviation.

#include <optional>
#include <vector>

#include "statistics/estimate.h"

namespace tribolog::method::gravity {

/// One period of the ripple: amplitude * cos(periods_per_turn * motor angle + phase).
struct RippleLine {
  double periods_per_turn{};  ///< Of the motor shaft; need not be whole.
  double amplitude_Nm{};      ///< Motor side.
  double phase_rad{};
};

/// What a sweep shows of the torque ripple.
struct Ripple {
  std::vector<RippleLine> lines;  ///< Strongest first.
  double rest_Nm{};               ///< Standard deviation of what is neither line nor white noise.

  /// Torque of the lines at a motor angle [N·m].
  [[nodiscard]] double torque_Nm(double motor_angle_rad) const;
  /// Half width of the range that holds the torque at 95 % of all motor angles: each line at an
  /// independent phase, and the rest as normal noise [N·m].
  [[nodiscard]] double half_width_Nm() const;
  /// Standard deviation over the angle, of lines and rest [N·m].
  [[nodiscard]] double sd_Nm() const;
};

/// How finely the motor's angle is searched. A sine is resolved where bins are a few times narrower
/// than its period.
struct RippleSearch {
  double bins_per_turn{64};          ///< > 0
  double most_periods_per_turn{24};  ///< At most 3/8 of the bins.
  double least_periods_per_turn{0};
  double fewest_periods{3};  ///< Of a line over the whole range of angles.
};

/// The strongest line that stands out from the noise and from its neighbourhood in the spectrum;
/// nothing where none does.
std::optional<RippleLine> find_strongest_line(const std::vector<double>& motor_angle_rad,
                                              const std::vector<double>& residual_Nm,
                                              double white_variance, const RippleSearch& search);

/// @param motor_angle_rad, residual_Nm one per sample.
/// @param ripple_Nm standard deviation of the residual beyond white noise; 0: no lines.
/// @param white_variance of the torque.
Ripple find_ripple(const std::vector<double>& motor_angle_rad,
                   const std::vector<double>& residual_Nm, double ripple_Nm, double white_variance,
                   const RippleSearch& search = {});

/// A torque read at one position, its interval widened by the ripple: over a micro-oscillation
/// ripple is a constant, which no repetition averages out.
statistics::Estimate with_ripple(const statistics::Estimate& torque_Nm, const Ripple& ripple);

/// The 0.95 quantile of |sum of amplitude_k cos(random phase) + normal noise|.
double random_phase_half_width(const std::vector<double>& amplitudes, double normal_sd);

}  // namespace tribolog::method::gravity
