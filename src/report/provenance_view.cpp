// Who, with what, from what: identity of the joint, inputs and software.

#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

std::string skipped_in_words(const std::vector<joint::SkippedRows>& skipped) {
  std::string words;
  for (const joint::SkippedRows& rows : skipped) {
    if (!words.empty()) words += "; ";
    words += wording::count(rows.count) + ": " + rows.reason;
  }
  return words.empty() ? "none" : words;
}

Table inputs_table(const std::vector<joint::InputFile>& inputs) {
  Table table;
  table.id = "table-inputs";
  table.caption = "Input files";
  table.columns = {{"File", "", false},     {"Role", "", false},
                   {"Size", "bytes", true}, {"Rows read", "", true},
                   {"Rows used", "", true}, {"Rows skipped, and why", "", false},
                   {"SHA-256", "", false}};
  for (const joint::InputFile& file : inputs) {
    const bool has_rows = file.rows_read > 0 || file.rows_used > 0 || !file.skipped.empty();
    table.rows.push_back({{or_dash(file.name), or_dash(file.role),
                           wording::count(static_cast<std::size_t>(file.bytes)),
                           has_rows ? wording::count(file.rows_read) : "–",
                           has_rows ? wording::count(file.rows_used) : "–",
                           has_rows ? skipped_in_words(file.skipped) : "–", or_dash(file.sha256)},
                          false});
  }
  return table;
}

Table two_columns(const std::string& id, const std::string& caption, const std::string& first) {
  Table table;
  table.id = id;
  table.caption = caption;
  table.columns = {{first, "", false}, {"Value", "", false}};
  return table;
}

void add(Table& table, const std::string& name, const std::string& text) {
  table.rows.push_back({{name, or_dash(text)}, false});
}

std::string effort_in_words(const joint::Drive& drive) {
  const std::string side = drive.side() == joint::Side::motor ? "motor side" : "joint side";
  switch (drive.kind()) {
    case joint::EffortKind::motor_current:
      return "motor current in A, torque constant stated for the " + side;
    case joint::EffortKind::motor_torque:
      return "torque made by the motor, " + side;
    case joint::EffortKind::joint_torque:
      return "torque at the joint, " + side;
    case joint::EffortKind::target_torque:
      return "target torque of a controller or its model, no measurement, " + side;
    case joint::EffortKind::none:
      return "not recorded";
  }
  return "–";
}

/// "1.825 N·m cos(q1_rad + q2_rad − 90°) at the joint, from 42 900 samples, up to 1.825 N·m"
std::string load_in_words(const joint::KnownLoad& load) {
  constexpr int digits = 4;
  return load_formula(load) + " at the joint, from " + wording::count(load.samples) +
         " samples, up to " +
         wording::with_unit(wording::significant(load.largest_Nm, digits), "N·m") +
         (load.note.empty() ? "" : "; " + load.note);
}

std::string payload_in_words(const joint::Manifest& m) {
  if (!m.payload_kg) return m.payload;
  std::string words = wording::with_unit(wording::as_stated(*m.payload_kg), "kg");
  if (m.payload_distance_m) {
    words += " at " + wording::with_unit(wording::as_stated(*m.payload_distance_m), "m") +
             " from the axis";
  }
  return words + (m.payload.empty() ? "" : ", " + m.payload);
}

Table manifest_table(const joint::Manifest& m) {
  Table table = two_columns("table-manifest", "What the manifest states", "Fact");
  add(table, "Gear ratio n", wording::as_stated(m.drive.gear_ratio()));
  add(table, "Effort column",
      effort_in_words(m.drive) + (m.effort_is_confirmed ? "" : ": proposed, nobody confirmed it"));
  if (const auto constant = m.drive.torque_constant_Nm_A()) {
    add(table, "Torque constant", wording::with_unit(wording::as_stated(*constant), "N·m/A"));
  }
  if (m.drive.kind() != joint::EffortKind::none) {
    add(table, "Motor torque per unit of effort",
        wording::with_unit(wording::as_stated(m.drive.motor_torque_per_effort()),
                           m.drive.kind() == joint::EffortKind::motor_current ? "N·m/A" : ""));
  }
  add(table, "Payload", payload_in_words(m));
  add(table, "Temperature",
      m.temperature_C ? wording::with_unit(wording::as_stated(*m.temperature_C), "°C")
                      : "not stated");
  add(table, "Surrogate distance r",
      wording::with_unit(wording::as_stated(m.surrogate_distance_m), "m"));
  add(table, "Gravity g", wording::with_unit(wording::as_stated(m.gravity_m_s2), "m/s²"));
  for (const joint::KnownLoad& load : m.known_loads) {
    add(table, "Known load, subtracted", load_in_words(load));
  }
  if (m.known_gravity) {
    add(table, "Known gravity",
        wording::with_unit(wording::as_stated(m.known_gravity->amplitude_Nm()), "N·m") +
            " at the joint, largest at " +
            wording::with_unit(
                wording::as_stated(m.known_gravity->q_peak_rad() * wording::degree_scale().factor),
                "°"));
  }
  add(table, "Known friction curve",
      m.reference ? "yes, of the model " + m.reference->name() + ": the data are simulated"
                  : "none");
  return table;
}

Table software_table(const calibration::Provenance& p) {
  Table table = two_columns("table-software", "Software", "Part");
  add(table, "tribolog", p.tool_version);
  add(table, "Revision", p.git_revision);
  add(table, "Compiler", p.compiler);
  add(table, "Eigen", p.eigen_version);
  if (p.drawing) {
    add(table, "VTK", p.drawing->vtk_version);
    add(table, "Off-screen back end", p.drawing->back_end);
    add(table, "OpenGL", p.drawing->gl_version);
    add(table, "Renderer", p.drawing->gl_renderer);
    add(table, "Font", p.drawing->font);
    add(table, "FreeType", p.drawing->freetype_version);
  } else {
    add(table, "VTK", "not used: no figure was drawn");
  }
  return table;
}

}  // namespace

std::vector<Fact> identity_facts(const joint::Manifest& m) {
  const bool is_direct = m.drive.gear_ratio() == 1.0;
  std::vector<Fact> facts{
      {"Robot", or_dash(m.robot)},
      {"Joint", or_dash(m.joint)},
      {"Serial number", or_dash(m.serial)},
      {"Measured on", or_dash(m.measured_on)},
      {"Operator", or_dash(m.operator_name)},
      {"Gear ratio", is_direct ? "1 (direct drive)" : wording::as_stated(m.drive.gear_ratio())}};
  if (m.reference) facts.push_back({"Data", "simulated, the true curve is known"});
  return facts;
}

std::vector<Table> provenance_tables(const calibration::Calibration& c,
                                     const calibration::Provenance& p) {
  std::vector<Table> tables{inputs_table(c.inputs), manifest_table(c.manifest)};
  if (!p.configuration.empty()) {
    tables.push_back(two_columns("table-configuration", "Configuration", "Setting"));
    for (const calibration::NamedText& setting : p.configuration) {
      add(tables.back(), or_dash(setting.name), setting.text);
    }
  }
  tables.push_back(software_table(p));
  return tables;
}

}  // namespace tribolog::report
