#include "verdict/model_verdicts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "calibration/headline.h"
#include "joint/degrees.h"
#include "verdict/effect_findings.h"
#include "verdict/needs.h"
#include "verdict/quantity_rooms.h"
#include "verdict/rules.h"

namespace tribolog::verdict {
namespace {

using calibration::Calibration;
using calibration::QuantityVerdict;
using calibration::Verdict;
using joint::Quantity;
using method::model::ModelEffect;
using method::model::ModelQuantity;
using method::model::ModelResult;

bool is_of_gravity(Quantity quantity) {
  return quantity == Quantity::cog_angle || quantity == Quantity::gravity_torque;
}

/// What to record where most of an interval comes from an effect, or from the choice of the law.
Statement remedy_of(std::string_view key) {
  const joint::Effect* row = row_of_effect(key);
  return row == nullptr || row->remedy.empty() ? Statement{record_runs}
                                               : Statement{Code::of(std::string(row->remedy))};
}

/// Whether the effect is a torque of the joint's angle, as gravity is.
bool is_of_angle(std::string_view effect) {
  constexpr std::array all{joint::effect::hoses.key,
                           joint::effect::harmonics.key,
                           joint::effect::smooth_over_angle.key,
                           joint::effect::angle_scale.key,
                           joint::effect::homing.key,
                           joint::effect::torque_over_turn.key};
  return std::find(all.begin(), all.end(), effect) != all.end();
}

/// Whether a variance is of not knowing the law of friction over the speed.
bool is_of_law(std::string_view effect) {
  constexpr std::array all{std::string_view("choice_of_law"), joint::effect::law_misfit.key,
                           joint::effect::law_at_its_ends.key};
  return std::find(all.begin(), all.end(), effect) != all.end();
}

/// Where as many runs were recorded as are asked for, the advice names the speeds to add.
/// @param otherwise What to record where runs are missing, or the quantity is not a limit of the
/// law.
Statement experiment_about_law(const Calibration& c, Quantity quantity,
                               const Statement& otherwise) {
  constexpr std::size_t both_directions_of_ten = 20;
  if (c.viscous.from_sweep || c.viscous.runs.size() < both_directions_of_ten) return otherwise;
  if (quantity == Quantity::coulomb_torque) return {"record.slower_speeds"};
  if (quantity == Quantity::viscous_coefficient) return {"record.faster_speeds"};
  return otherwise;
}

bool is_of_friction(Quantity quantity) {
  return quantity == Quantity::coulomb_torque || quantity == Quantity::viscous_coefficient ||
         quantity == Quantity::viscous_curve;
}

struct Doubt {
  Verdict verdict{Verdict::usable};
  Statement reason;
  Statement experiment;

