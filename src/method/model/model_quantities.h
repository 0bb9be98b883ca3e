#pragma once
// What the posterior of a joint's model says of the joint: each quantity with its interval, and how
// much of the interval's variance comes from which effect.

#include <optional>
#include <string>
#include <vector>

#include "joint/quantity.h"
#include "method/model/joint_model.h"
#include "method/model/model_law.h"
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
  /// Of friction at a speed, while the angle rises and while it falls: with the torque's offset,
  /// which no motion tells from friction that differs.
  std::optional<statistics::Estimate> forward{};
  std::optional<statistics::Estimate> backward{};

  [[nodiscard]] statistics::Estimate as_estimate() const {
    return {estimate, low, high, {"interval.of_model"}};
  }
};

/// An effect as the data show it.
struct ModelEffect {
  std::string_view key;
  double chi2{};  ///< Of its coefficients against none; NaN: it is not asked.
  double freedom{};
  double torque_Nm{};               ///< Root mean square over the cells.
  statistics::Estimate largest_Nm;  ///< Its torque in the cell where that is largest.
  double size_of_cap{};  ///< lambda over its cap: 1 is the largest that the catalogue knows.
  /// Of an effect with one column, in SI units of the catalogue's; absent: it has several.
  std::optional<statistics::Estimate> coefficient{};

  /// Beyond doubt.
  [[nodiscard]] bool is_plain() const {
    constexpr double of_each = 10;
    return chi2 > of_each * freedom;
  }
  /// Hardly any joint has so much of it.
  [[nodiscard]] bool is_near_cap() const {
    constexpr double near = 0.8;
    return size_of_cap >= near;
  }
};

struct ModelResult {
  std::vector<ModelQuantity> quantities;
  std::vector<ModelEffect> effects;
  ModelLaw law;
  /// Friction at rest by the laws, Coulomb torque with the Stribeck excess, in this session; absent
  /// where the runs do not reach into the dip.
  std::optional<statistics::Estimate> rest_Nm;
  double friction_Nm{};  ///< Median size over the cells.
  double top_Nm{};       ///< 98th percentile of the torque's size.
  std::size_t cells{};
  double samples_per_independent{};
  double cells_far_off{};     ///< Share of cells whose weight fell below 0.3, and that matter.
  std::size_t unlike_left{};  ///< Recordings unlike the others that are still in it.
  std::vector<int> left_out;  ///< Recordings, by their index.
  /// By which share of itself the friction where loops and ramps were recorded, as it is logged
  /// there, differs from that at the runs' mean load, place and time. Absent: there are none, or no
  /// friction to compare.
  std::optional<statistics::Estimate> friction_of_loops;
  std::optional<statistics::Estimate> friction_of_ramps;
  /// By which share of itself a small change of the torque is logged too large under the load of
  /// the loops: torque out of proportion, another scale.
  std::optional<statistics::Estimate> gain_of_loops;

  [[nodiscard]] bool empty() const { return quantities.empty(); }
  [[nodiscard]] const ModelQuantity* find(joint::Quantity quantity) const;
  /// Null where the recordings cannot have it, or the manifest states that there is none.
  [[nodiscard]] const ModelEffect* find(std::string_view effect) const;
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
