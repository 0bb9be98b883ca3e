#pragma once
// Least squares of one curve model: the linear parameters in closed form within a
// Levenberg-Marquardt iteration over the one to three shape parameters (variable projection, Golub
// and Pereyra 1973, with Kaufman's derivative).

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/statement.h"
#include "method/viscous/curve_model.h"

namespace tribolog::method::viscous {

/// Speeds and torques are scaled internally by those of the data: units do not matter.
struct CurveFit {
  CurveModel model;
  double speed_scale_rad_s{1.0};
  double torque_scale_Nm{1.0};
  Eigen::VectorXd shape;   ///< Logarithms; speeds in units of the scale.
  Eigen::VectorXd linear;  ///< In units of the scales.
  double cost{};           ///< Sum of squared residuals, in units of the torque's scale.

  /// Magnitude of friction [N·m] at a sample; the sample's own friction is not used.
  [[nodiscard]] double friction_Nm(const CurveSample& sample) const;
  /// Root mean square over samples [N·m].
  [[nodiscard]] double rms_Nm(const std::vector<CurveSample>& samples) const;
  /// Why no joint can have these parameters: a negative viscous coefficient; else empty.
  [[nodiscard]] Statement impossible_because() const;
};

/// @param start shape of a fit to almost the same data and scales; absent: a grid of starts.
/// @return nothing if no start converges or the columns are collinear.
std::optional<CurveFit> fit_curve(const CurveModel& model, const std::vector<CurveSample>& samples,
                                  const CurveFit* start = nullptr);

/// Derivatives of the scaled friction with respect to linear and then shape parameters, one row per
/// sample.
Eigen::MatrixXd curve_jacobian(const CurveFit& fit, const std::vector<CurveSample>& samples);

// Errors at held-out groups of samples.

/// Groups that are held out in turn: all but the slowest and the fastest where there are six or
/// more, else all.
std::vector<std::size_t> groups_to_hold_out(const std::vector<CurveSample>& samples);

/// Mean squared error [N²·m²] of each group when held out, from fits to the others that start at
/// `all`. Empty if one of the fits fails.
std::vector<double> held_out_errors(const CurveFit& all, const std::vector<CurveSample>& samples,
                                    const std::vector<std::size_t>& groups);

}  // namespace tribolog::method::viscous
