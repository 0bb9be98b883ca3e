#pragma once
// The model behind the loop fit: LuGre at micro-speed under a known motion, with its derivatives.
//
//   T = G cos(q - q_peak) + s0 z + s1 dz/dt + s2 w + J dw/dt,   dz/dt = w - |w| z s0 / Ts
//
// Unknown: log s0, log Ts (positive by construction), s1, s2, G, the inertia J of motor, gear and
// arm at the motor, and the deflection z at the start.

#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"
#include "stages/oscillation_motion.h"

namespace tribolog {

class LuGreLoopModel {
 public:
  static constexpr int parameters = 7;
  enum Index { log_stiffness, log_static, damping, viscous, gravity, inertia, start_deflection };
  using Vector = Eigen::Matrix<double, parameters, 1>;

  /// The recording must outlive the model.
  LuGreLoopModel(const Recording& recording, const OscillationMotion& motion, double gear_ratio,
                 double q_peak_rad);

  [[nodiscard]] Eigen::Index samples() const;
  /// Residuals T_model - T_measured, and their derivatives (one row per sample) if asked for.
  void evaluate(const Vector& p, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) const;
  /// z and dz/dt of the model at the samples.
  void bristle(const Vector& p, std::vector<double>& z, std::vector<double>& dz) const;
  /// Motor speed at the samples, by the fitted motion.
  [[nodiscard]] const std::vector<double>& speed() const { return speed_; }

 private:
  /// A piece of the way between two samples in which the speed keeps its sign.
  struct Piece {
    double start_speed, middle_speed, end_speed, duration;
    bool ends_at_sample;
  };
  template <class Scalar, class Visit>
  void run(const Scalar& stiffness, const Scalar& level, const Scalar& start, Visit visit) const;

  const Recording& recording_;
  std::vector<Piece> pieces_;
  std::vector<double> speed_;
  std::vector<double> acceleration_;
  std::vector<double> cosine_;
};

}  // namespace tribolog
