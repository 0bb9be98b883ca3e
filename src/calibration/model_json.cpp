#include <cmath>
#include <optional>
#include <string>

#include "calibration/parts.h"

namespace tribolog::calibration {

namespace {

void state_direction(Fields& f, const statistics::Estimate& e) {
  f.number("estimate", e.value);
  f.number("low", e.low);
  f.number("high", e.high);
}

}  // namespace

void state_friction_at_speed(Fields& f, const Judgement& judgement) {
  f.list(
      "friction_at_speed", judgement.friction_at_speed,
      "Friction torque at speeds of the motor, by one model of all sweeps, runs and friction "
      "points: rising, a step of 4 % or less apart; empty where none was measured.",
      [](Fields& one, const FrictionAtSpeed& at) {
        one.number("speed_rad_s", at.speed_rad_s, "Motor side.");
        one.number("estimate", at.torque_Nm.value,
                   "Torque, motor side, the mean of both directions: in N·m, or in ampere where "
                   "the drive's torque_is_in_amperes.");
        one.number("low", at.torque_Nm.low, "Of the 95 % credible interval.");
        one.number("high", at.torque_Nm.high, "Of the 95 % credible interval.");
        one.object_or_null("forward", at.forward_Nm,
                           "While the joint's angle rises: what the drive gives beside gravity, "
                           "friction with the torque's offset, which no motion tells from friction "
                           "that differs. Null: of a program that did not state it.",
                           state_direction);
        one.object_or_null("backward", at.backward_Nm, "The same, opposed, while the angle falls.",
                           state_direction);
        one.choice("verdict", at.verdict);
        one.words_or_null("reason", at.reason, "Null only if usable.");
      },
      "One speed.");
  std::vector<double> stated;
  for (const FrictionAtSpeed& at : judgement.friction_at_speed) {
    if (at.is_stated) stated.push_back(at.speed_rad_s);
  }
  f.numbers("friction_stated_at_rad_s", stated,
            "Those of the speeds that the manifest asks for; empty where it states none.");
}

namespace {

void state_law(Fields& f, const method::model::ModelLaw& l) {
  f.list("candidates", l.candidates, "Candidate laws, likeliest first.",
         [](Fields& one, const method::model::CandidateLaw& law) {
           one.words("words", described(law.law));
           one.number("probability", law.probability, "Posterior, 0 to 1.");
         });
  f.flag("carries_waiboer", l.carries_waiboer(),
         "Whether the recordings carry Waiboer's five parameters: dip and bend both beyond 95 %.");
  f.number("level_Nm", l.level_Nm, "Coulomb torque Tc.");
  f.number("rise_Nm", l.rise_Nm, "a, viscous torque at the fastest speed.");
  f.number("power", l.power, "p, of the speed.");
  f.number("bend_Nm", l.bend_Nm, "b, quadratic torque at the fastest speed.");
  f.number("excess_Nm", l.excess_Nm, "E, Stribeck excess at rest; 0: no dip.");
  f.number("dip_rad_s", l.dip_rad_s, "ws.");
  f.number("dip_power", l.dip_power, "d.");
  f.number("slowest_rad_s", l.slowest_rad_s, "Slowest speed measured.");
  f.number("fastest_rad_s", l.fastest_rad_s, "vmax, fastest speed measured.");
  f.number("dip_probability", l.dip_probability, "Of all laws with a Stribeck dip.");
  f.number("bend_probability", l.bend_probability,
           "Of all laws that are not linear in speed but for the dip.");
  f.interval("stribeck_speed_rad_s", l.stribeck_speed_rad_s,
             "Null where a law without a dip is not excluded.");
}

void state_model_quantity(Fields& f, const method::model::ModelQuantity& q) {
  std::vector<method::model::VarianceShare> shares = q.shares;
  std::erase_if(shares, [](const auto& share) {
    constexpr double worth_a_word = 0.01;
    return share.share < worth_a_word;
  });
  f.text("key", q.quantity ? std::string(to_string(*q.quantity)) : "");
  f.number("estimate", q.estimate, "Posterior mean.");
  f.number("low", q.low, "Of the 95 % credible interval.");
  f.number("high", q.high, "Of the 95 % credible interval.");
  f.list(
      "shares", shares, "",
      [](Fields& one, const method::model::VarianceShare& share) {
        one.text("effect", std::string(share.effect));
        one.number("share", share.share, "Of the variance.");
      },
      "Part of the variance that would go if the effect were known; parts overlap.");
}

void state_model_effect(Fields& f, const method::model::ModelEffect& e) {
  f.text("effect", std::string(e.key));
  f.count("coefficients", static_cast<int>(e.freedom));
  f.number("chi2", e.chi2, "Of its coefficients against none; null where it is not asked.");
  f.number("torque_Nm", e.torque_Nm, "Root mean square over the cells.");
  f.put("largest_Nm", interval(e.largest_Nm), R"({"$ref": "#/$defs/estimate"})",
        "Its torque where that is largest.");
  f.number("size_of_cap", e.size_of_cap, "Its size over the largest that the catalogue knows.");
  f.interval("coefficient", e.coefficient,
             "Of an effect with one coefficient, SI, motor side; of the lag in seconds, positive "
             "where the torque is logged later than the angle. null: it has several.");
}

}  // namespace

void state_model(Fields& f, const method::model::ModelResult& model) {
  std::vector<method::model::ModelQuantity> quantities = model.quantities;
  std::erase_if(quantities, [](const auto& one) { return !one.quantity; });
  f.count("cells", model.cells, "Means over a stretch of angle and speed that it was fitted to.");
  f.number("friction_Nm", model.friction_Nm, "Median size of the friction over them.");
  f.number("top_Nm", model.top_Nm, "98th percentile of the torque's size.");
  f.number("cells_far_off", model.cells_far_off, "Share of them whose weight fell below 0.3.");
  f.number("samples_per_independent", model.samples_per_independent,
           "Neighbouring cells that say as much as one independent one.");
  f.count("recordings_left_out", model.left_out.size(), "Recordings unlike all others.");
  f.object_or_null("law", model.law.empty() ? nullptr : &model.law,
                   "Likeliest law of sliding friction, motor side: |Tf| = Tc + a (|w|/vmax)^p + b "
                   "(|w|/vmax)^2 + E exp(-(|w|/ws)^d). Null where there is no model.",
                   state_law);
  f.interval("rest_Nm", model.rest_Nm,
             "Friction at rest by the laws; null where the runs do not reach into the dip.");
  f.list("quantities", quantities, "", state_model_quantity,
         "SI, motor side; an angle of the joint.");
  f.list("effects", model.effects, "", state_model_effect, "An effect of the catalogue.");
  f.interval("friction_of_loops", model.friction_of_loops,
             "By which share of itself friction where the oscillations were recorded differs from "
             "that at the mean load, place and time of the runs. null: there are none.");
  f.interval("friction_of_ramps", model.friction_of_ramps, "The same of the break-away ramps.");
  f.interval("gain_of_loops", model.gain_of_loops,
             "By which share of itself a small change of the torque is logged too large under the "
             "load of the loops; null: there are none.");
}

}  // namespace tribolog::calibration
