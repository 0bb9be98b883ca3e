#pragma once
// The headline of a curve: Coulomb torque, Stribeck velocity and viscous coefficient of the sliding
// law
//
//   |Tf| = Tc + E exp(-(w/ws)^d) + c w      (c w^p where the friction is not linear in speed)
//
// Coulomb torque is Tc, the law without the Stribeck excess in the limit of vanishing speed; the
// viscous coefficient is the law's slope at high speed; the Stribeck velocity is where the excess
// has fallen to 1/e. The straight line E = 0 is among these laws.
//
// Data: the mean over both directions at each speed, so that an error of gravity cancels. Its
// variance is that of the scatter within the runs plus that of a scatter between speeds that no
// single run shows, estimated so that the law describes the speeds (Paule and Mandel 1982).
//
// Interval: profile likelihood. It includes each value that a parameter has in any law that the
// data do not exclude, with any exponent d: what the data cannot determine is not settled by
// assuming d = 2; nor is p by assuming 1 where another describes the speeds better, if not
// significantly. A dip is doubtful where a law without one, of any p, describes the speeds about as
// well. The scatter is estimated, hence Student's t with the law's residual degrees of freedom. The
// value is that of the simplest law that is not excluded: line, d = 2, any d.
//
// A speed whose friction is inconsistent with that of the others (F test of its deletion, Holm's
// correction for their number) is left out and named.
//
// It fails where few speeds were recorded: five laws then describe the same points, and the
// intervals say so.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "method/viscous/curve_model.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

/// Motor side. What is not certain states why.
struct SlidingQuantity {
  std::optional<statistics::Estimate> estimate;
  Statement why_not;  ///< Why there is none, or why it is doubtful; empty: neither.
};

/// A speed that was left out.
struct StrayFriction {
  double speed_rad_s{};
  std::vector<std::size_t> runs;  ///< Indices in ViscousCurvesResult::runs.
  double off_Nm{};                ///< Deviation from the law of the others.
};

struct SlidingLaw {
  bool fitted{false};  ///< What follows is valid.
  SlidingQuantity coulomb_Nm;
  SlidingQuantity stribeck_speed_rad_s;
  SlidingQuantity viscous_Nms_rad;
  bool has_dip{};               ///< The straight line is excluded.
  double level_Nm{};            ///< Tc of the law.
  double excess_Nm{};           ///< E
  double dip_rad_s{};           ///< ws
  double rise_Nm{};             ///< c w^p at the fastest speed.
  double fastest_rad_s{};       ///< Of the speeds used.
  double stribeck_exponent{2};  ///< d, and the values that are not excluded.
  double lowest_exponent{2};
  double highest_exponent{2};
  double viscous_exponent{1};  ///< p; other than 1 only where 1 is excluded.
  double scatter_Nm{};         ///< Standard deviation between speeds, beyond the scatter within the
                               ///< runs.
  /// Standard deviation between speeds of half the difference of the directions, where significant;
  /// else 0.
  double direction_scatter_Nm{};
  double residual_Nm{};  ///< Root mean square over the speeds.
  double freedom{};      ///< Residual degrees of freedom.
  std::size_t speeds{};  ///< Number of speeds used.
  std::vector<StrayFriction> left_out;
  std::vector<Statement> findings;  ///< "cause.stribeck...", "cause.outliers...", "check..."

  /// Makes all three doubtful for this reason, and adds it to the findings.
  void doubt(const Statement& why);
  /// The law's friction [N·m] at a motor speed >= 0. Valid if fitted.
  [[nodiscard]] double friction_Nm(double speed_rad_s) const;
};

/// @param samples of runs at constant speed: see curve_samples(). @param terms further terms of the
/// friction; its law is ignored.
SlidingLaw fit_sliding_law(const std::vector<CurveSample>& samples, const CurveModel& terms);

}  // namespace tribolog::method::viscous
