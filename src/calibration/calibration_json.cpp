#include "calibration/calibration_json.h"

#include <utility>

#include "base/shown_text.h"
#include "calibration/parts.h"
#include "joint/dataset.h"
#include "wording/language.h"
#include "wording/torques_in.h"
#include "wording/words.h"

namespace tribolog::calibration {

// What was measured, on which files, and by what program.

Json robot(const joint::Manifest& m) {
  return {{"name", text_or_null(m.robot)},
          {"serial", text_or_null(m.serial)},
          {"joint", text_or_null(m.joint)},
          {"operator", text_or_null(m.operator_name)},
          {"measured_on", text_or_null(m.measured_on)},
          {"note", text_or_null(m.note)},
          {"payload", text_or_null(m.payload)},
          {"payload_kg", number(m.payload_kg)},
          {"payload_distance_m", number(m.payload_distance_m)},
          {"temperature_C", number(m.temperature_C)}};
}

Json certificate(const joint::Certificate& c) {
  Json instruments = Json::array();
  for (const joint::Instrument& one : c.instruments) {
    instruments.push_back({{"name", one.name},
                           {"identification", text_or_null(one.identification)},
                           {"traceability", text_or_null(one.traceability)},
                           {"used_for", text_or_null(one.used_for)}});
  }
  return {{"number", text_or_null(c.number)},
          {"replaces", text_or_null(c.replaces)},
          {"laboratory", text_or_null(c.laboratory)},
          {"laboratory_address", text_or_null(c.laboratory_address)},
          {"country", text_or_null(c.country)},
          {"customer", text_or_null(c.customer)},
          {"customer_address", text_or_null(c.customer_address)},
          {"place", text_or_null(c.place)},
          {"received_on", text_or_null(c.received_on)},
          {"procedure", text_or_null(c.procedure)},
          {"conditions", text_or_null(c.conditions)},
          {"humidity_percent", number(c.humidity_percent)},
          {"adjustment", text_or_null(c.adjustment)},
          {"decision_rule", text_or_null(c.decision_rule)},
          {"responsible", text_or_null(c.responsible)},
          {"instruments", std::move(instruments)}};
}

Json drive(const joint::Manifest& m) {
  const joint::Drive& d = m.drive;
  return {{"gear_ratio", number(d.gear_ratio())},
          {"effort_kind", joint::to_string(d.kind())},
          {"effort_side", joint::to_string(d.side())},
          {"effort_confirmed", m.effort_is_confirmed},
          {"gravity_removed", m.gravity_is_removed},
          {"torque_constant_Nm_A",
           m.torque_is_in_amperes ? Json(nullptr) : number(d.torque_constant_Nm_A())},
          {"torque_is_in_amperes", m.torque_is_in_amperes},
          {"motor_torque_per_effort", number(d.motor_torque_per_effort())}};
}

Json stated_uncertainty(const joint::StatedUncertainty& u) {
  return {{"torque_constant_percent", number(u.torque_constant_percent)},
          {"gear_ratio_percent", number(u.gear_ratio_percent)},
          {"surrogate_distance_percent", number(u.surrogate_distance_percent)},
          {"gravity_percent", number(u.gravity_percent)},
          {"angle_zero_deg", number(u.angle_zero_deg)},
          {"hoses_percent", number(u.hoses_percent)},
          {"description_percent", number(u.description_percent)},
          {"id", u.id.empty() ? Json::object() : Json(u.id)}};
}

Json stated_effects(const joint::EffectSizes& sizes) {
  Json all = Json::object();
  for (const joint::Effect& effect : joint::statable_effects()) {
    if (sizes.is_stated(effect)) all[effect.stated_key()] = number(sizes.of(effect));
  }
  return all;
}

Json inputs(const std::vector<joint::InputFile>& files) {
  Json list = Json::array();
  for (const joint::InputFile& file : files) {
    Json skipped = Json::array();
    for (const joint::SkippedRows& rows : file.skipped) {
      skipped.push_back({{"reason", wording::words(rows.reason)}, {"rows", rows.count}});
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

Json provenance_json(const Provenance& p) {
  Json drawing = nullptr;
  if (p.drawing) {
    drawing = {{"vtk", p.drawing->vtk_version}, {"back_end", p.drawing->back_end},
               {"gl", p.drawing->gl_version},   {"renderer", p.drawing->gl_renderer},
               {"font", p.drawing->font},       {"freetype", p.drawing->freetype_version}};
  }
  Json configuration = Json::array();
  for (const Setting& setting : p.configuration) {
    configuration.push_back(
        {{"name", wording::words(setting.name)}, {"text", wording::words(setting.text)}});
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

// From the columns of the logs to signals, and where speeds come from.

Json conversions(const std::vector<joint::InputFile>& inputs) {
  Json list = Json::array();
  for (const joint::SharedConversion& shared : joint::shared_conversions(inputs)) {
    const joint::ColumnConversion& c = shared.conversion;
    Json steps = Json::array();
    for (const joint::ConversionStep& step : c.steps) {
      steps.push_back({{"reason", joint::to_string(step.reason)},
                       {"number", number(step.number)},
                       {"divides", step.divides}});
    }
    list.push_back({{"signal", joint::to_string(c.signal)},
                    {"column", c.column},
                    {"unit", c.unit},
                    {"unit_confirmed", !c.is_proposed},
                    {"steps", std::move(steps)},
                    {"factor", number(c.factor())},
                    {"si_unit", wording::shown_units(c.si_unit)},
                    {"side", c.side ? Json(joint::to_string(*c.side)) : Json(nullptr)},
                    {"files", shared.files}});
  }
  return list;
}

Json speeds(const std::vector<method::motion::SpeedSource>& sources) {
  Json list = Json::array();
  for (const method::motion::SpeedSource& s : sources) {
    list.push_back({{"recording", s.recording},
                    {"role", joint::to_string(s.role)},
                    {"is_logged", s.is_logged},
                    {"window_samples", s.window},
                    {"window_s", number(s.window_s)},
                    {"cut_off_Hz", number(s.cut_off_Hz)}});
  }
  return list;
}

// The whole.

namespace {

Json stage_list(const Calibration& c) {
  Json list = Json::array();
  for (const statistics::StageReport& s : c.stages()) {
    list.push_back({{"name", s.name},
                    {"status", statistics::to_string(s.state)},
                    {"reason", words_or_null(s.reason)},
                    {"reason_code", code_of(s.reason)}});
  }
  return list;
}

const char* const units =
    "SI: rad, rad/s, N·m, kg, s. Joint angles q are on the arm's side. Torques, bristle "
    "deflections z and motor speeds are on the motor's side of the gear unless the key says joint.";

}  // namespace

std::string calibration_json(const Calibration& c, const Provenance& provenance) {
  const wording::WordsIn english({});
  const wording::TorquesIn unit(c.manifest.torque_unit());
  const double n = c.manifest.drive.gear_ratio();
  Json all;
  all["schema"] = "tribolog-calibration-1";
  all["units"] = wording::shown_units(units);
  all["robot"] = robot(c.manifest);
  all["certificate"] = certificate(c.manifest.certificate);
  all["drive"] = drive(c.manifest);
  all["verdict"] = verdict(c.judgement);
  all["friction_at_speed"] = friction_at_speed(c.judgement);
  all["model"] = model(c.model);
  all["data_checks"] = data_checks(c.data_checks);
  all["inputs"] = inputs(c.inputs);
  all["conversions"] = conversions(c.inputs);
  all["speeds"] = speeds(c.speed_sources);
  all["notes"] = wording::words(c.notes);
  all["stages"] = stage_list(c);
  all["cog"] = {
      {"rough", cog(c.rough, n)},
      {"precise", cog(c.precise, n)},
      {"q_peak_rad", interval(c.q_peak_rad)},
      {"q_peak_source", c.q_peak_source ? Json(to_string(*c.q_peak_source)) : Json(nullptr)}};
  all["hysteresis"] = hysteresis(c.hysteresis, c.curves);
  all["surrogate"] = {{"distance_m", number(c.manifest.surrogate_distance_m)},
                      {"gravity_m_s2", number(c.manifest.gravity_m_s2)}};
  all["uncertainty"] = stated_uncertainty(c.manifest.uncertainty);
  all["stated_effects"] = stated_effects(c.manifest.effects);
  all["surrogate_masses"] = surrogate_masses(c.masses);
  all["viscous"] = viscous(c.viscous);
  all["quality"] = quality(c.quality);
  all["selection"] = selection(c.selection);
  all["friction"] = friction(c, n);
  all["known_loads"] = known_loads(c.manifest.known_loads);
  all["known_gravity"] = known_gravity(c.manifest.known_gravity);
  all["other_joints"] = other_joints(c.manifest.other_joints);
  all["arm_gravity"] = arm_gravity(c.manifest.arm_gravity);
  all["loop_shapes"] = loop_shapes(c.loop_shapes);
  all["break_away"] = break_away(c.break_away, n);
  all["cross_checks"] = cross_checks(c.cross_checks);
  all["ripple"] = ripple(c.rough.ripple);
  all["friction_of_angle"] = ripple(c.rough.friction_of_angle);
  all["position_plan"] = position_plan(c.position_plan);
  all["truth_check"] = truth_check(c.truth_check);
  all["provenance"] = provenance_json(provenance);
  return json_without_hidden(all.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace tribolog::calibration
