#pragma once
// The verdict on one quantity: can it be used, why not, and what to record next.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "calibration/uncertainty_budget.h"
#include "joint/quantity.h"
#include "statistics/estimate.h"

namespace tribolog::calibration {

enum class Verdict { usable, doubtful, not_identifiable };

std::string to_string(Verdict verdict);

/// Outcome of one number of a `[[limit]]`.
enum class LimitState {
  inside,   ///< Estimate and interval keep it.
  outside,  ///< Estimate and interval break it.
  crosses,  ///< The interval lies on both sides: it is not shown that the limit is kept.
  unknown,  ///< There is no estimate.
};

std::string to_string(LimitState state);

/// Which number of a `[[limit]]`.
enum class LimitRule { min, max, half_width, half_width_percent };

/// As the manifest spells it: "half_width".
std::string to_string(LimitRule rule);

struct LimitOutcome {
  std::string key;  ///< As the manifest spells it: "coulomb_joint_Nm".
  bool at_joint{};  ///< The key names the joint's side.
  LimitRule rule{};
  double limit{};  ///< In `unit`.
  std::string unit;
  std::optional<statistics::Estimate> estimate;  ///< In the key's unit.
  LimitState state{LimitState::unknown};
  Statement outcome;  ///< "Coulomb torque 13.4 N·m breaks the limit of at most 12 N·m".
};

struct QuantityVerdict {
  joint::Quantity quantity{};
  Verdict verdict{Verdict::usable};
  bool decides{true};                            ///< Counts in the overall verdict.
  std::vector<Statement> reasons;                ///< Empty only if usable. Most important first.
  Statement experiment;                          ///< What to record next; empty only if usable.
  std::optional<statistics::Estimate> estimate;  ///< From the recordings alone. SI, motor side;
                                                 ///< absent for a curve, or where not found.
  std::optional<UncertaintyBudget> budget;       ///< Present with the estimate.
  std::string unit;                              ///< Of the estimate; empty for a curve.
  std::vector<LimitOutcome> limits;
};

/// Friction torque at a speed of the motor, the mean of both directions.
struct FrictionAtSpeed {
  double speed_rad_s{};  ///< Motor side.
  Verdict verdict{Verdict::usable};
  statistics::Estimate torque_Nm;  ///< Motor side; in ampere where the torque is.
  Statement reason;                ///< Empty only if usable.
  bool is_stated{};                ///< The manifest asks for this speed.
  /// While the joint's angle rises and while it falls, with the torque's offset, which no motion
  /// tells from friction that differs. Absent: of a file that an older program wrote.
  std::optional<statistics::Estimate> forward_Nm{};
  std::optional<statistics::Estimate> backward_Nm{};
};

enum class RuleState {
  kept,
  broken,
  not_computed,  ///< The data do not show the number: that is not a pass.
};

std::string to_string(RuleState state);

/// Outcome of one rule of the verdict: a number found in the data, compared with a threshold.
struct RuleOutcome {
  std::string rule;  ///< Stable: "loop_misfit".
  RuleState state{RuleState::not_computed};
  std::optional<double> value;
  double threshold{};                       ///< Broken above it.
  std::string unit;                         ///< Of both; empty: none.
  std::vector<joint::Quantity> quantities;  ///< Lowered if it is broken.
  Verdict lowers_to{Verdict::doubtful};
  Statement finding;  ///< What was found; empty unless broken.
  bool is_note{};     ///< Told after all other findings.
};

/// Lowers the verdict to `to` if it is better than that, and adds the reason, in front if the
/// verdict now rests on it. The experiment is that of the first reason.
void lower(QuantityVerdict& quantity, Verdict to, const Statement& reason,
           const Statement& experiment);

}  // namespace tribolog::calibration
