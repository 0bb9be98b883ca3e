#pragma once
// The verdict's rules, one table of all: what is found in the data, from which value on it counts,
// which quantities it lowers and how far, and what to record instead. The worst applies.
//
// A rule is of a check on the data (method/checks/), which has its own limits, or has a number and
// a threshold; the report and the JSON show the latter with the values found. What the stages state
// of their own results (quantity_rooms.h) applies as well: those are no rules.

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/quantity_verdict.h"

namespace tribolog::verdict {

using Quantities = std::vector<joint::Quantity>;

inline Quantities operator+(const Quantities& a, const Quantities& b) {
  Quantities all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

// Families of quantities that rules touch.
inline const Quantities none{};
inline const Quantities of_angle{joint::Quantity::cog_angle};
inline const Quantities of_mass{joint::Quantity::gravity_torque, joint::Quantity::surrogate_mass};
inline const Quantities of_gravity = of_angle + of_mass;
inline const Quantities of_break_away{joint::Quantity::break_away_torque};
inline const Quantities of_stiffness{joint::Quantity::bristle_stiffness};
inline const Quantities of_damping{joint::Quantity::bristle_damping};
inline const Quantities of_loops = of_stiffness + of_damping;
inline const Quantities of_inertia{joint::Quantity::inertia};
inline const Quantities of_coulomb{joint::Quantity::coulomb_torque};
inline const Quantities of_curve_alone{joint::Quantity::viscous_curve};
inline const Quantities of_law{joint::Quantity::coulomb_torque,
                               joint::Quantity::viscous_coefficient,
                               joint::Quantity::stribeck_speed};
inline const Quantities of_curve = of_law + of_curve_alone;
inline const Quantities of_friction = of_curve + of_inertia + of_break_away;

/// What a rule found: the number, and the statement for when it is too large.
struct Measured {
  double value{};
  Statement finding;
};

/// A number of the data that breaks a rule where it is larger than the threshold.
struct RuleNumber {
  const char* name{};  ///< Stable: "loop_misfit".
  const char* unit{};  ///< Of value and threshold; "" if none.
  double threshold{};
  /// nullopt: the data do not show it.
  std::optional<Measured> (*measure)(const calibration::Calibration& calibration){};
  /// No news where it is as usual: reported after all other findings.
  bool is_note{};
};

struct Rule {
  using Applies = bool (*)(const calibration::Calibration& calibration);

  Rule(method::checks::CheckName check, calibration::Verdict to, Quantities touched,
       Quantities beyond, Applies when = nullptr)
      : by(check),
        lowers_to(to),
        quantities(std::move(touched)),
        beyond_intervals(std::move(beyond)),
        applies(when) {}
  Rule(RuleNumber number, calibration::Verdict to, Quantities touched, Quantities beyond,
       Code record)
      : by(number),
        lowers_to(to),
        quantities(std::move(touched)),
        beyond_intervals(std::move(beyond)),
        experiment(record) {}

  [[nodiscard]] const RuleNumber* number() const { return std::get_if<RuleNumber>(&by); }

  /// Broken where this fails (which says what to record), or by the number.
  std::variant<method::checks::CheckName, RuleNumber> by;
  /// usable: the finding is reported, and was corrected.
  calibration::Verdict lowers_to;
  Quantities quantities;
  /// Of these, those whose interval by the model of sweeps and runs cannot hold what is found: the
  /// numbers are of something else then.
  Quantities beyond_intervals;
  Code experiment;    ///< What to record next; of a check: empty.
  Applies applies{};  ///< Whether the quantities come from what the rule is about; absent: they do.
};

/// In the order in which their findings are reported, most important first.
std::vector<Rule> check_rules();
std::vector<Rule> gravity_rules();
std::vector<Rule> friction_rules();

/// All of them, in this order.
const std::vector<Rule>& rules();

/// A rule that is broken.
struct BrokenRule {
  const Rule* rule{};
  Statement reason;  ///< Against a quantity.
  Statement experiment;
};

struct AppliedRules {
  std::vector<BrokenRule> broken;                    ///< In the order of the table.
  std::vector<calibration::RuleOutcome> outcomes{};  ///< Of the rules with a threshold.
};

AppliedRules apply_rules(const calibration::Calibration& calibration);

/// Lowers what the broken rules touch.
void lower_by_rules(const std::vector<BrokenRule>& broken,
                    std::vector<calibration::QuantityVerdict>& quantities);

/// Whether gravity is too small relative to friction for its torque and angle to be known.
bool is_without_gravity(const std::vector<BrokenRule>& broken);

}  // namespace tribolog::verdict
