#pragma once
// The posterior of one model of a joint's torque over the cells of its sweeps and runs:
//
//   T = sum over effects of columns x coefficients + direction F(speed) + noise
//
// Given the sizes of the effects and the noise, it is one conjugate solve for each candidate law of
// friction, and the laws are averaged by their evidence. Sizes, noise and the weights of outlying
// cells follow by fixed-point steps of the evidence (MacKay; Student-t cells).

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "method/model/cells.h"
#include "method/model/effects.h"
#include "method/model/friction_laws.h"

namespace tribolog::method::model {

/// The posterior under one law of friction.
struct LawPosterior {
  double weight{};  ///< Of all laws' evidence.
  FrictionLaw law;
  Eigen::VectorXd mean;  ///< Of the effects' coefficients, and behind them the law's.
  Eigen::MatrixXd covariance;

  /// Of the law's coefficients.
  [[nodiscard]] auto friction() const { return mean.tail(law.scale.size()); }
};

struct JointModel {
  Cells cells;
  joint::EffectSizes sizes;  ///< As stated.
  Point point;
  LawHats hats;
  std::vector<EffectColumns> effects;
  std::vector<Eigen::Index> first;  ///< First coefficient of each effect, and one past the last.
  Eigen::VectorXd precision;        ///< 1 / lambda^2 of each effect.
  FrictionLaws laws;
  std::vector<LawPosterior> posteriors;  ///< Likeliest first.
  double samples_per_independent{1};     ///< Cells of a stroke that say as much as one.
  Eigen::ArrayXd weight;                 ///< Of each cell; below 1: it lies off.
  Eigen::ArrayXd residual_Nm;
  std::vector<int> left_out;  ///< Recordings unlike the others, of the cells' numbers.

  [[nodiscard]] bool empty() const { return posteriors.empty(); }
  /// False: the torque is too small or too large a number to calculate with.
  [[nodiscard]] bool is_finite() const;
  /// Index of an effect by its key; the number of effects if these cells have none of it.
  [[nodiscard]] std::size_t find(std::string_view key) const;
  [[nodiscard]] Eigen::Index width(std::size_t effect) const {
    return first[effect + 1] - first[effect];
  }
};

/// @param cells of sweeps and runs; too few of them, or without a torque: the model is empty.
/// @param sizes that the manifest states: of what is zero, the model has nothing.
JointModel fit_joint_model(const Cells& cells, bool has_gravity,
                           const joint::EffectSizes& sizes = {});

}  // namespace tribolog::method::model