  void lower(Verdict to, const Statement& why, const Statement& record) {
    if (to <= verdict) return;
    verdict = to;
    reason = why;
    experiment = record;
  }
};

/// What contradicts the model wherever this quantity is read.
Doubt contradiction(const Calibration& c, const std::vector<BrokenRule>& rules, Quantity quantity) {
  constexpr double most_far_off = 0.04;
  Doubt doubt;
  for (const BrokenRule& broken : rules) {
    const Quantities& beyond = broken.rule->beyond_intervals;
    if (std::find(beyond.begin(), beyond.end(), quantity) == beyond.end()) continue;
    doubt.lower(broken.rule->lowers_to, broken.reason, broken.experiment);
  }
  // Loops and other ways to gravity are not in the model.
  if (c.cross_checks.doubtful && quantity == Quantity::gravity_torque) {
    for (const Statement& finding : c.cross_checks.findings) {
      doubt.lower(Verdict::doubtful, finding, {"record.second_measurement"});
    }
  }
  const ModelResult& m = c.model;
  if (m.cells_far_off > most_far_off) {
    doubt.lower(Verdict::doubtful, {"model.cells_far_off", {{"percent", 100 * m.cells_far_off}}},
                {"record.better_motion"});
  }
  if (m.unlike_left > 0) {
    doubt.lower(Verdict::doubtful, {"model.recordings_unlike", {{"recordings", m.unlike_left}}},
                {"record.repeated_runs"});
  }
  for (const Quantity one : {Quantity::coulomb_torque, Quantity::viscous_coefficient}) {
    const ModelQuantity* found = m.find(one);
    if (found != nullptr && found->high < 0) {
      doubt.lower(Verdict::doubtful, {"model.negative_friction"}, record_runs);
    }
  }
  return doubt;
}

/// The same for one number, with the effects that it depends on, and by need.
/// @param common contradiction() of the quantity.
Doubt doubt_of(const Calibration& c, Quantity quantity, const ModelQuantity& by_model,
               const Doubt& common) {
  constexpr double significant = 4;  // chi-square per coefficient
  constexpr double matters = 0.25;   // of the variance
  constexpr double most = 0.5;       // the same
  constexpr double most_of_others = 0.5;
  Doubt doubt = common;
  const bool is_angle = quantity == Quantity::cog_angle;
  const double half = (by_model.high - by_model.low) / 2;
  const double width = is_angle ? half : half / std::abs(by_model.estimate);
  const double need = need_of(c, quantity, by_model.estimate);
  // Over part of a turn what looks like gravity has many forms, and one that shows may be another:
  // by some intervals, which may be less than what matters.
  constexpr double of_another_form = 3;
  const bool form_matters = of_another_form * width > need;
  double of_angle = 0;
  for (const auto& share : by_model.shares) of_angle += is_of_angle(share.effect) ? share.share : 0;
  for (const ModelEffect& effect : c.model.effects) {
    if (effect.key == "law_misfit") continue;
    // A size that nothing explains is not asked of a chi-square.
    const bool shows = std::isnan(effect.chi2) || effect.chi2 > significant * effect.freedom;
    const bool is_at_cap = shows && effect.is_near_cap();
    const bool shows_there =
        shows && form_matters && is_of_gravity(quantity) && is_of_angle(effect.key);
    for (const auto& share : by_model.shares) {
      if (share.effect != effect.key) continue;
      if (!(is_at_cap && share.share >= matters) && !(shows_there && of_angle >= most)) continue;
      doubt.lower(Verdict::doubtful,
                  {is_at_cap ? Code{"model.effect_too_large"} : Code{"model.rests_on_effect"},
                   {{"effect", name_of_effect(effect.key)}}},
                  remedy_of(effect.key));
    }
  }
  // Of other joints' gravity and inertia the angles alone are known: beside the friction they must
  // be small.
  const ModelQuantity* coulomb = c.model.find(Quantity::coulomb_torque);
  if (is_of_friction(quantity) && coulomb != nullptr) {
    for (const ModelEffect& effect : c.model.effects) {
      const bool is_of_others = effect.key == "others_gravity" || effect.key == "others_inertia";
      if (!is_of_others || effect.torque_Nm < most_of_others * std::abs(coulomb->estimate))
        continue;
      doubt.lower(Verdict::doubtful,
                  {"model.others_too_large", {{"effect", name_of_effect(effect.key)}}},
                  remedy_of(effect.key));
    }
  }
  if (!(width <= need) && !by_model.shares.empty()) {
    const auto& largest = by_model.shares.front();
    const Statement effect = name_of_effect(largest.effect);
    const double unit = is_angle ? joint::degrees_per_rad : 100;
    if (!(width <= widest_known(quantity))) {
      doubt.lower(Verdict::not_identifiable, {"model.not_shown", {{"effect", effect}}},
                  remedy_of(largest.effect));
    }
    doubt.lower(Verdict::doubtful,
                {is_angle ? Code{"model.angle_wide"} : Code{"model.wide"},
                 {{"half_width", unit * width}, {"need", unit * need}, {"effect", effect}}},
                remedy_of(largest.effect));
  }
  return doubt;
}

void take(const ModelQuantity& by_model, const Doubt& doubt, QuantityVerdict& q) {
  q.estimate = by_model.as_estimate();
  q.verdict = doubt.verdict;
  q.reasons.clear();
  if (!doubt.reason.empty()) q.reasons.push_back(doubt.reason);
  q.experiment = doubt.experiment;
}

}  // namespace

void state_by_model(const Calibration& c, const std::vector<BrokenRule>& rules,
                    std::vector<QuantityVerdict>& quantities) {
  for (const Quantity quantity : {Quantity::cog_angle, Quantity::gravity_torque, Quantity::inertia,
                                  Quantity::coulomb_torque, Quantity::viscous_coefficient}) {
    const ModelQuantity* by_model = c.model.find(quantity);
    if (by_model == nullptr) continue;
    QuantityVerdict& q = verdict_on(quantity, quantities);
    const Doubt doubt = doubt_of(c, quantity, *by_model, contradiction(c, rules, quantity));
    const bool is_of_loops =
        quantity == Quantity::inertia &&
        calibration::inertia_headline(c).source == calibration::InertiaSource::loops;
    if (is_of_loops) continue;
    take(*by_model, doubt, q);
    // Where the laws of friction disagree, friction at the speeds is what there is to know.
    const bool hangs_on_law =
        !by_model->shares.empty() && is_of_law(by_model->shares.front().effect);
    if (hangs_on_law && q.verdict != Verdict::usable) {
      q.decides = false;
      q.experiment = experiment_about_law(c, quantity, q.experiment);
    }
    if (quantity == Quantity::gravity_torque && !c.manifest.torque_is_in_amperes) {
      const joint::Manifest& manifest = c.manifest;
      const double kg_per_Nm = joint::surrogate_mass_kg(
          1, manifest.drive.gear_ratio(), manifest.surrogate_distance_m, manifest.gravity_m_s2, 1);
      ModelQuantity mass = *by_model;
      mass.estimate *= kg_per_Nm;
      mass.low *= kg_per_Nm;
      mass.high *= kg_per_Nm;
      take(mass, doubt, verdict_on(Quantity::surrogate_mass, quantities));
    }
  }
}

std::vector<method::hysteresis::EffectShare> shares_of_loops(const Calibration& c,
                                                             Quantity quantity) {
  using method::hysteresis::LuGreParameterName;
  const std::array read{
      std::pair(Quantity::break_away_torque, LuGreParameterName::static_torque),
      std::pair(Quantity::bristle_stiffness, LuGreParameterName::bristle_stiffness),
      std::pair(Quantity::bristle_damping, LuGreParameterName::bristle_damping)};
  // Of the break-away torque where ramps do not know it better.
  const auto& ramps = c.break_away.mean_Nm;
  const auto level = c.lugre ? c.lugre->shown(LuGreParameterName::static_torque) : std::nullopt;
  const bool is_of_ramps = quantity == Quantity::break_away_torque && ramps &&
                           (!level || level->half_width() > ramps->half_width());
  for (const auto& [of, name] : read) {
    if (of != quantity || !c.lugre || is_of_ramps) continue;
    for (const method::hysteresis::LuGreParameter& one : c.lugre->parameters) {
      if (one.name == name) return one.shares;
    }
  }
  return {};
}

void doubt_wide_contacts(const Calibration& c, std::vector<QuantityVerdict>& quantities) {
  constexpr double matters = 0.25;  // of the variance
  for (const Quantity quantity :
       {Quantity::break_away_torque, Quantity::bristle_stiffness, Quantity::bristle_damping}) {
    QuantityVerdict& q = verdict_on(quantity, quantities);
    if (!q.estimate) continue;
    const double width = q.estimate->half_width() / std::abs(q.estimate->value);
    const double need = need_of(c, quantity, q.estimate->value);
    if (width <= need) continue;
    const auto shares = shares_of_loops(c, quantity);
    if (shares.empty() || shares.front().share < matters) {
      calibration::lower(q, Verdict::doubtful,
                         {"verdict.known_to_share", {{"percent", 100 * width}}}, q.experiment);
      continue;
    }
    calibration::lower(q, Verdict::doubtful,
                       {"model.wide",
                        {{"half_width", 100 * width},
                         {"need", 100 * need},
                         {"effect", name_of_effect(shares.front().effect)}}},
                       remedy_of(shares.front().effect));
  }
}

std::vector<calibration::FrictionAtSpeed> friction_at_speeds(const Calibration& c,
                                                             const std::vector<BrokenRule>& rules) {
  std::vector<calibration::FrictionAtSpeed> all;
  const Doubt common = contradiction(c, rules, Quantity::viscous_curve);
  for (const ModelQuantity& q : c.model.quantities) {
    if (q.quantity) continue;
    const Doubt doubt = doubt_of(c, Quantity::viscous_curve, q, common);
    all.push_back({q.speed_rad_s, doubt.verdict, q.as_estimate(), doubt.reason, false, q.forward,
                   q.backward});
  }
  return all;
}

}  // namespace tribolog::verdict
