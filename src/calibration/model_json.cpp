#include <cmath>
#include <string>

#include "calibration/json_values.h"
#include "calibration/parts.h"
#include "wording/words.h"

namespace tribolog::calibration {

Json friction_at_speed(const Judgement& judgement) {
  Json all = Json::array();
  for (const FrictionAtSpeed& f : judgement.friction_at_speed) {
    all.push_back({{"speed_rad_s", number(f.speed_rad_s)},
                   {"estimate", number(f.torque_Nm.value)},
                   {"low", number(f.torque_Nm.low)},
                   {"high", number(f.torque_Nm.high)},
                   {"verdict", to_string(f.verdict)},
                   {"reason", words_or_null(f.reason)},
                   {"reason_code", code_of(f.reason)}});
  }
  return all;
}

namespace {

Json law(const method::model::ModelLaw& l) {
  Json candidates = Json::array();
  for (const method::model::CandidateLaw& one : l.candidates) {
    const Statement words = described(one.law);
    candidates.push_back({{"words", wording::words(words)},
                          {"words_code", code_of(words)},
                          {"probability", number(one.probability)}});
  }
  return {{"candidates", std::move(candidates)},
          {"carries_waiboer", l.carries_waiboer()},
          {"level_Nm", number(l.level_Nm)},
          {"rise_Nm", number(l.rise_Nm)},
          {"power", number(l.power)},
          {"bend_Nm", number(l.bend_Nm)},
          {"excess_Nm", number(l.excess_Nm)},
          {"dip_rad_s", number(l.dip_rad_s)},
          {"dip_power", number(l.dip_power)},
          {"slowest_rad_s", number(l.slowest_rad_s)},
          {"fastest_rad_s", number(l.fastest_rad_s)},
          {"dip_probability", number(l.dip_probability)},
          {"bend_probability", number(l.bend_probability)},
          {"stribeck_speed_rad_s", interval(l.stribeck_speed_rad_s)}};
}

}  // namespace

Json model(const method::model::ModelResult& model) {
  Json quantities = Json::array();
  for (const method::model::ModelQuantity& q : model.quantities) {
    if (!q.quantity) continue;
    Json shares = Json::array();
    for (const method::model::VarianceShare& share : q.shares) {
      constexpr double worth_a_word = 0.01;
      if (share.share < worth_a_word) continue;
      shares.push_back({{"effect", std::string(share.effect)}, {"share", number(share.share)}});
    }
    quantities.push_back({{"key", to_string(*q.quantity)},
                          {"estimate", number(q.estimate)},
                          {"low", number(q.low)},
                          {"high", number(q.high)},
                          {"shares", std::move(shares)}});
  }
  Json effects = Json::array();
  for (const method::model::ModelEffect& e : model.effects) {
    effects.push_back({{"effect", std::string(e.key)},
                       {"coefficients", static_cast<int>(e.freedom)},
                       {"chi2", std::isfinite(e.chi2) ? number(e.chi2) : Json(nullptr)},
                       {"torque_Nm", number(e.torque_Nm)},
                       {"largest_Nm", interval(e.largest_Nm)},
                       {"size_of_cap", number(e.size_of_cap)},
                       {"coefficient", interval(e.coefficient)}});
  }
  return {{"cells", model.cells},
          {"friction_Nm", number(model.friction_Nm)},
          {"top_Nm", number(model.top_Nm)},
          {"cells_far_off", number(model.cells_far_off)},
          {"samples_per_independent", number(model.samples_per_independent)},
          {"recordings_left_out", model.left_out.size()},
          {"law", model.law.empty() ? Json(nullptr) : law(model.law)},
          {"rest_Nm", interval(model.rest_Nm)},
          {"quantities", std::move(quantities)},
          {"effects", std::move(effects)},
          {"friction_of_loops", interval(model.friction_of_loops)},
          {"friction_of_ramps", interval(model.friction_of_ramps)},
          {"gain_of_loops", interval(model.gain_of_loops)}};
}

}  // namespace tribolog::calibration
