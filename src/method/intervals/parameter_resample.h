#pragma once
// Resampling the parameters of the friction curve.
//
// Runs keep their speeds. What the fit leaves at each run is laid on the fitted curve again with a
// random sign, corrected for the run's leverage, and the parameters are fitted anew. An error of
// gravity is not scatter: it moves all runs together, rising ones against falling ones. What of the
// residuals looks like one is taken out first, and the gravity drawn in this resample is put in.

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
  /// @param gravity_Nm of the curve.
  [[nodiscard]] ParameterDraw draw(statistics::RandomStream& random, double gravity_shift_Nm,
                                   double q_peak_shift_rad, double gravity_Nm) const;

 private:
  /// A fit next to its solution: what it leaves at each point, ready to be laid on again.
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
