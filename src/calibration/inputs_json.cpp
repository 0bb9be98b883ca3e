// What was measured, on which files, and by what program.

#include <utility>

#include "calibration/parts.h"
#include "joint/dataset.h"
#include "wording/words.h"

namespace tribolog::calibration {

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

Json drive(const joint::Manifest& m) {
  const joint::Drive& d = m.drive;
  return {{"gear_ratio", number(d.gear_ratio())},
          {"effort_kind", joint::to_string(d.kind())},
          {"effort_side", joint::to_string(d.side())},
          {"effort_confirmed", m.effort_is_confirmed},
          {"torque_constant_Nm_A", number(d.torque_constant_Nm_A())},
          {"motor_torque_per_effort", number(d.motor_torque_per_effort())}};
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
                    {"steps", std::move(steps)},
                    {"factor", number(c.factor())},
                    {"si_unit", c.si_unit},
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

}  // namespace tribolog::calibration
