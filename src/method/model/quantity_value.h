#pragma once
// Internal to the model's quantities: a quantity as a function of the model's coefficients.

#include <array>
#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "joint/quantity.h"
#include "method/model/joint_model.h"

namespace tribolog::method::model {

/// A value and its derivatives by the effects' and the law's coefficients.
struct Value {
  double value{};
  Eigen::VectorXd gradient;
};

/// Which meaning of Coulomb and viscous torque, and at which moment of the session the
/// torque's gain was right: nobody knows.
struct Meaning {
  std::size_t of_law{1};  ///< FrictionLaw::meanings
  double moment{};
  double friction_change{};  ///< Of friction at that moment, by its mean over the runs.
};

/// A quantity, the friction torque at a speed, or what a row makes of the effects' coefficients.
struct Wanted {
  std::optional<joint::Quantity> quantity;
  double speed_rad_s{};
  Eigen::VectorXd row{};  ///< Of the effects' coefficients; empty: it is not that.
  /// Friction at the speed as it was in this session, which other recordings of it share.
  bool of_this_session{false};
  /// Of friction at a speed: 1, the angle rises; -1, it falls; 0, the mean of both. In one
  /// direction the torque's offset counts, which no motion tells from friction that differs.
  int direction{0};
};

bool is_of_friction(const Wanted& wanted);

/// @param theta of the effects and of the law `p.law`.
Value value_of(const JointModel& m, const LawPosterior& p, const Eigen::VectorXd& theta,
               const Wanted& wanted, const Meaning& meaning);

/// Begin, mean time and end of the runs' place in the session, from where the gain counts.
std::array<double, 3> moments_of(const Cells& cells);

/// By which share of itself friction differs at the session's begin and end from its mean over the
/// runs: who asks for friction asks for none of these moments.
std::array<double, 3> friction_changes(const JointModel& m, const Eigen::VectorXd& theta);

}  // namespace tribolog::method::model
