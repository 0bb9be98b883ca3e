#include "verdict/uncertainty_budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "joint/degrees.h"
#include "verdict/effect_findings.h"
#include "verdict/model_verdicts.h"
#include "verdict/quantity_rooms.h"

namespace tribolog::verdict {
namespace {

using calibration::BudgetPart;
using calibration::Influence;
using calibration::UncertaintyBudget;
using joint::Quantity;

constexpr double well_known = std::numeric_limits<double>::infinity();

/// On which sides of the gear torque and angle were logged.
struct LoggedSides {
  bool effort_at_joint{};
  bool angle_at_motor{};
};

LoggedSides sides_of(const calibration::Calibration& c) {
  LoggedSides sides;
  sides.effort_at_joint = c.manifest.drive.side() == joint::Side::joint;
  for (const joint::InputFile& file : c.inputs) {
    for (const joint::ColumnConversion& column : file.conversions) {
      if (column.signal != joint::LoggedSignal::angle) continue;
      for (const joint::ConversionStep& step : column.steps) {
        sides.angle_at_motor |= step.reason == joint::ConversionStep::Reason::gear;
      }
    }
  }
  return sides;
}

/// Exponents of the influences in a quantity; 0: it does not depend on that influence.
struct Exponents {
  double torque{}, gear{}, distance{}, gravity{};
  bool has_zero{};  ///< Of the angle.
};

Exponents exponents_of(Quantity quantity, const LoggedSides& sides) {
  const double of_torque = sides.effort_at_joint ? -1 : 0;  // the motor's torque is the joint's / n
  const double of_motion =
      sides.angle_at_motor ? 0 : 1;  // the motor's angle is n times the joint's
  switch (quantity) {
    case Quantity::cog_angle:
      return {0, of_motion - 1, 0, 0, true};
    case Quantity::gravity_torque:
    case Quantity::break_away_torque:
    case Quantity::coulomb_torque:
      return {1, of_torque, 0, 0, false};
    case Quantity::surrogate_mass:
      return {1, 1 + of_torque, -1, -1, false};
    case Quantity::bristle_stiffness:
    case Quantity::bristle_damping:
    case Quantity::viscous_coefficient:
    case Quantity::inertia:
      return {1, of_torque - of_motion, 0, 0, false};
    case Quantity::stribeck_speed:
      return {0, of_motion, 0, 0, false};
    case Quantity::viscous_curve:
      break;
  }
  return {};
}

class BudgetMaker {
 public:
  BudgetMaker(const calibration::Calibration& c, const LoggedSides& sides,
              const calibration::QuantityVerdict& q)
      : c_(c), sides_(sides), estimate_(*q.estimate), quantity_(q.quantity) {}

  UncertaintyBudget made() {
    add_recordings();
    const Exponents e = exponents_of(quantity_, sides_);
    const joint::StatedUncertainty& stated = c_.manifest.uncertainty;
    add(Influence::torque_constant, e.torque, stated.torque_constant_percent);
    if (c_.manifest.drive.gear_ratio() != 1)
      add(Influence::gear_ratio, e.gear, stated.gear_ratio_percent);
    add(Influence::surrogate_distance, e.distance, stated.surrogate_distance_percent);
    add(Influence::gravity, e.gravity, stated.gravity_percent);
    if (e.has_zero) add_zero(stated.angle_zero_deg);
    add_shift(Influence::hoses, stated.hoses_percent);
    add_shift(Influence::description, stated.description_percent);
    UncertaintyBudget budget =
        calibration::combined(estimate_, std::move(parts_), std::move(not_stated_));
    budget.effects = effects();
    return budget;
  }

 private:
  /// In the model; null: it does not state the quantity.
  [[nodiscard]] const method::model::ModelQuantity* of_model() const {
    return c_.model.find(quantity_ == Quantity::surrogate_mass ? Quantity::gravity_torque
                                                               : quantity_);
  }

  /// Empty where another stage made the estimate.
  [[nodiscard]] std::vector<calibration::BudgetEffect> effects() const {
    constexpr double worth_a_word = 0.05;
    std::vector<calibration::BudgetEffect> all;
    const auto add_effect = [&](std::string_view key, double share) {
      if (share < worth_a_word) return;
      calibration::BudgetEffect& effect =
          all.emplace_back(calibration::BudgetEffect{std::string(key), share, 0, {}, false});
      const joint::Effect* of = row_of_effect(key);
      if (of == nullptr || of->unit.empty()) return;
      effect.size = c_.manifest.effects.of(*of);
      effect.unit = of->unit;
      effect.is_stated = c_.manifest.effects.is_stated(*of);
    };
    const method::model::ModelQuantity* model = of_model();
    if (model != nullptr && estimate_.method.is("interval.of_model")) {
      for (const auto& one : model->shares) add_effect(one.effect, one.share);
    }
    for (const auto& one : shares_of_loops(c_, quantity_)) add_effect(one.effect, one.share);
    return all;
  }

  void add_recordings() {
    const double whole = estimate_.half_width() / calibration::coverage_factor(well_known);
    parts_.push_back({Influence::recordings, false, std::nullopt, 1, whole, well_known, 0});
  }

