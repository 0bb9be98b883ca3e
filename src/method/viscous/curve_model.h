#pragma once
// The models that a viscous curve may follow, simplest first, and the further terms that each may
// have.
//
//   Coulomb                 |Tf| = Tc
//   Coulomb and viscous     |Tf| = Tc + c w
//   Coulomb and power law   |Tf| = Tc + cv w^p
//   Stribeck (Gauss)        |Tf| = Tc + (Ts - Tc) exp(-(w/ws)^2) + c w
//   Waiboer, eq. (6)        |Tf| = Ta exp(-(w/ws)^da) + cv w^(1 - dv)
//
// Further terms, d = +1 for a rising joint angle and -1 for a falling one:
//   asymmetry               + A d, or + A d + B d w^p with the power of the law's viscous term
//   load                    + L |cos(q - q_peak)|
//
// All are linear in all parameters but up to three shape parameters (p; ws; ws, da and p): fits
// separate the two kinds.

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/statement.h"
#include "method/viscous/viscous_curves.h"

namespace tribolog::method::viscous {

enum class CurveLaw { coulomb, coulomb_viscous, power_viscous, stribeck, waiboer };
enum class Asymmetry { none, coulomb, coulomb_viscous };

inline constexpr CurveLaw curve_laws[] = {CurveLaw::coulomb, CurveLaw::coulomb_viscous,
                                          CurveLaw::power_viscous, CurveLaw::stribeck,
                                          CurveLaw::waiboer};

struct CurveModel {
  CurveLaw law{CurveLaw::coulomb};
  Asymmetry asymmetry{Asymmetry::none};
  bool load{false};

  [[nodiscard]] int shape_parameters() const;
  [[nodiscard]] int linear_parameters() const;
  [[nodiscard]] int parameters() const { return shape_parameters() + linear_parameters(); }
};

/// "coulomb_viscous", for results.
std::string to_string(CurveLaw law);
/// "none", "coulomb", "coulomb_viscous"
std::string to_string(Asymmetry asymmetry);
/// The law's name.
Statement described(CurveLaw law);
/// The law's name, and the model's further terms for direction and load.
Statement described(const CurveModel& model);

// The viscous curve as models see it: magnitude of friction against magnitude of speed, with
// direction and load.

struct CurveSample {
  double speed_rad_s{};  ///< > 0, motor side.
  double friction_Nm{};  ///< Opposing the motion; negative where a wrong mass makes it drive.
  double direction{};    ///< +1: joint angle rising, -1: falling.
  double load{};         ///< Load of the joint as a share of the gravity torque, 0 to 1.
  std::size_t group{};   ///< Held out together: all runs of one speed, or neighbouring angles.
  /// Standard error of the friction from the scatter within the run; 0: not known.
  double standard_error_Nm{};
  double count{};     ///< Number of samples of the log in it.
  std::size_t run{};  ///< Index in ViscousCurvesResult::runs.
};

/// Sorted by group, groups counting from 0. Runs within 3 % of the same speed are one group, both
/// directions together: their residuals, ripple or an error of gravity, are the same. The cells of
/// a sweep are grouped by neighbouring angles instead.
std::vector<CurveSample> curve_samples(const ViscousCurvesResult& curves,
                                       const ViscousCurve& curve);

/// Number of groups.
std::size_t group_count(const std::vector<CurveSample>& samples);

// The terms of a curve model, and their derivatives.

/// Columns of the linear parameters at a sample, in the order of the header's formulas: the law's,
/// then A and B, then L.
/// @param shape logarithms of the shape parameters, speeds in units of `sample.speed_rad_s`.
/// @param derivatives if not null: of the columns with respect to each shape parameter.
void model_columns(const CurveModel& model, const CurveSample& sample, const Eigen::VectorXd& shape,
                   Eigen::RowVectorXd& columns, std::vector<Eigen::RowVectorXd>* derivatives);

}  // namespace tribolog::method::viscous
