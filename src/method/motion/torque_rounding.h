#pragma once
// What the log of a torque loses beside being late: a filter or a mean rounds it where it bends.
//
// The lag is taken off the torque (aligned()); what is left is, of a torque f,
//
//   filter       int_0^inf exp(-s / tau) / tau f(t + tau - s) ds        first order
//   moving mean  1 / (2 d) int_-d^d f(t + s) ds
//
// A model that is compared with such a torque is rounded alike.

#include <vector>

#include <Eigen/Core>

#include "method/motion/lag_rivals.h"

namespace tribolog::method::motion {

struct TorqueRounding {
  LagShape shape{LagShape::delay};  ///< A delay rounds nothing.
  double size_s{};                  ///< tau or d, > 0.

  [[nodiscard]] bool any() const {
    return size_s > 0 && (shape == LagShape::filter || shape == LagShape::moving_mean);
  }
  /// How far it looks back, and ahead, for more than a thousandth of the torque [s].
  [[nodiscard]] double looks_back_s() const;
  [[nodiscard]] double looks_ahead_s() const { return any() ? size_s : 0; }

  /// Rounds a signal that runs along straight lines between its samples, and keeps its first and
  /// its last value beyond them.
  /// @param t_s ascending, one for each sample.
  void apply(const std::vector<double>& t_s, Eigen::Ref<Eigen::VectorXd> signal) const;
};

}  // namespace tribolog::method::motion
