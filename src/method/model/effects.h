#pragma once
// The columns of the catalogue's effects (joint/effects.h): the torque that each coefficient of an
// effect makes in each cell.
//
// All effects that are not stated to be absent are in the model. What the data show of an effect is
// taken off by the fit, what they cannot exclude widens the intervals; no effect is detected first
// and allowed then.

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "joint/effects.h"
#include "method/model/cells.h"

namespace tribolog::method::model {

using joint::Effect;

/// What products of effects are linear about: the present estimate, all on the motor's side.
struct Point {
  double top_Nm{};       ///< 98th percentile of the torque's size.
  double friction_Nm{};  ///< Median size of the friction.
  double fastest_rad_s{};
  double gravity_cos_Nm{};  ///< g(q) = cos q, sin q parts.
  double gravity_sin_Nm{};
  double inertia_kgm2{};
  double coulomb_Nm{};
  double viscous_Nms_rad{};
  double dip_Nm{};           ///< Of the law's Stribeck term at rest.
  double dip_speed_rad_s{};  ///< 0: it has none.
  double dip_power{1};

  /// Size of the friction at a speed > 0, or at rest.
  [[nodiscard]] double friction_at(double speed_rad_s) const;
  /// The asymmetry's columns at a speed: torque that does not change its sign with the direction.
  /// @param slowest_rad_s of the cells.
  [[nodiscard]] Eigen::RowVector2d asymmetry_at(double speed_rad_s, double slowest_rad_s) const;
};

/// Least squares of gravity, offset, inertia, Coulomb and viscous torque.
Point first_point(const Cells& cells, bool has_gravity);

/// An effect's columns for given cells.
struct EffectColumns {
  const Effect* effect{};
  Eigen::MatrixXd columns;  ///< Torque [N·m] per unit of the coefficient.
  Eigen::VectorXd scale;    ///< Typical size of each coefficient.
};

/// All effects that these cells can have. The law of friction is that at the mean load, place and
/// time of the runs (of all cells without runs): what depends on them is counted from there.
std::vector<EffectColumns> effect_columns(const Cells& cells, bool has_gravity, const Point& point,
                                          const joint::EffectSizes& sizes);

/// Of "law_misfit" and "law_at_its_ends" at other speeds than the cells'.
struct LawHats {
  Eigen::ArrayXd knots;  ///< Log speed; empty: the speeds are too close to one another.
  double width{};
  /// Less its projection on Coulomb and viscous torque, or whole.
  [[nodiscard]] Eigen::RowVectorXd bent(double speed_rad_s) const;
  [[nodiscard]] Eigen::RowVectorXd whole(double speed_rad_s) const;
  Eigen::MatrixXd on_line;  ///< Coefficients of the projection, for 1 and v / fastest.
  double fastest_rad_s{};
};
LawHats law_hats(const Cells& cells, const Point& point);

}  // namespace tribolog::method::model
