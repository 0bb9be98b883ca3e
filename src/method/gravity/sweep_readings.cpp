#include "method/gravity/sweep_readings.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "statistics/distributions.h"

namespace tribolog::method::gravity {

Eigen::VectorXd direction_contrast(const SweepDesign& d, const motion::SweepSamples& samples) {
  Eigen::VectorXd contrast = Eigen::VectorXd::Zero(d.x.cols());
  if (d.direction >= 0) {
    contrast(d.direction) = 1;
    return contrast;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    contrast(d.offsets + static_cast<Eigen::Index>(d.offset_of_sample[i])) = samples.direction[i];
  }
  const auto ups = static_cast<double>((contrast.array() > 0).count());
  const auto downs = static_cast<double>((contrast.array() < 0).count());
  return contrast.unaryExpr([&](double sign) {
    return sign > 0 ? 0.5 / ups : sign < 0 ? -0.5 / downs : 0.0;
  });
}

void read_friction(const SweepDesign& d, const motion::SweepSamples& samples,
                   const SweepGravityFit& fit, double gear_ratio, CogSweepResult& out) {
  const Eigen::VectorXd& c = fit.regression.coefficients;
  const auto half_width = [&](Eigen::Index k) { return fit.regression.half_width(k); };
  constexpr Code method{"interval.least_squares_blocks"};
  if (!samples.constant_speed) {
    out.offset_Nm = c(d.offsets);
    if (d.direction >= 0) {
      out.coulomb_Nm =
          statistics::symmetric_estimate(c(d.direction), half_width(d.direction), method);
    }
    out.viscous_Nms_rad = statistics::symmetric_estimate(c(d.speed) / gear_ratio,
                                                         half_width(d.speed) / gear_ratio, method);
    out.inertia_kgm2 = statistics::symmetric_estimate(
        c(d.acceleration) / gear_ratio, half_width(d.acceleration) / gear_ratio, method);
    return;
  }
  if (!samples.both_directions()) return;
  const Eigen::VectorXd contrast = direction_contrast(d, samples);
  const double error = std::sqrt(contrast.dot(fit.regression.covariance * contrast));
  double freedom = INFINITY;
  for (Eigen::Index k = 0; k < d.offset_count; ++k) {
    freedom = std::min(freedom, fit.regression.freedom(d.offsets + k));
  }
  out.coulomb_Nm = statistics::symmetric_estimate(
      contrast.dot(c), statistics::student_t_975(freedom) * error, method);
}

Eigen::VectorXd offset_gradient(const SweepDesign& d, const motion::SweepSamples& samples) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d.x.cols());
  if (d.direction >= 0) {
    gradient(d.offsets) = 1;
  } else {
    gradient = direction_contrast(d, samples).cwiseAbs();
  }
  return gradient;
}

void read_offset(const SweepDesign& d, const motion::SweepSamples& samples,
                 const SweepGravityFit& fit, CogSweepResult& out) {
  if (!samples.both_directions()) return;
  Eigen::VectorXd gradient = offset_gradient(d, samples);
  out.offset_Nm = gradient.dot(fit.regression.coefficients);
  gradient(0) = -1;
  out.torque_offset_Nm = statistics::symmetric_estimate(
      out.offset_Nm, fit.regression.half_width_along(gradient), {"interval.least_squares_blocks"});
}

}  // namespace tribolog::method::gravity
