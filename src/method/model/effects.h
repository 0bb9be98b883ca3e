#pragma once
// The catalogue of what acts on a joint's torque beside gravity, inertia and one friction law.
//
// Each effect is a row: a prior of physically typical size with a heavy tail and a cap, and its
// columns, the torque that each of its coefficients makes in each cell. All are always in the
// model. What the data show of an effect is taken off by the fit, what they cannot exclude widens
// the intervals; no effect is detected first and allowed then.

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "method/model/cells.h"

namespace tribolog::method::model {

/// Coefficients are scale x lambda x N(0,1); lambda^2 ~ inverse gamma(dof/2, dof/2), so that the
/// coefficients of an effect are Student-t together; lambda <= cap.
struct Effect {
  enum class Kind {
    core,    ///< Gravity, inertia: free.
    effect,  ///< Its size is asked of the data.
    fixed,   ///< Its size stays as typical.
    random,  ///< One coefficient for each recording: what nothing explains.
  };
  std::string_view key;  ///< "lag"; of messages too.
  Kind kind{Kind::effect};
  double dof{2};
  double cap{30};

  [[nodiscard]] constexpr double least_precision() const { return 1 / (cap * cap); }
};

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
std::vector<EffectColumns> effect_columns(const Cells& cells, bool has_gravity, const Point& point);

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
