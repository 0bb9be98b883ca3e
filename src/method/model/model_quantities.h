#pragma once
// What the posterior of a joint's model says of the joint: each quantity with its interval, and how
// much of the interval's variance comes from which effect.

#include <optional>
#include <string>
#include <vector>

#include "joint/quantity.h"
#include "method/model/joint_model.h"
#include "statistics/estimate.h"

namespace tribolog::method::model {

/// Part of a quantity's variance that would go if the effect's size were known (JCGM 100, 5.1).
/// Parts of effects that the data cannot tell from one another overlap: their sum exceeds one.
struct VarianceShare {
  std::string_view effect;  ///< Its key; "choice_of_law": laws of friction disagree.
  double share{};
};

struct ModelQuantity {
  std::optional<joint::Quantity> quantity;  ///< Absent: friction torque at a speed,
  double speed_rad_s{};                     ///< this one, motor side.
  double estimate{};                        ///< SI, motor side; an angle of the joint.
  double low{};                             ///< 95 % credible interval.
  double high{};
  std::vector<VarianceShare> shares;  ///< Largest first.

  [[nodiscard]] statistics::Estimate as_estimate() const {
    return {estimate, low, high, {"interval.of_model"}};
  }
};

/// An effect as the data show it.
struct ModelEffect {
  std::string_view key;
  double chi2{};  ///< Of its coefficients against none; NaN: it is not asked.
  double freedom{};
  double torque_Nm{};    ///< Root mean square over the cells.
  double size_of_cap{};  ///< lambda over its cap: 1 is the largest that the catalogue knows.
};

struct ModelResult {
  std::vector<ModelQuantity> quantities;
  std::vector<ModelEffect> effects;
  std::size_t cells{};
  double samples_per_independent{};
  double cells_far_off{};     ///< Share of cells whose weight fell below 0.3, and that matter.
  std::size_t unlike_left{};  ///< Recordings unlike the others that are still in it.
  std::vector<int> left_out;  ///< Recordings, by their index.

  [[nodiscard]] bool empty() const { return quantities.empty(); }
  [[nodiscard]] const ModelQuantity* find(joint::Quantity quantity) const;
};

/// @param speeds_rad_s of the motor, at which friction is stated; those beyond the measured ones
/// are left out.
ModelResult describe_joint_model(const JointModel& model, const std::vector<double>& speeds_rad_s);

/// Cells, model and quantities of a joint's sweeps, runs and points; friction is stated at speeds
/// from the slowest to the fastest measured, a step of a few percent apart.
ModelResult identify_joint(const std::vector<const joint::Recording*>& recordings,
                           const std::vector<joint::FrictionPoints>& points, double gear_ratio,
                           bool has_gravity, const joint::EffectSizes& sizes = {});

}  // namespace tribolog::method::model
