// Who, with what, from what: identity of the joint, inputs and software.

#include "base/error.h"
#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {
namespace {

using wording::tr;
using wording::tr_count;

std::string skipped_in_words(const std::vector<joint::SkippedRows>& skipped) {
  std::string words;
  for (const joint::SkippedRows& rows : skipped) {
    if (!words.empty()) words += "; ";
    words += wording::count(rows.count) + ": " + wording::words(rows.reason);
  }
  return words.empty() ? tr("none") : words;
}

Table inputs_table(const std::vector<joint::InputFile>& inputs) {
  Table table;
  table.id = "table-inputs";
  table.caption = tr("Input files");
  table.columns = {{tr("File"), "", false},         {tr("Role"), "", false},
                   {tr("Size"), tr("bytes"), true}, {tr("Rows read"), "", true},
                   {tr("Rows used"), "", true},     {tr("Rows skipped, and why"), "", false},
                   {"SHA-256", "", false}};
  for (const joint::InputFile& file : inputs) {
    const bool has_rows = file.rows_read > 0 || file.rows_used > 0 || !file.skipped.empty();
    // No directory of the machine.
    const bool is_absolute = file.name.starts_with('/');
    table.rows.push_back(
        {{wording::or_dash(is_absolute ? elements::log_name(file.name) : file.name),
          wording::or_dash(file.role), wording::count(static_cast<std::size_t>(file.bytes)),
          has_rows ? wording::count(file.rows_read) : "–",
          has_rows ? wording::count(file.rows_used) : "–",
          has_rows ? skipped_in_words(file.skipped) : "–", wording::or_dash(file.sha256)},
         false});
  }
  return table;
}

Table two_columns(const std::string& id, const std::string& caption, const std::string& first) {
  Table table;
  table.id = id;
  table.caption = caption;
  table.columns = {{first, "", false}, {tr("Value"), "", false}};
  return table;
}

void add(Table& table, const std::string& name, const std::string& text) {
  table.rows.push_back({{name, wording::or_dash(text)}, false});
}

std::string effort_in_words(const joint::Drive& drive) {
  if (drive.kind() == joint::EffortKind::none) return tr("not recorded");
  const std::string kind = to_string(drive.kind());
  return drive.side() == joint::Side::motor ? wording::words_for("effort_at_motor", kind)
                                            : wording::words_for("effort_at_joint", kind);
}

std::string effort_in_words(const joint::Manifest& m) {
  const std::string effort = m.torque_is_in_amperes
                                 ? tr("motor current in A, torque constant not stated")
                                 : effort_in_words(m.drive);
  return m.effort_is_confirmed ? effort
                               : tr("{effort}: proposed, not confirmed", {{"effort", effort}});
}

/// "1.825 N·m cos(q1_rad + q2_rad − 90°) at the joint, from 42 900 samples, up to 1.825 N·m"
std::string load_in_words(const joint::KnownLoad& load) {
  constexpr int digits = 4;
  const std::string words = tr_count(
      load.samples, "{load} at the joint, from {samples} sample, up to {torque}",
      "{load} at the joint, from {samples} samples, up to {torque}",
      {{"load", load_formula(load)},
       {"samples", wording::count(load.samples)},
       {"torque", wording::with_unit(wording::significant(load.largest_Nm, digits), "N·m")}});
  return load.note.empty() ? words : words + "; " + load.note;
}

std::string angle_of_joint(double angle_rad) {
  constexpr int decimals = 1;
  return wording::with_unit(wording::fixed(angle_rad * wording::degree_scale().factor, decimals),
                            "°");
}

/// "J2: from −10.0° to 20.0° in these recordings"
std::string motion_in_words(const joint::OtherJoint& other) {
  return tr("{joint}: from {lowest} to {highest} in these recordings",
            {{"joint", printable(other.name)},
             {"lowest", angle_of_joint(other.lowest_rad)},
             {"highest", angle_of_joint(other.highest_rad)}});
}

/// What the description says of the tested joint where the others are held, to compare.
std::string masses_in_words(const joint::ArmGravity& arm) {
  constexpr int digits = 4;
  std::string held;
  for (const joint::HeldJoint& one : arm.held) {
    held +=
        (held.empty() ? "" : ", ") + printable(one.name) + " " + angle_of_joint(one.position_rad);
  }
  const std::string file =
      tr("{file}, taken to be right within {share}",
         {{"file", printable(arm.description)},
          {"share", wording::with_unit(wording::as_stated(arm.description_percent), "%")}});
  if (!arm.own) return file;
  return file + "; " +
         tr("gravity of {joint} by it is {torque} at the joint, largest at {angle}, with {held}",
            {{"joint", printable(arm.tested)},
             {"torque",
              wording::with_unit(wording::significant(arm.own->amplitude_Nm(), digits), "N·m")},
             {"angle", angle_of_joint(arm.own->q_peak_rad())},
             {"held", held.empty() ? "–" : held}});
}

Table manifest_table(const joint::Manifest& m) {
  Table table = two_columns("table-manifest", tr("What the manifest states"), tr("Fact"));
  add(table, tr("Gear ratio n"), wording::as_stated(m.drive.gear_ratio()));
  add(table, tr("Effort column"), effort_in_words(m));
  if (m.torque_is_in_amperes) {
    add(table, tr("Torque constant"), tr("not stated"));
  } else if (const auto constant = m.drive.torque_constant_Nm_A()) {
    add(table, tr("Torque constant"), wording::with_unit(wording::as_stated(*constant), "N·m/A"));
  }
  if (m.drive.kind() != joint::EffortKind::none) {
    add(table, tr("Motor torque per unit of effort"),
        wording::with_unit(
            wording::as_stated(m.drive.motor_torque_per_effort()),
            m.drive.kind() == joint::EffortKind::motor_current && !m.torque_is_in_amperes ? "N·m/A"
                                                                                          : ""));
  }
  add(table, tr("Payload"), payload_in_words(m));
  add(table, tr("Temperature"),
      m.temperature_C ? wording::with_unit(wording::as_stated(*m.temperature_C), "°C")
                      : tr("not stated"));
  add(table, tr("Surrogate distance r"),
      wording::with_unit(wording::as_stated(m.surrogate_distance_m), "m"));
  add(table, tr("Gravity g"), wording::with_unit(wording::as_stated(m.gravity_m_s2), "m/s²"));
  for (const joint::KnownLoad& load : m.known_loads) {
    add(table, tr("Known load, subtracted"), load_in_words(load));
  }
  for (const joint::OtherJoint& other : m.other_joints) {
    if (other.samples > 0) add(table, tr("Another joint"), motion_in_words(other));
  }
  if (m.arm_gravity) add(table, tr("Masses of the arm"), masses_in_words(*m.arm_gravity));
  if (m.known_gravity) {
    add(table, tr("Known gravity"),
        tr("{gravity_torque} at the joint, largest at {angle}",
           {{"gravity_torque",
             wording::with_unit(wording::as_stated(m.known_gravity->amplitude_Nm()), "N·m")},
            {"angle", wording::with_unit(wording::as_stated(m.known_gravity->q_peak_rad() *
                                                            wording::degree_scale().factor),
                                         "°")}}));
  }
  add(table, tr("Known friction curve"),
      m.reference ? tr("yes, from the model {friction_model}: the data are simulated",
                       {{"friction_model", m.reference->name()}})
                  : tr("none"));
  return table;
}

Table software_table(const calibration::Provenance& p) {
  Table table = two_columns("table-software", tr("Software"), tr("Part"));
  add(table, "tribolog", p.tool_version);
  add(table, tr("Revision"), p.git_revision);
  add(table, tr("Compiler"), p.compiler);
  add(table, "Eigen", p.eigen_version);
  if (p.drawing) {
    add(table, "VTK", p.drawing->vtk_version);
    add(table, tr("Off-screen back end"), p.drawing->back_end);
    add(table, "OpenGL", p.drawing->gl_version);
    add(table, tr("Renderer"), p.drawing->gl_renderer);
    add(table, tr("Font"), p.drawing->font);
    add(table, "FreeType", p.drawing->freetype_version);
  } else {
    add(table, "VTK", tr("not used: no figure was drawn"));
  }
  return table;
}

}  // namespace

std::string payload_in_words(const joint::Manifest& m) {
  if (!m.payload_kg) return m.payload;
  std::string words = wording::with_unit(wording::as_stated(*m.payload_kg), "kg");
  if (m.payload_distance_m) {
    words = tr("{mass} at {distance} from the axis",
               {{"mass", words},
                {"distance", wording::with_unit(wording::as_stated(*m.payload_distance_m), "m")}});
  }
  return words + (m.payload.empty() ? "" : ", " + m.payload);
}

std::vector<Table> provenance_tables(const calibration::Calibration& c,
                                     const calibration::Provenance& p) {
  std::vector<Table> tables{inputs_table(c.inputs), manifest_table(c.manifest)};
  if (!p.configuration.empty()) {
    tables.push_back(two_columns("table-configuration", tr("Configuration"), tr("Setting")));
    for (const calibration::Setting& setting : p.configuration) {
      add(tables.back(), wording::or_dash(wording::words(setting.name)),
          wording::words(setting.text));
    }
  }
  tables.push_back(software_table(p));
  return tables;
}

}  // namespace tribolog::report::document
