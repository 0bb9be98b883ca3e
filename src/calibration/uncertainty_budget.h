#pragma once
// The uncertainty budget after the GUM (JCGM 100): y = f(x1, x2, ...) in independent influences. u²
// is the sum of (sensitivity times standard uncertainty)², its degrees of freedom are those of
// Welch and Satterthwaite (G.2b), and the coverage factor is Student's t at 95 % of these.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "statistics/estimate.h"

namespace tribolog::calibration {

/// What a quantity's error comes from.
enum class Influence {
  recordings,       ///< Type A: noise, ripple, few positions, the model: the interval as found.
  disagreement,     ///< Type A: between methods that should agree.
  torque_constant,  ///< Type B, as the following: as the manifest states them.
  gear_ratio,
  surrogate_distance,
  gravity,
  angle_zero,
};

std::string to_string(Influence influence);

/// One part of a quantity's standard uncertainty.
struct BudgetPart {
  Influence influence{};
  bool is_type_b{};
  std::optional<double> stated;  ///< Half width at 95 %: percent, or degrees of the angle's zero.
  double sensitivity{
      1};  ///< Relative change of the quantity by that of the influence; of the zero: 1.
  double standard_uncertainty{};  ///< Of the quantity, in its unit: type A, half width / t; type B,
                                  ///< / 1.96.
  double freedom{};               ///< Degrees of freedom; infinity: well known.
  double share{};                 ///< Of the combined variance.
};

struct UncertaintyBudget {
  std::vector<BudgetPart> parts;      ///< The largest first.
  std::vector<Influence> not_stated;  ///< Bear upon the quantity, and are not included.
  double standard_uncertainty{};
  double freedom{};  ///< Effective.
  double coverage_factor{};
  /// 95 %, with all parts. The estimate itself where nothing is stated.
  statistics::Estimate expanded;
};

/// Half width of a 95 % interval over the standard uncertainty. @param freedom > 0 or infinity.
double coverage_factor(double freedom);

/// @param parts without their shares; those of type A are first, and share their degrees of
/// freedom.
UncertaintyBudget combined(const statistics::Estimate& estimate, std::vector<BudgetPart> parts,
                           std::vector<Influence> not_stated);

/// The expanded interval of the quantity times the gear ratio to a power, which changes how it
/// hangs on the gear ratio; in the quantity's own unit all the same.
statistics::Estimate expanded_at(const UncertaintyBudget& budget,
                                 const statistics::Estimate& estimate, int gear_power);

}  // namespace tribolog::calibration