  void add(Influence influence, double exponent, const std::optional<double>& percent) {
    const bool is_of_joint_side = influence == Influence::gear_ratio && percent.has_value();
    if (exponent == 0 && !is_of_joint_side) return;
    if (!percent) {
      not_stated_.push_back(influence);
      return;
    }
    const double uncertainty = std::abs(exponent * estimate_.value) * *percent / 100 /
                               calibration::coverage_factor(well_known);
    parts_.push_back(
        {influence, true, percent, exponent, uncertainty, well_known, 0, id_of(influence)});
  }

  void add_zero(const std::optional<double>& degrees) {
    if (!degrees) {
      not_stated_.push_back(Influence::angle_zero);
      return;
    }
    parts_.push_back({Influence::angle_zero, true, degrees, 1,
                      *degrees * joint::rad_per_degree / calibration::coverage_factor(well_known),
                      well_known, 0, id_of(Influence::angle_zero)});
  }

  /// Of an influence whose effect was found by identifying again.
  void add_shift(Influence influence, const std::optional<double>& percent) {
    if (!percent) {
      // Of the model's numbers typical ones are in what the recordings give.
      if (influence == Influence::hoses && depends_on_gravity() && of_model() == nullptr) {
        not_stated_.push_back(influence);
      }
      return;
    }
    for (const calibration::InfluenceShift& shift : c_.influence_shifts) {
      const bool is_of_this = shift.influence == influence && shift.quantity == quantity_;
      if (!is_of_this || !shift.half_width) continue;
      const double share = *percent / 100 * std::abs(estimate_.value);
      const double sensitivity = share > 0 ? *shift.half_width / share : 0;
      parts_.push_back({influence, true, percent, sensitivity,
                        *shift.half_width / calibration::coverage_factor(well_known), well_known, 0,
                        id_of(influence)});
    }
  }

  [[nodiscard]] bool depends_on_gravity() const {
    return quantity_ == Quantity::cog_angle || quantity_ == Quantity::gravity_torque ||
           quantity_ == Quantity::surrogate_mass;
  }

  /// As the manifest states it; else what belongs to this joint is the same as long as its value
  /// is.
  [[nodiscard]] std::string id_of(Influence influence) const {
    const joint::Manifest& m = c_.manifest;
    const auto stated = m.uncertainty.id.find(calibration::to_string(influence));
    if (stated != m.uncertainty.id.end()) return stated->second;
    if (influence == Influence::surrogate_distance)
      return fmt::format("{:g} m", m.surrogate_distance_m);
    if (influence == Influence::gravity) return fmt::format("{:g} m/s²", m.gravity_m_s2);
    const std::string joint = fmt::format("{} {} {}: ", m.robot, m.serial, m.joint);
    if (influence == Influence::description && m.arm_gravity) {
      // Another motion has another error, though the masses are the same.
      return joint +
             fmt::format("{}, {:.4g} N·m", m.arm_gravity->description, m.arm_gravity->largest_Nm);
    }
    if (influence == Influence::gear_ratio)
      return joint + fmt::format("{:g}", m.drive.gear_ratio());
    if (influence == Influence::angle_zero) return joint + "0°";
    if (influence == Influence::hoses) return joint + "hoses";
    const std::optional<double> constant = m.drive.torque_constant_Nm_A();
    return joint + (constant ? fmt::format("{:g} N·m/A", *constant) : "N·m");
  }

  const calibration::Calibration& c_;
  const LoggedSides& sides_;
  const statistics::Estimate& estimate_;
  Quantity quantity_;
  std::vector<BudgetPart> parts_;
  std::vector<Influence> not_stated_;
};

}  // namespace

void state_budgets(const calibration::Calibration& c,
                   std::vector<calibration::QuantityVerdict>& quantities) {
  const LoggedSides sides = sides_of(c);
  for (calibration::QuantityVerdict& q : quantities) {
    if (q.estimate && std::isfinite(q.estimate->half_width()))
      q.budget = BudgetMaker(c, sides, q).made();
  }
}

void lower_verdicts_by_influences(const calibration::Calibration& c,
                                  std::vector<calibration::QuantityVerdict>& quantities) {
  for (const calibration::InfluenceShift& shift : c.influence_shifts) {
    if (shift.half_width) continue;
    const bool is_of_hoses = shift.influence == Influence::hoses;
    calibration::lower(
        verdict_on(shift.quantity, quantities), calibration::Verdict::doubtful,
        is_of_hoses ? Code{"cause.hidden_by_hoses"} : Code{"cause.hidden_by_description"},
        is_of_hoses ? Code{"record.without_hoses"} : Code{"record.other_joints_at_rest"});
  }
}

Statement what_is_not_stated(const calibration::Calibration& c,
                             const std::vector<calibration::QuantityVerdict>& quantities) {
  if (c.manifest.uncertainty.torque_constant_percent) return {};
  const bool has_torque = std::any_of(quantities.begin(), quantities.end(), [](const auto& q) {
    if (!q.budget || q.verdict != calibration::Verdict::usable) return false;
    const std::vector<Influence>& missing = q.budget->not_stated;
    return std::find(missing.begin(), missing.end(), Influence::torque_constant) != missing.end();
  });
  if (!has_torque) return {};
  return c.manifest.drive.kind() == joint::EffortKind::motor_current
             ? Statement{"budget.torque_constant_not_stated"}
             : Statement{"budget.torque_scale_not_stated"};
}

}  // namespace tribolog::verdict
