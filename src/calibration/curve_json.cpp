// Stage 8.

#include <cmath>
#include <utility>

#include "calibration/parts.h"
#include "wording/words.h"

namespace tribolog::calibration {

namespace {

Json waiboer(const method::viscous::WaiboerFit& w, double n) {
  const double coefficient_to_joint = std::pow(n, 2.0 - w.viscous_power.value);
  return {{"converged", w.converged},
          {"asperity_torque_Nm", both_sides(w.asperity_torque_Nm, n)},
          {"stribeck_speed_rad_s", both_sides(w.stribeck_speed_rad_s, 1.0 / n)},
          {"stribeck_power", interval(w.stribeck_power)},
          {"viscous_coefficient", both_sides(w.viscous_coefficient, coefficient_to_joint)},
          {"viscous_power", interval(w.viscous_power)},
          {"residual_Nm", number(w.residual_Nm)}};
}

Json coulomb_viscous(const method::selection::CoulombViscousFit& f, double n) {
  return {{"coulomb_Nm", both_sides(f.coulomb_Nm, n)},
          {"viscous_Nms_rad", both_sides(f.viscous_Nms_rad, n * n)},
          {"residual_Nm", number(f.residual_Nm)},
          {"slowest_rad_s", number(f.slowest_rad_s)},
          {"fastest_rad_s", number(f.fastest_rad_s)}};
}

Json sliding_quantity(const method::viscous::SlidingQuantity& q, double to_joint) {
  return {{"estimate", q.estimate ? both_sides(*q.estimate, to_joint) : Json(nullptr)},
          {"why_not", words_or_null(q.why_not)},
          {"why_not_code", code_of(q.why_not)}};
}

Json sliding_law(const method::viscous::SlidingLaw& l, double n) {
  Json left_out = Json::array();
  for (const method::viscous::StrayFriction& s : l.left_out) {
    left_out.push_back({{"speed_rad_s", number(s.speed_rad_s)}, {"off_Nm", number(s.off_Nm)}});
  }
  return {{"coulomb_Nm", sliding_quantity(l.coulomb_Nm, n)},
          {"stribeck_speed_rad_s", sliding_quantity(l.stribeck_speed_rad_s, 1 / n)},
          {"viscous_Nms_rad", sliding_quantity(l.viscous_Nms_rad, n * n)},
          {"has_dip", l.has_dip},
          {"excess_Nm", number(l.excess_Nm)},
          {"stribeck_exponent", number(l.stribeck_exponent)},
          {"lowest_exponent", number(l.lowest_exponent)},
          {"highest_exponent", number(l.highest_exponent)},
          {"viscous_exponent", number(l.viscous_exponent)},
          {"scatter_Nm", number(l.scatter_Nm)},
          {"direction_scatter_Nm", number(l.direction_scatter_Nm)},
          {"residual_Nm", number(l.residual_Nm)},
          {"speeds", l.speeds},
          {"left_out", std::move(left_out)}};
}

}  // namespace

Json friction(const Calibration& c, double n) {
  const method::selection::FrictionParametersResult& f = c.friction;
  Json made{{"curve", text_or_null(to_string(f.curve))},
            {"waiboer", nullptr},
            {"coulomb_viscous", nullptr},
            {"sliding_law", nullptr},
            {"lugre", nullptr}};
  if (f.waiboer) made["waiboer"] = waiboer(*f.waiboer, n);
  if (f.coulomb_viscous) made["coulomb_viscous"] = coulomb_viscous(*f.coulomb_viscous, n);
  const method::viscous::SlidingLaw& law = c.curve_model.sliding;
  if (law.fitted) made["sliding_law"] = sliding_law(law, n);
  if (c.lugre) made["lugre"] = lugre(*c.lugre, n);
  return made;
}

// Stage 8: the ladder of models.

namespace {

Json model(const method::viscous::CurveModel& m) {
  return {{"law", method::viscous::to_string(m.law)},
          {"asymmetry", method::viscous::to_string(m.asymmetry)},
          {"load", m.load},
          {"parameters", m.parameters()}};
}

Json trials(const std::vector<method::viscous::CurveModelTrial>& all) {
  Json list = Json::array();
  for (const method::viscous::CurveModelTrial& t : all) {
    const bool took_part = t.excluded_because.empty();
    Json made = model(t.model);
    made["training_rms_Nm"] = took_part ? number(t.training_rms_Nm) : Json(nullptr);
    made["held_out_rms_Nm"] = took_part ? number(t.held_out_rms_Nm) : Json(nullptr);
    made["excluded_because"] = words_or_null(t.excluded_because);
    made["excluded_because_code"] = code_of(t.excluded_because);
    list.push_back(std::move(made));
  }
  return list;
}

}  // namespace

Json curve_model(const method::viscous::CurveModelChoice& c) {
  Json parameters = Json::array();
  for (const method::viscous::CurveParameter& p : c.parameters) {
    parameters.push_back(
        {{"name", p.name},
         {"words", wording::words(p.title)},
         {"words_code", code_of(p.title)},
         {"unit", p.unit_as.empty() ? unit_or_null(p.unit) : words_or_null(p.unit_as)},
         {"motor", interval(p.estimate)}});
  }
  return {{"curve", text_or_null(to_string(c.curve))},
          {"speeds", c.speeds},
          {"chosen", c.chosen_any ? model(c.chosen) : Json(nullptr)},
          {"sentence", wording::words(c.sentence)},
          {"sentence_code", code_of(c.sentence)},
          {"parameters", std::move(parameters)},
          {"ladder", trials(c.ladder)},
          {"options", trials(c.options)},
          {"carries_waiboer", c.carries_five},
          {"on_waiboer", words_or_null(c.five_sentence)},
          {"on_waiboer_code", code_of(c.five_sentence)}};
}

}  // namespace tribolog::calibration
