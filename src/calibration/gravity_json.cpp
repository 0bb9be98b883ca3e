// Stages 1 and 2.

#include <utility>

#include "calibration/parts.h"
#include "wording/words.h"

namespace tribolog::calibration {

namespace {

/// Standard deviations by cause, and the lines of the spectrum over time.
Json residual_causes(const method::gravity::CogSweepResult& r) {
  Json lines = Json::array();
  for (const method::gravity::VibrationLine& line : r.vibration) {
    lines.push_back(
        {{"frequency_Hz", number(line.frequency_Hz)}, {"amplitude_Nm", number(line.amplitude_Nm)}});
  }
  return {{"white_Nm", number(r.white_Nm)},
          {"ripple_Nm", number(r.ripple_Nm)},
          {"coloured_Nm", number(r.coloured_Nm)},
          {"friction_by_angle_Nm", number(r.friction_by_angle_Nm)},
          {"vibration", std::move(lines)}};
}

}  // namespace

Json cog(const method::gravity::CogSweepResult& r, double gear_ratio) {
  const auto if_found = [&r](double value) { return r.found ? number(value) : Json(nullptr); };
  const Json joint =
      r.found ? interval(statistics::scaled(r.gravity_Nm, gear_ratio)) : Json(nullptr);
  return {{"found", r.found},
          {"method", words_or_null(r.method)},
          {"method_code", code_of(r.method)},
          {"argmax_rad", if_found(r.argmax_rad)},
          {"argmax_low_rad", if_found(r.argmax_low_rad)},
          {"argmax_high_rad", if_found(r.argmax_high_rad)},
          {"argmax_torque_Nm", if_found(r.argmax_torque_Nm)},
          {"argmax_at_end", r.argmax_at_end},
          {"q_peak_rad", interval_if(r.found, r.q_peak_rad)},
          {"gravity_Nm", interval_if(r.found, r.gravity_Nm)},
          {"gravity_joint_Nm", joint},
          {"coulomb_Nm", interval(r.coulomb_Nm)},
          {"viscous_Nms_rad", interval(r.viscous_Nms_rad)},
          {"inertia_kgm2", interval(r.inertia_kgm2)},
          {"offset_Nm", if_found(r.offset_Nm)},
          {"torque_offset_Nm", interval(r.torque_offset_Nm)},
          {"residual_Nm", if_found(r.residual_Nm)},
          {"residual_causes", residual_causes(r)},
          {"lowest_rad", if_found(r.lowest_rad)},
          {"highest_rad", if_found(r.highest_rad)},
          {"both_directions", r.both_directions},
          {"constant_speed", r.constant_speed},
          {"samples_used", r.samples_used},
          {"samples_left_out", r.samples_left_out}};
}

// Stages 5 to 7.

Json viscous(const method::viscous::ViscousCurvesResult& v) {
  Json runs = Json::array();
  for (const method::viscous::ConstantSpeedRun& r : v.runs) {
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
  for (const method::viscous::ViscousCurve& c : v.curves)
    curves[to_string(c.estimator)] = numbers(c.friction_Nm);
  const auto angle = [&](bool has, double rad) { return has ? number(rad) : Json(nullptr); };
  const method::viscous::DirectionAngles& a = v.angles;
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

Json quality(const method::selection::QualityErrorsResult& q) {
  Json percent = Json::object();
  Json rms = Json::object();
  for (const method::selection::QualityError& e : q.errors) {
    percent[to_string(e.estimator)] = numbers(e.percent);
    rms[to_string(e.estimator)] = number(e.rms_percent);
  }
  return {
      {"reference", text_or_null(to_string(q.reference))},
      {"reference_Nm", numbers(q.reference_Nm)},
      {"reference_half_width_Nm", numbers(q.reference_half_width_Nm)},
      {"reference_rms_percent", q.errors.empty() ? Json(nullptr) : number(q.reference_rms_percent)},
      {"evidence", words_or_null(q.evidence)},
      {"evidence_code", code_of(q.evidence)},
      {"percent", std::move(percent)},
      {"rms_percent", std::move(rms)},
      {"runs_left_out", q.runs_left_out}};
}

Json selection(const method::selection::SelectionResult& s) {
  Json rivals = Json::array();
  for (const method::hysteresis::Estimator rival : s.paper_rule_rivals) {
    rivals.push_back(to_string(rival));
  }
  return {{"paper_rule", text_or_null(to_string(s.paper_rule))},
          {"paper_rule_rivals", std::move(rivals)},
          {"recommended", text_or_null(to_string(s.recommended))},
          {"why", words_or_null(s.why)},
          {"why_code", code_of(s.why)},
          {"q_c_corrected_rad", number(s.q_c_corrected_rad)},
          {"q_c_rad", interval(s.q_c_rad)}};
}

// What was stated about loads.

Json other_joints(const std::vector<joint::OtherJoint>& others) {
  Json list = Json::array();
  for (const joint::OtherJoint& other : others) {
    const bool is_logged = other.samples > 0;
    list.push_back({{"name", other.name},
                    {"column", other.angle},
                    {"samples", other.samples},
                    {"lowest_rad", is_logged ? number(other.lowest_rad) : Json(nullptr)},
                    {"highest_rad", is_logged ? number(other.highest_rad) : Json(nullptr)}});
  }
  return list;
}

Json arm_gravity(const std::optional<joint::ArmGravity>& arm) {
  if (!arm) return nullptr;
  Json held = Json::array();
  for (const joint::HeldJoint& one : arm->held) {
    held.push_back({{"joint", one.name},
                    {"position_rad", number(one.position_rad)},
                    {"logged", one.is_logged}});
  }
  return {{"description", arm->description},
          {"description_percent", number(arm->description_percent)},
          {"gravity_m_s2", arm->gravity_m_s2},
          {"tested", arm->tested},
          {"matched_by", arm->is_by_order ? "order" : "name"},
          {"held", std::move(held)},
          {"own", known_gravity(arm->own)},
          {"samples", arm->samples},
          {"largest_joint_Nm", number(arm->largest_Nm)}};
}

Json known_loads(const std::vector<joint::KnownLoad>& loads) {
  Json list = Json::array();
  for (const joint::KnownLoad& load : loads) {
    Json roles = Json::array();
    for (const joint::Role role : load.roles) roles.push_back(joint::to_string(role));
    list.push_back({{"amplitude_joint_Nm", number(load.amplitude_Nm)},
                    {"angles", load.angles},
                    {"phase_rad", number(load.phase_rad)},
                    {"roles", std::move(roles)},
                    {"note", text_or_null(load.note)},
                    {"samples", load.samples},
                    {"largest_joint_Nm", number(load.largest_Nm)}});
  }
  return list;
}

Json known_gravity(const std::optional<joint::StatedGravity>& g) {
  if (!g) return nullptr;
  return {{"amplitude_joint_Nm", number(g->amplitude_Nm())},
          {"q_peak_rad", number(g->q_peak_rad())},
          {"percent", number(g->percent())}};
}

}  // namespace tribolog::calibration
