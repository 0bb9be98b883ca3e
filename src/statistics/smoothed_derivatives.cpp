#include "statistics/smoothed_derivatives.h"

#include <cmath>

namespace tribolog::statistics {

SmoothedDerivatives::SmoothedDerivatives(std::size_t half, double dt_s)
    : weights_(Eigen::MatrixXd::Zero(highest + 1, static_cast<Eigen::Index>(2 * half + 1))) {
  constexpr double power = 8;
  const Eigen::Index size = weights_.cols();
  const auto reach = static_cast<double>(half - 1);  // fourth differences take two more samples
  for (Eigen::Index i = 2; i + 2 < size; ++i) {
    const double s = (static_cast<double>(i) - static_cast<double>(half)) / reach;
    weights_(0, i) = std::pow(1 - s * s, power);
  }
  weights_.row(0) /= weights_.row(0).sum();
  for (Eigen::Index i = 1; i + 1 < size; ++i) {
    weights_(1, i) = (weights_(0, i - 1) - weights_(0, i + 1)) / (2 * dt_s);
  }
  difference_twice(0, 2, dt_s);
  difference_twice(1, 3, dt_s);
  difference_twice(2, 4, dt_s);
}

void SmoothedDerivatives::difference_twice(Eigen::Index from, Eigen::Index to, double dt_s) {
  const Eigen::Index size = weights_.cols();
  for (Eigen::Index i = 0; i < size; ++i) {
    const double before = i > 0 ? weights_(from, i - 1) : 0;
    const double behind = i + 1 < size ? weights_(from, i + 1) : 0;
    weights_(to, i) = (before - 2 * weights_(from, i) + behind) / (dt_s * dt_s);
  }
}

}  // namespace tribolog::statistics
