#pragma once
// The uncertainty budget after the GUM (JCGM 100): y = f(x1, x2, ...) in independent influences. u²
// is the sum of (sensitivity times standard uncertainty)², its effective degrees of freedom are by
// the Welch-Satterthwaite formula (G.2b), and the coverage factor is Student's t for these at 95 %.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "statistics/estimate.h"

namespace tribolog::calibration {

/// What a quantity's error comes from.
enum class Influence {
  recordings,       ///< Type A: noise, ripple, few positions, the model; the interval as found.
  disagreement,     ///< Type A: between methods that should agree; in files of older programs.
  torque_constant,  ///< Type B, like those below: as the manifest states them.
  gear_ratio,
  surrogate_distance,
  gravity,
  angle_zero,
  hoses,        ///< Torque of the angle that over part of a turn looks like gravity.
  description,  ///< Masses of the arm, by which the gravity of its other joints was taken off.
};

std::string to_string(Influence influence);

/// One contribution to a quantity's standard uncertainty.
struct BudgetPart {
  Influence influence{};
  bool is_type_b{};
  std::optional<double> stated;  ///< Half width at 95 %: percent; degrees for the angle's zero.
  double sensitivity{
      1};  ///< Relative change of the quantity over that of the influence; 1 for the angle's zero.
  double standard_uncertainty{};  ///< Of the quantity, in its unit: half width over t (type A) or
                                  ///< over 1.96 (type B).
  double freedom{};               ///< Degrees of freedom; infinity: exactly known.
  double share{};                 ///< Of the combined variance.
  /// What the error comes from: calibrations with the same text share it. Type B only.
  std::string id{};
};

/// What an effect of the one model has of the variance that the recordings leave: what would go if
/// its size were known. Effects that the recordings cannot tell from one another overlap.
struct BudgetEffect {
  std::string effect;  ///< Its key, or "choice_of_law".
  double share{};
  double size{};     ///< As stated, or as is typical; 0: it has none.
  std::string unit;  ///< Of the size: "percent", "ms", "mrad".
  bool is_stated{};
};

struct UncertaintyBudget {
  std::vector<BudgetPart> parts;      ///< The largest first.
  std::vector<BudgetEffect> effects;  ///< Of the part `recordings`, the largest first.
  std::vector<Influence> not_stated;  ///< Affect the quantity, and are not included.
  double standard_uncertainty{};
  double freedom{};  ///< Effective.
  double coverage_factor{};
  /// 95 %, with all parts; the estimate's own interval where nothing is stated.
  statistics::Estimate expanded;
};

/// Half width of a 95 % interval over the standard uncertainty. @param freedom > 0 or infinity.
double coverage_factor(double freedom);

/// @param parts, shares not set; those of type A come first and have the same degrees of freedom.
UncertaintyBudget combined(const statistics::Estimate& estimate, std::vector<BudgetPart> parts,
                           std::vector<Influence> not_stated);

/// From the word of to_string(); nothing for any other.
std::optional<Influence> influence_of(const std::string& word);

/// The budget that the quantity has times the gear ratio to a power, which changes its sensitivity
/// to the gear ratio; still in the quantity's own unit.
UncertaintyBudget budget_at(const UncertaintyBudget& budget, const statistics::Estimate& estimate,
                            int gear_power);

/// The expanded interval that the quantity has times the gear ratio to a power, which changes its
/// sensitivity to the gear ratio; still in the quantity's own unit.
statistics::Estimate expanded_at(const UncertaintyBudget& budget,
                                 const statistics::Estimate& estimate, int gear_power);

}  // namespace tribolog::calibration
