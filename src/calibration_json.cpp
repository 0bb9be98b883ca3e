#include "calibration_json.h"

#include <cmath>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

namespace tribolog {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json interval(const Estimate& e) {
  if (!std::isfinite(e.value)) return nullptr;
  return {{"estimate", e.value},
          {"low", number(e.low)},
          {"high", number(e.high)},
          {"method", e.method}};
}

Json interval(const std::optional<Estimate>& e) { return e ? interval(*e) : Json(nullptr); }

Json interval_if(bool is_known, const Estimate& e) {
  return is_known ? interval(e) : Json(nullptr);
}

/// The same on both sides of the gear.
Json both_sides(const Estimate& motor, double motor_to_joint) {
  return {{"motor", interval(motor)}, {"joint", interval(scaled(motor, motor_to_joint))}};
}

Json robot(const Manifest& m) {
  return {{"name", text_or_null(m.robot)},
          {"serial", text_or_null(m.serial)},
          {"joint", text_or_null(m.joint)},
          {"operator", text_or_null(m.operator_name)},
          {"measured_on", text_or_null(m.measured_on)},
          {"note", text_or_null(m.note)},
          {"payload", text_or_null(m.payload)},
          {"payload_kg", number(m.payload_kg)},
          {"temperature_C", number(m.temperature_C)}};
}

Json drive(const Drive& d) {
  return {{"gear_ratio", number(d.gear_ratio())},
          {"effort_kind", to_string(d.kind())},
          {"effort_side", to_string(d.side())},
          {"torque_constant_Nm_A", number(d.torque_constant_Nm_A())},
          {"motor_torque_per_effort", number(d.motor_torque_per_effort())}};
}

Json inputs(const std::vector<InputFile>& files) {
  Json list = Json::array();
  for (const InputFile& file : files) {
    Json skipped = Json::array();
    for (const SkippedRows& rows : file.skipped) {
      skipped.push_back({{"reason", rows.reason}, {"rows", rows.count}});
    }
    list.push_back({{"name", file.name},
                    {"role", file.role},
                    {"bytes", file.bytes},
                    {"sha256", file.sha256},
                    {"rows_read", file.rows_read},
                    {"rows_used", file.rows_used},
                    {"skipped", std::move(skipped)}});
  }
  return list;
}

Json cog(const CogSweepResult& r, double gear_ratio) {
  const auto if_found = [&r](double value) { return r.found ? number(value) : Json(nullptr); };
  const Json joint = r.found ? interval(scaled(r.gravity_Nm, gear_ratio)) : Json(nullptr);
  return {{"found", r.found},
          {"method", text_or_null(r.method)},
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
          {"residual_Nm", if_found(r.residual_Nm)},
          {"lowest_rad", if_found(r.lowest_rad)},
          {"highest_rad", if_found(r.highest_rad)},
          {"both_directions", r.both_directions},
          {"constant_speed", r.constant_speed},
          {"samples_used", r.samples_used},
          {"samples_left_out", r.samples_left_out}};
}

Json loop_points(const std::vector<LoopPoint>& points) {
  if (points.empty()) return nullptr;
  Json named = Json::object();
  for (const char name : loop_point_names) named[std::string(1, name)] = nullptr;
  for (const LoopPoint& p : points) {
    named[std::string(1, p.name)] = {{"t_s", number(p.t_s)},
                                     {"q_rad", number(p.q_rad)},
                                     {"torque_Nm", number(p.torque_Nm)},
                                     {"torque_low_Nm", number(p.torque_low_Nm)},
                                     {"torque_high_Nm", number(p.torque_high_Nm)},
                                     {"z_rad", number(p.z_rad)},
                                     {"dz_dt_rad_s", number(p.dz_rad_s)}};
  }
  return named;
}

Json hysteresis(const HysteresisResult& h) {
  Json oscillations = Json::array();
  for (const Oscillation& o : h.oscillations) {
    oscillations.push_back({{"centre_rad", number(o.centre_rad)},
                            {"amplitude_rad", number(o.amplitude_rad)},
                            {"frequency_Hz", number(o.frequency_Hz)},
                            {"cycles", number(o.cycles)},
                            {"steady_cycles", number(o.steady_cycles)},
                            {"encoder_step_rad", number(o.encoder_step_rad)}});
  }
  return {{"found", h.found},
          {"bristle_source", text_or_null(h.bristle_source)},
          {"oscillations", std::move(oscillations)},
          {"points", loop_points(h.points)},
          {"steady_points", loop_points(h.steady_points)},
          {"midline_Nm", interval(h.midline_Nm)},
          {"midline_q_rad", h.midline_Nm ? number(h.midline_q_rad) : Json(nullptr)},
          {"loop_height_Nm", h.found ? number(h.loop_height_Nm) : Json(nullptr)},
          {"presliding_travel_rad", number(h.presliding_travel_rad)},
          {"encoder_step_rad", number(h.encoder_step_rad)}};
}

Json surrogate_masses(const SurrogateMassesResult& result) {
  Json list = Json::array();
  for (const SurrogateMass& m : result.masses) {
    list.push_back({{"estimator", m.estimator},
                    {"torque_Nm", interval(m.torque_Nm)},
                    {"q_rad", number(m.q_rad)},
                    {"mass_kg", interval(m.mass_kg)},
                    {"gravity_Nm", interval(m.gravity_Nm)}});
  }
  return list;
}

Json viscous(const ViscousCurvesResult& v) {
  Json runs = Json::array();
  for (const ConstantSpeedRun& r : v.runs) {
    runs.push_back({{"recording", r.recording},
                    {"speed_rad_s", number(r.speed_rad_s)},
                    {"torque_Nm", number(r.torque_Nm)},
                    {"torque_half_width_Nm", number(r.torque_half_width_Nm)},
                    {"q_rad", number(r.q_rad)},
                    {"mean_cos", number(r.mean_cos)},
                    {"samples", r.samples},
                    {"partner", r.partner < 0 ? Json(nullptr) : Json(r.partner)},
                    {"direction_difference_Nm", number(r.direction_difference_Nm)}});
  }
  Json curves = Json::object();
  for (const ViscousCurve& c : v.curves) curves[c.estimator] = numbers(c.friction_Nm);
  return {{"from_sweep", v.from_sweep},
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
  return {{"reference", text_or_null(q.reference)},
          {"reference_Nm", numbers(q.reference_Nm)},
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

Json waiboer(const WaiboerFit& w, double n) {
  const double coefficient_to_joint = std::pow(n, 2.0 - w.viscous_power.value);
  return {{"converged", w.converged},
          {"asperity_torque_Nm", both_sides(w.asperity_torque_Nm, n)},
          {"stribeck_speed_rad_s", both_sides(w.stribeck_speed_rad_s, 1.0 / n)},
          {"stribeck_power", interval(w.stribeck_power)},
          {"viscous_coefficient", both_sides(w.viscous_coefficient, coefficient_to_joint)},
          {"viscous_power", interval(w.viscous_power)},
          {"residual_Nm", number(w.residual_Nm)}};
}

Json coulomb_viscous(const CoulombViscousFit& f, double n) {
  return {{"coulomb_Nm", both_sides(f.coulomb_Nm, n)},
          {"viscous_Nms_rad", both_sides(f.viscous_Nms_rad, n * n)},
          {"residual_Nm", number(f.residual_Nm)},
          {"slowest_rad_s", number(f.slowest_rad_s)},
          {"fastest_rad_s", number(f.fastest_rad_s)}};
}

Json lugre(const LuGreFit& f, double n) {
  return {{"converged", f.converged},
          {"bristle_stiffness_Nm_rad", both_sides(f.bristle_stiffness_Nm_rad, n * n)},
          {"bristle_damping_Nms_rad", both_sides(f.bristle_damping_Nms_rad, n * n)},
          {"viscous_Nms_rad", both_sides(f.viscous_Nms_rad, n * n)},
          {"static_Nm", both_sides(f.static_Nm, n)},
          {"gravity_Nm", both_sides(f.gravity_Nm, n)},
          {"residual_Nm", number(f.residual_Nm)},
          {"iterations", f.iterations},
          {"reason", text_or_null(f.reason)}};
}

Json friction(const Calibration& c, double n) {
  const FrictionParametersResult& f = c.friction;
  Json made{{"curve", text_or_null(f.curve)},
            {"waiboer", nullptr},
            {"coulomb_viscous", nullptr},
            {"lugre", nullptr}};
  if (f.waiboer) made["waiboer"] = waiboer(*f.waiboer, n);
  if (f.coulomb_viscous) made["coulomb_viscous"] = coulomb_viscous(*f.coulomb_viscous, n);
  if (c.hysteresis.lugre) made["lugre"] = lugre(*c.hysteresis.lugre, n);
  return made;
}

Json provenance_json(const Provenance& p) {
  Json drawing = nullptr;
  if (p.drawing) {
    drawing = {{"vtk", p.drawing->vtk_version}, {"back_end", p.drawing->back_end},
               {"gl", p.drawing->gl_version},   {"renderer", p.drawing->gl_renderer},
               {"font", p.drawing->font},       {"freetype", p.drawing->freetype_version}};
  }
  Json configuration = Json::array();
  for (const NamedText& setting : p.configuration) {
    configuration.push_back({{"name", setting.name}, {"text", setting.text}});
  }
  return {{"tool", "tribolog"},
          {"version", p.tool_version},
          {"git_revision", p.git_revision},
          {"compiler", p.compiler},
          {"eigen", p.eigen_version},
          {"drawing", std::move(drawing)},
          {"created_utc", p.created_utc},
          {"command_line", p.command_line},
          {"configuration", std::move(configuration)}};
}

Json stage_list(const Calibration& c) {
  Json list = Json::array();
  for (const StageReport& s : c.stages()) {
    list.push_back(
        {{"name", s.name}, {"status", to_string(s.state)}, {"reason", text_or_null(s.reason)}});
  }
  return list;
}

const char* const units =
    "SI: rad, rad/s, N·m, kg, s. Joint angles q are on the arm's side. Torques, bristle "
    "deflections z and motor speeds are on the motor's side of the gear unless the key says joint.";

}  // namespace

std::string calibration_json(const Calibration& c, const Provenance& provenance) {
  const double n = c.manifest.drive.gear_ratio();
  Json all;
  all["schema"] = "tribolog-calibration-1";
  all["units"] = units;
  all["robot"] = robot(c.manifest);
  all["drive"] = drive(c.manifest.drive);
  all["verdict"] = {{"verdict", to_string(c.judgement.verdict)},
                    {"sentence", c.judgement.sentence},
                    {"findings", c.judgement.findings}};
  all["inputs"] = inputs(c.inputs);
  all["notes"] = c.notes;
  all["stages"] = stage_list(c);
  all["cog"] = {{"rough", cog(c.rough, n)},
                {"precise", cog(c.precise, n)},
                {"q_peak_rad", interval(c.q_peak_rad)},
                {"q_peak_source", text_or_null(c.q_peak_source)}};
  all["hysteresis"] = hysteresis(c.hysteresis);
  all["surrogate"] = {{"distance_m", number(c.manifest.surrogate_distance_m)},
                      {"gravity_m_s2", number(c.manifest.gravity_m_s2)}};
  all["surrogate_masses"] = surrogate_masses(c.masses);
  all["viscous"] = viscous(c.viscous);
  all["quality"] = quality(c.quality);
  all["selection"] = selection(c.selection);
  all["friction"] = friction(c, n);
  all["provenance"] = provenance_json(provenance);
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tribolog
