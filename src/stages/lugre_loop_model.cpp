#include "stages/lugre_loop_model.h"

#include <cmath>

#include <unsupported/Eigen/AutoDiff>

#include "friction/exponential_step.h"
#include "simulate/reversal.h"

namespace tribolog {
namespace {

using Dual = Eigen::AutoDiffScalar<Eigen::Vector3d>;  // by log s0, log Ts and z0

double exp_of(double x) { return exp_nonpositive(x); }
Dual exp_of(const Dual& x) {
  const double value = exp_nonpositive(x.value());
  return {value, value * x.derivatives()};
}

/// One step at a constant g; the source integral has a constant h then, and one moment suffices.
template <class Scalar>
Scalar micro_step(double w0, double wm, double w1, double dt, const Scalar& g, const Scalar& z) {
  const double way = dt / 6 * (w0 + 4 * wm + w1);
  const Scalar length = std::abs(way) / g;
  const Scalar decay = exp_of(Scalar(-length));
  const Scalar target = way < 0 ? Scalar(-g) : g;
  return target + decay * (z - target);
}

}  // namespace

LuGreLoopModel::LuGreLoopModel(const Recording& recording, const OscillationMotion& motion,
                               double gear_ratio, double q_peak_rad)
    : recording_(recording) {
  const HarmonicMotion motor = motion.motor_motion(gear_ratio);
  const std::size_t n = recording.size();
  speed_.resize(n);
  acceleration_.resize(n);
  cosine_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = recording.t_s[i] - motion.start_s;
    speed_[i] = motor.speed(t);
    acceleration_[i] = motor.acceleration(t);
    cosine_[i] = std::cos(motor.angle(t) / gear_ratio - q_peak_rad);
  }
  const auto add = [&](double a, double b, double wa, double wb, bool ends_at_sample) {
    pieces_.push_back({wa, motor.speed((a + b) / 2), wb, b - a, ends_at_sample});
  };
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double a = recording.t_s[i] - motion.start_s;
    const double b = recording.t_s[i + 1] - motion.start_s;
    if (speed_[i] * speed_[i + 1] < 0) {
      const double turn = reversal_time(motor, a, b, speed_[i] < 0);
      add(a, turn, speed_[i], 0.0, false);
      add(turn, b, 0.0, speed_[i + 1], true);
    } else {
      add(a, b, speed_[i], speed_[i + 1], true);
    }
  }
}

Eigen::Index LuGreLoopModel::samples() const { return static_cast<Eigen::Index>(speed_.size()); }

template <class Scalar, class Visit>
void LuGreLoopModel::run(const Scalar& stiffness, const Scalar& level, const Scalar& start,
                         Visit visit) const {
  const Scalar g = level / stiffness;
  const Scalar inverse_g = 1.0 / g;
  Scalar z = start;
  std::size_t sample = 0;
  const auto visit_sample = [&] {
    const double w = speed_[sample];
    const Scalar rate = w - std::abs(w) * z * inverse_g;
    visit(sample, z, rate);
    ++sample;
  };
  visit_sample();
  for (const Piece& p : pieces_) {
    z = micro_step<Scalar>(p.start_speed, p.middle_speed, p.end_speed, p.duration, g, z);
    if (p.ends_at_sample) visit_sample();
  }
}

void LuGreLoopModel::evaluate(const Vector& p, Eigen::VectorXd& residuals,
                              Eigen::MatrixXd* jacobian) const {
  residuals.resize(samples());
  const auto torque = [&](std::size_t i, double z, double dz) {
    return p(gravity) * cosine_[i] + std::exp(p(log_stiffness)) * z + p(damping) * dz +
           p(viscous) * speed_[i] + p(inertia) * acceleration_[i];
  };
  if (jacobian == nullptr) {
    run<double>(std::exp(p(log_stiffness)), std::exp(p(log_static)), p(start_deflection),
                [&](std::size_t i, double z, double dz) {
                  residuals(static_cast<Eigen::Index>(i)) =
                      torque(i, z, dz) - recording_.torque_Nm[i];
                });
    return;
  }
  jacobian->resize(samples(), parameters);
  const double s0 = std::exp(p(log_stiffness));
  const double ts = std::exp(p(log_static));
  const Dual stiffness(s0, s0 * Eigen::Vector3d::UnitX());
  const Dual level(ts, ts * Eigen::Vector3d::UnitY());
  const Dual start(p(start_deflection), Eigen::Vector3d::UnitZ());
  run<Dual>(stiffness, level, start, [&](std::size_t i, const Dual& z, const Dual& dz) {
    const auto row = static_cast<Eigen::Index>(i);
    residuals(row) = torque(i, z.value(), dz.value()) - recording_.torque_Nm[i];
    const Eigen::Vector3d by = s0 * z.derivatives() + p(damping) * dz.derivatives();
    (*jacobian)(row, log_stiffness) = by(0) + s0 * z.value();
    (*jacobian)(row, log_static) = by(1);
    (*jacobian)(row, start_deflection) = by(2);
    (*jacobian)(row, damping) = dz.value();
    (*jacobian)(row, viscous) = speed_[i];
    (*jacobian)(row, gravity) = cosine_[i];
    (*jacobian)(row, inertia) = acceleration_[i];
  });
}

void LuGreLoopModel::bristle(const Vector& p, std::vector<double>& z,
                             std::vector<double>& dz) const {
  z.resize(speed_.size());
  dz.resize(speed_.size());
  run<double>(std::exp(p(log_stiffness)), std::exp(p(log_static)), p(start_deflection),
              [&](std::size_t i, double z_i, double dz_i) {
                z[i] = z_i;
                dz[i] = dz_i;
              });
}

}  // namespace tribolog
