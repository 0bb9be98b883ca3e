#pragma once
// Derivatives of a sampled signal, smoothed over its neighbours, for regressions of one signal on
// the derivatives of another.
//
//   (phi * x)(t) and (phi * d^k x/dt^k)(t) = (d^k phi/dt^k * x)(t),    phi(s) ~ (1 - s^2)^8
//
// A signal smoothed by phi follows the smoothed derivatives of another by the same linear law as
// the two do unsmoothed: smoothing bends none of its coefficients, as it does where derivatives
// come from local polynomials and the signal is left as it is. Differences are summed by parts, so
// that a signal with a constant derivative has none of higher order, however few the samples.

#include <cstddef>

#include <Eigen/Core>

namespace tribolog::statistics {

class SmoothedDerivatives {
 public:
  static constexpr int highest = 4;
  /// @param half samples to either side, at least 4. @param dt_s sampling interval.
  SmoothedDerivatives(std::size_t half, double dt_s);

  /// A row for each derivative, from none on; a column for each of the 2 half + 1 samples.
  [[nodiscard]] const Eigen::MatrixXd& weights() const { return weights_; }

 private:
  void difference_twice(Eigen::Index from, Eigen::Index to, double dt_s);

  Eigen::MatrixXd weights_;
};

}  // namespace tribolog::statistics
