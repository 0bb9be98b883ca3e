// Intervals by both ways, gravity by every way, and where to oscillate next.

#include <utility>

#include "calibration/parts.h"

namespace tribolog::calibration {
namespace {

Json classical(const method::selection::ClassicalRegression& c) {
  return {{"q_peak_rad", interval(c.q_peak_rad)},
          {"gravity_Nm", interval(c.gravity_Nm)},
          {"textbook_gravity_Nm", interval(c.textbook_gravity_Nm)},
          {"coulomb_Nm", interval(c.coulomb_Nm)},
          {"viscous_Nms_rad", interval(c.viscous_Nms_rad)},
          {"inertia_kgm2", interval(c.inertia_kgm2)},
          {"offset_Nm", number(c.offset_Nm)},
          {"residual_Nm", number(c.residual_Nm)},
          {"white_noise_Nm", number(c.row_noise_Nm)}};
}

}  // namespace

Json intervals(const method::intervals::IntervalsResult& result) {
  Json quantities = Json::array();
  for (const method::intervals::TwoIntervals& q : result.quantities) {
    const char* stated = q.stated() == nullptr                                   ? nullptr
                         : q.stated() == (q.bootstrap ? &*q.bootstrap : nullptr) ? "bootstrap"
                                                                                 : "closed_form";
    quantities.push_back({{"name", q.name},
                          {"closed_form", interval(q.closed_form)},
                          {"bootstrap", interval(q.bootstrap)},
                          {"stated", stated == nullptr ? Json(nullptr) : Json(stated)}});
  }
  Json bands = Json::object();
  for (const method::intervals::CurveBand& band : result.bands) {
    bands[to_string(band.estimator)] = {{"low_Nm", numbers(band.low_Nm)},
                                        {"high_Nm", numbers(band.high_Nm)}};
  }
  Json choices = Json::object();
  for (const method::intervals::ChoiceShare& choice : result.choices)
    choices[to_string(choice.estimator)] = choice.share;
  return {{"resamples", result.resamples},
          {"seed", result.seed},
          {"quantities", std::move(quantities)},
          {"curve_bands", std::move(bands)},
          {"paper_rule_shares", std::move(choices)}};
}

Json cross_checks(const method::intervals::CrossChecksResult& result) {
  Json checks = Json::array();
  for (const method::intervals::CrossCheck& c : result.checks) {
    checks.push_back({{"method", method::intervals::to_string(c.method)},
                      {"recommended", c.is_recommended},
                      {"gravity_Nm", interval(c.gravity_Nm)},
                      {"mass_kg", interval(c.mass_kg)},
                      {"resampled_mass_kg", interval(c.resampled_kg)},
                      {"difference_percent", number(c.difference_percent)},
                      {"difference_half_width_percent", number(c.difference_half_width_percent)},
                      {"difference_in_intervals", number(c.difference_in_intervals)},
                      {"disagrees", c.disagrees}});
  }
  return {{"gravity", std::move(checks)},
          {"classical", result.classical ? classical(*result.classical) : Json(nullptr)}};
}

Json ripple(const method::gravity::Ripple& ripple) {
  Json lines = Json::array();
  for (const method::gravity::RippleLine& line : ripple.lines) {
    lines.push_back({{"periods_per_turn", number(line.periods_per_turn)},
                     {"amplitude_Nm", number(line.amplitude_Nm)},
                     {"phase_rad", number(line.phase_rad)}});
  }
  return {{"lines", std::move(lines)},
          {"rest_Nm", number(ripple.rest_Nm)},
          {"half_width_Nm", number(ripple.half_width_Nm())}};
}

Json position_plan(const std::optional<method::hysteresis::PositionPlan>& plan) {
  if (!plan) return nullptr;
  return {{"spread_motor_rad", number(plan->spread_motor_rad)},
          {"further_rad", numbers(plan->further_rad)},
          {"half_width_now_Nm", number(plan->half_width_now_Nm)},
          {"ripple_half_width_Nm", number(plan->ripple_half_width_Nm)},
          {"expected_half_width_Nm", number(plan->expected_half_width_Nm)}};
}

}  // namespace tribolog::calibration
