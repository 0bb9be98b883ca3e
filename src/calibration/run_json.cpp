// Stages 5 to 7.

#include <utility>

#include "calibration/parts.h"

namespace tribolog::json {

Json viscous(const ViscousCurvesResult& v) {
  Json runs = Json::array();
  for (const ConstantSpeedRun& r : v.runs) {
    runs.push_back(
        {{"recording", r.recording},
         {"speed_rad_s", number(r.speed_rad_s)},
         {"torque_Nm", number(r.torque_Nm)},
         {"torque_half_width_Nm", number(r.torque_half_width_Nm)},
         {"q_rad", number(r.q_rad)},
         {"mean_cos", number(r.mean_cos)},
         {"mean_load", number(r.mean_load)},
         {"lowest_rad", number(r.lowest_rad)},
         {"highest_rad", number(r.highest_rad)},
         {"samples", r.samples},
         {"partner", r.partner < 0 ? Json(nullptr) : Json(r.partner)},
         {"direction_difference_Nm", number(r.direction_difference_Nm)},
         {"direction_difference_half_width_Nm", number(r.direction_difference_half_width_Nm)},
         {"direction_mean_Nm", number(r.direction_mean_Nm)}});
  }
  Json curves = Json::object();
  for (const ViscousCurve& c : v.curves) curves[c.estimator] = numbers(c.friction_Nm);
  const auto angle = [&](bool has, double rad) { return has ? number(rad) : Json(nullptr); };
  const DirectionAngles& a = v.angles;
  Json angles{{"rising_low_rad", angle(a.has_rising, a.rising_low_rad)},
              {"rising_high_rad", angle(a.has_rising, a.rising_high_rad)},
              {"falling_low_rad", angle(a.has_falling, a.falling_low_rad)},
              {"falling_high_rad", angle(a.has_falling, a.falling_high_rad)},
              {"share_angles", a.share_angles()}};
  return {{"from_sweep", v.from_sweep},
          {"angles", std::move(angles)},
          {"samples_used", v.samples_used},
          {"samples_left_out", v.samples_left_out},
          {"recordings_without_plateau", v.recordings_without_plateau},
          {"runs", std::move(runs)},
          {"curves", std::move(curves)}};
}

Json quality(const QualityErrorsResult& q) {
  Json percent = Json::object();
  Json rms = Json::object();
  for (const QualityError& e : q.errors) {
    percent[e.estimator] = numbers(e.percent);
    rms[e.estimator] = number(e.rms_percent);
  }
  return {
      {"reference", text_or_null(q.reference)},
      {"reference_Nm", numbers(q.reference_Nm)},
      {"reference_half_width_Nm", numbers(q.reference_half_width_Nm)},
      {"reference_rms_percent", q.errors.empty() ? Json(nullptr) : number(q.reference_rms_percent)},
      {"evidence", text_or_null(q.evidence)},
      {"percent", std::move(percent)},
      {"rms_percent", std::move(rms)},
      {"runs_left_out", q.runs_left_out}};
}

Json selection(const SelectionResult& s) {
  return {{"paper_rule", text_or_null(s.paper_rule)},
          {"paper_rule_rivals", s.paper_rule_rivals},
          {"recommended", text_or_null(s.recommended)},
          {"why", text_or_null(s.why)},
          {"q_c_corrected_rad", number(s.q_c_corrected_rad)},
          {"q_c_rad", interval(s.q_c_rad)}};
}

}  // namespace tribolog::json
