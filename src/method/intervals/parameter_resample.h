#pragma once
// Resampling the parameters of the friction curve.
//
// Runs keep their speeds. The residual of each run, corrected for the run's leverage, is added to
// the fitted curve with a random sign (wild bootstrap), and the parameters are fitted anew. An
// error of gravity is not scatter: it moves all runs together, rising ones against falling ones.
// The part of the residuals that looks like one is removed first, and the gravity drawn in this
// resample is used instead.

#include <vector>

#include <Eigen/Core>

#include "method/selection/friction_parameters.h"
#include "method/viscous/viscous_curves.h"
#include "method/viscous/waiboer_fit.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {

/// SI, motor side; empty where the parameters were not fitted.
struct ParameterDraw {
  std::vector<double> waiboer;  ///< asperity torque, Stribeck speed and power, cv, dv
  std::vector<double> line;     ///< Coulomb torque, viscous coefficient
};

class ParameterResampler {
 public:
  ParameterResampler(const viscous::ViscousCurvesResult& curves,
                     const selection::FrictionParametersResult& fits);
  /// @param gravity_shift_Nm, q_peak_shift_rad drawn in this resample.
  /// @param gravity_Nm gravity amplitude of the curve.
  [[nodiscard]] ParameterDraw draw(statistics::RandomStream& random, double gravity_shift_Nm,
                                   double q_peak_shift_rad, double gravity_Nm) const;

 private:
  /// A fit near its solution: its residual at each point, ready to be added again.
  struct Residuals {
    Eigen::VectorXd fitted, scatter;
    double freedom{};
  };
  [[nodiscard]] Residuals prepare(const Eigen::MatrixXd& columns, const Eigen::VectorXd& fitted,
                                  const Eigen::VectorXd& measured, Eigen::Index first) const;

  std::vector<viscous::CurvePoint> points_;  // sorted by speed
  Eigen::VectorXd gravity_, angle_;  // change of the friction per gravity, and per gravity and rad
  Eigen::VectorXd waiboer_;          // logarithms at the solution
  Residuals waiboer_residuals_;
  Eigen::MatrixXd line_solver_;  // points beyond the dip -> parameters
  Residuals line_residuals_;
  Eigen::Index line_first_{};
};

}  // namespace tribolog::method::intervals
