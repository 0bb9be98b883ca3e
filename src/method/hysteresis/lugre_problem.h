#pragma once
// One recording as input of the LuGre fit: what was measured, and the motion that drives the model:
// harmonics for a joint moved along a sine, a spline through the angle for one driven by a torque.

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"
#include "method/hysteresis/lugre_loop_model.h"
#include "method/motion/oscillation_motion.h"
#include "method/motion/traced_motion.h"
#include "simulate/motion.h"
#include "statistics/levenberg_marquardt.h"

namespace tribolog::method::hysteresis {

struct LuGreInput {
  const joint::Recording* recording{};
  const motion::OscillationMotion* motion{};  ///< Fitted to the recording; used unless `traced` is
                                              ///< given.
  const motion::TracedMotion* traced{};       ///< Used instead where given.
  double encoder_step_rad{};                  ///< Of the angle, joint side; 0: it looks continuous.
  double settled_from_s{};  ///< The drive starts the motion before (loop_start.h).

  /// Motion as a function of the time since the recording's first sample.
  [[nodiscard]] std::shared_ptr<const simulate::Motion> motor_motion(double gear_ratio) const;
  /// LuGre along this motion, compared with the recording from where it is settled.
  [[nodiscard]] LuGreLoopModel model(double gear_ratio, double q_peak_rad, LuGreGrain grain) const;
  [[nodiscard]] double frequency_Hz() const;
  [[nodiscard]] double centre_rad() const;
  /// Half loop of each sample, counted from 0: half cycles of the frequency, or the strokes between
  /// the reversals of the angle. Residuals of a misfitted loop are correlated within one.
  [[nodiscard]] std::vector<std::size_t> half_loops() const;
};

// LuGre fitted to any number of loops at once: least squares over all their samples.
//
// Levenberg-Marquardt is Eigen's port of MINPACK. Of each recording it sees not the thousands of
// rows but the triangular factor of [J r], which has the same J'J, J'r and |r| and hence gives
// exactly the same steps: columns that belong to one recording alone then cost nothing in the
// others. Ceres is not used: on one loop its automatic differentiation took 17 ms where this way
// took 1.7 (dual numbers go through the recursion once; its Jets carry all parameters through every
// row), and its package brings SuiteSparse, ATLAS and glog.

/// A value for every parameter of every recording.
struct LuGrePoint {
  LuGreShared::Vector shared = LuGreShared::Vector::Zero();
  std::vector<LuGreLocal> locals;  ///< One per recording.
};

/// Which parameters a fit varies; the others keep their starting values. G is always free.
struct LuGreFreedom {
  std::vector<LuGreShared::Index> shared;
  bool starts{true};  ///< Initial deflections of the recordings.

  [[nodiscard]] bool has(LuGreShared::Index parameter) const;
};

class LuGreProblem {
 public:
  explicit LuGreProblem(std::vector<LuGreLoopModel> models) : models_(std::move(models)) {}

  struct Solution {
    LuGrePoint point;
    double squares{};  ///< Sum of squared residuals.
    int evaluations{};
    bool converged{false};
  };
  [[nodiscard]] Solution solve(const LuGreFreedom& free, const LuGrePoint& start,
                               const statistics::LeastSquaresLimits& limits = {}) const;

  /// Columns: the free shared parameters in their order, then for each recording G and, if free,
  /// its initial deflection.
  struct Linearisation {
    statistics::LinearisedFit fit;
    Eigen::MatrixXd r_factor;  ///< Triangular factor of the Jacobian.
  };
  /// @param block_of_row of all recordings' rows, one recording after the other.
  [[nodiscard]] Linearisation linearise(const LuGreFreedom& free, const LuGrePoint& at,
                                        const std::vector<std::size_t>& block_of_row) const;
  /// Column of a recording's G.
  [[nodiscard]] static Eigen::Index gravity_column(const LuGreFreedom& free, std::size_t recording);

  [[nodiscard]] const std::vector<LuGreLoopModel>& models() const { return models_; }
  /// Number of residuals of all recordings.
  [[nodiscard]] Eigen::Index rows() const;

 private:
  std::vector<LuGreLoopModel> models_;
};

}  // namespace tribolog::method::hysteresis
