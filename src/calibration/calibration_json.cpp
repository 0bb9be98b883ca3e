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

namespace {

void state_robot(Fields& f, const joint::Manifest& m) {
  f.text_or_null("name", m.robot);
  f.text_or_null("serial", m.serial);
  f.text_or_null("joint", m.joint);
  f.text_or_null("operator", m.operator_name);
  f.text_or_null("measured_on", m.measured_on);
  f.text_or_null("note", m.note);
  f.text_or_null("payload", m.payload);
  f.number("payload_kg", m.payload_kg);
  f.number("payload_distance_m", m.payload_distance_m,
           "Of its centre of gravity from the joint's axis [m].");
  f.number("temperature_C", m.temperature_C);
}

void state_certificate(Fields& f, const joint::Certificate& c) {
  f.text_or_null("number", c.number, "The laboratory's own.");
  f.text_or_null("replaces", c.replaces, "Number of the certificate that this one replaces.");
  f.text_or_null("laboratory", c.laboratory);
  f.text_or_null("laboratory_address", c.laboratory_address);
  f.put("country", text_or_null(c.country),
        R"({"type": ["string", "null"], "pattern": "^[A-Z]{2}$"})",
        "Of the laboratory, ISO 3166-1 alpha-2.");
  f.text_or_null("customer", c.customer);
  f.text_or_null("customer_address", c.customer_address);
  f.text_or_null("place", c.place, "Where it was measured.");
  f.text_or_null("received_on", c.received_on);
  f.text_or_null("procedure", c.procedure, "The laboratory's own, beside the method's.");
  f.text_or_null("conditions", c.conditions);
  f.put("humidity_percent", number(c.humidity_percent),
        R"({"type": ["number", "null"], "minimum": 0, "maximum": 100})");
  f.text_or_null("adjustment", c.adjustment);
  f.text_or_null("decision_rule", c.decision_rule);
  f.text_or_null("responsible", c.responsible, "Who authorises the certificate.");
  f.list("instruments", c.instruments, "", [](Fields& one, const joint::Instrument& instrument) {
    one.text("name", instrument.name);
    one.text_or_null("identification", instrument.identification);
    one.text_or_null("traceability", instrument.traceability,
                     "Number of its certificate, or a statement.");
    one.text_or_null("used_for", instrument.used_for);
  });
}

void state_drive(Fields& f, const joint::Manifest& m) {
  const joint::Drive& d = m.drive;
  f.put("gear_ratio", number(d.gear_ratio()), R"({"type": "number", "exclusiveMinimum": 0})",
        "n = motor angle / joint angle.");
  f.choice("effort_kind", d.kind(), "target_torque: of a controller or its model, no measurement.");
  f.choice("effort_side", d.side());
  f.flag("effort_confirmed", m.effort_is_confirmed,
         "false: kind and side were proposed, and nobody confirmed them.");
  f.flag("gravity_removed", m.gravity_is_removed,
         "true: the controller had taken gravity off the effort.");
  f.number("torque_constant_Nm_A", m.torque_is_in_amperes ? std::nullopt : d.torque_constant_Nm_A(),
           "On the effort's side; only for motor_current.");
  f.flag("torque_is_in_amperes", m.torque_is_in_amperes,
         "true: the torque constant is not known. Every torque is a number of amperes; units say "
         "so, and keys that end in Nm or kgm2 do not.");
  f.number("motor_torque_per_effort", d.motor_torque_per_effort(),
           "Factor from the effort column to torque at the motor [N·m].");
}

void state_uncertainty(Fields& f, const joint::StatedUncertainty& u) {
  f.newer().number("torque_constant_percent", u.torque_constant_percent);
  f.newer().number("gear_ratio_percent", u.gear_ratio_percent);
  f.newer().number("surrogate_distance_percent", u.surrogate_distance_percent);
  f.newer().number("gravity_percent", u.gravity_percent);
  f.newer().number("angle_zero_deg", u.angle_zero_deg);
  f.newer().number(
      "hoses_percent", u.hoses_percent,
      "Torque of hoses and cables: its change over one radian, of the gravity torque.");
  f.newer().number("description_percent", u.description_percent,
                   "Of the masses in a description of the arm.");
  f.newer().put(
      "id", u.id.empty() ? Json::object() : Json(u.id),
      R"({"type": "object", "additionalProperties": {"type": "string"}})",
      "What an error comes from, by the keys above without their unit, as far as it is stated.");
}

Json stated_effects(const joint::EffectSizes& sizes) {
  Json all = Json::object();
  for (const joint::Effect& effect : joint::statable_effects()) {
    if (sizes.is_stated(effect)) all[effect.stated_key()] = number(sizes.of(effect));
  }
  return all;
}

void state_input(Fields& f, const joint::InputFile& file) {
  f.text("name", file.name);
  f.text("role", file.role);
  f.count("bytes", file.bytes);
  f.put("sha256", file.sha256, R"({"type": "string", "pattern": "^[0-9a-f]{64}$"})");
  f.count("rows_read", file.rows_read);
  f.count("rows_used", file.rows_used);
  f.list(
      "skipped", file.skipped, "Why rows were skipped.",
      [](Fields& one, const joint::SkippedRows& rows) {
        one.text("reason", wording::words(rows.reason));
        one.count("rows", rows.count);
      },
      "Rows that are not among the samples.");
}

void state_provenance(Fields& f, const Provenance& p) {
  f.put("tool", "tribolog", R"({"const": "tribolog"})");
  f.text("version", p.tool_version);
  f.text("git_revision", p.git_revision);
  f.text("compiler", p.compiler);
  f.text("eigen", p.eigen_version);
  f.object_or_null("drawing", p.drawing, "The graphics stack. Null where no figure was drawn.",
                   [](Fields& of, const auto& drawing) {
                     of.text("vtk", drawing.vtk_version);
                     of.text("back_end", drawing.back_end);
                     of.text("gl", drawing.gl_version);
                     of.text("renderer", drawing.gl_renderer);
                     of.text("font", drawing.font);
                     of.text("freetype", drawing.freetype_version);
                   });
  f.put(
      "created_utc", p.created_utc,
      R"({"type": "string", "pattern": "^[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z$"})");
  f.text("command_line", p.command_line);
  f.list(
      "configuration", p.configuration, "Settings in force.",
      [](Fields& one, const Setting& setting) {
        one.text("name", wording::words(setting.name));
        one.text("text", wording::words(setting.text));
      },
      "A setting.");
}

// From the columns of the logs to signals, and where speeds come from.

void state_conversion(Fields& f, const joint::SharedConversion& shared) {
  const joint::ColumnConversion& c = shared.conversion;
  f.choice("signal", c.signal);
  f.text("column", c.column);
  f.text("unit", c.unit, "In the log.");
  f.flag("unit_confirmed", !c.is_proposed,
         "false: the unit was proposed from the log, and nobody confirmed it.");
  f.list(
      "steps", c.steps, "In their order.",
      [](Fields& one, const joint::ConversionStep& step) {
        one.choice("reason", step.reason);
        one.known_number("number", step.number);
        one.flag("divides", step.divides, "Divided by the number, not multiplied.");
      },
      "One factor; those of 1 are left out.");
  f.known_number("factor", c.factor(), "Product of the steps.");
  f.text("si_unit", wording::shown_units(c.si_unit));
  f.choice("side", c.side, "To which the signal is referred.");
  f.texts("files", shared.files, "Logs, as the manifest names them.");
}

void state_speed(Fields& f, const method::motion::SpeedSource& s) {
  f.text("recording", s.recording);
  f.text("role", std::string(to_string(s.role)));
  f.flag("is_logged", s.is_logged, "A speed is logged too; it is used for the checks alone.");
  f.count("window_samples", s.window);
  f.known_number("window_s", s.window_s, "Duration of the window [s].");
  f.known_number("cut_off_Hz", s.cut_off_Hz, "-3 dB of the derivative [Hz].");
}

void state_stage(Fields& f, const statistics::StageReport& s) {
  f.put("name", s.name, R"({"type": "string", "minLength": 1})");
  f.choice("status", s.state);
  f.words_or_null("reason", s.reason, "Null only if done.");
}

// The whole.

const char* const units =
    "SI: rad, rad/s, N·m, kg, s. Joint angles q are on the arm's side. Torques, bristle "
    "deflections z and motor speeds are on the motor's side of the gear unless the key says joint.";

void state_whole(Fields& f, const Calibration& c, const Provenance& provenance) {
  const double n = c.manifest.drive.gear_ratio();
  f.put("schema", "tribolog-calibration-1", R"({"const": "tribolog-calibration-1"})");
  f.text("units", wording::shown_units(units), "Units and sides in words.");
  f.object("robot", "What the manifest states; null where not stated.",
           [&](Fields& of) { state_robot(of, c.manifest); });
  f.newer().object("certificate",
                   "What the manifest states for a calibration certificate; null where not stated. "
                   "Nothing is computed from it.",
                   [&](Fields& of) { state_certificate(of, c.manifest.certificate); });
  f.object("drive", "Gear and effort sensing.", [&](Fields& of) { state_drive(of, c.manifest); });
  f.object("verdict", "What the result is worth.",
           [&](Fields& of) { state_verdict(of, c.judgement); });
  state_friction_at_speed(f, c.judgement);
  f.object("model", "One model of all sweeps, runs and friction points.",
           [&](Fields& of) { state_model(of, c.model); });
  state_data_checks(f, c.data_checks);
  f.list("inputs", c.inputs, "The manifest first.", state_input, "A file as it was read.");
  f.list(
      "conversions", joint::shared_conversions(c.inputs),
      "How columns of logs became signals: each conversion once, with the logs it was applied to.",
      state_conversion, "Signal = factor times the number in the log.");
  f.list("speeds", c.speed_sources,
         "Where speeds come from: the derivative of the angle, whether a speed is logged or not.",
         state_speed, "Difference of the means over half a window behind and before each sample.");
  f.texts("notes", wording::words(c.notes), "What the reader noticed.");
  f.list("stages", c.stages(), "In the order of the method.", state_stage, "How far a stage came.");
  f.object("cog", "Stages 1 and 2.", [&](Fields& of) {
    constexpr const char* meaning =
        "Angle of the centre of gravity from a slow sweep. With found = false the values are null.";
    of.object("rough", meaning, [&](Fields& sweep) { state_cog(sweep, c.rough, n); });
    of.object("precise", meaning, [&](Fields& sweep) { state_cog(sweep, c.precise, n); });
    of.interval(
        "q_peak_rad", c.q_peak_rad,
        "Of the sweeps the one with the narrower interval; without a sweep that of the runs.");
    of.choice("q_peak_source", c.q_peak_source);
  });
  f.object("hysteresis", "Stage 3.",
           [&](Fields& of) { state_hysteresis(of, c.hysteresis, c.curves); });
  f.object("surrogate", "What the surrogate masses are for.", [&](Fields& of) {
    of.known_number("distance_m", c.manifest.surrogate_distance_m, "r_REPL, freely chosen.");
    of.known_number("gravity_m_s2", c.manifest.gravity_m_s2);
  });
  f.newer().object("uncertainty",
                   "What the manifest states of errors that no recording shows: half widths at 95 "
                   "%; null: not stated.",
                   [&](Fields& of) { state_uncertainty(of, c.manifest.uncertainty); });
  f.put("stated_effects", stated_effects(c.manifest.effects),
        R"({"type": "object", "additionalProperties": {"type": "number", "minimum": 0}})",
        "Sizes of effects on the torque that the manifest states, [effects], by their keys; what "
        "is not there is as typical.");
  state_surrogate_masses(f, c.masses);
  f.object("viscous", "Stage 5.", [&](Fields& of) { state_viscous(of, c.viscous); });
  f.object("quality", "Stage 6: 100 (Tf,candidate - Tf,reference) / T.",
           [&](Fields& of) { state_quality(of, c.quality); });
  f.object("selection", "Stage 7.", [&](Fields& of) { state_selection(of, c.selection); });
  f.object("friction",
           "Stage 8. Joint side: torques times n, speeds divided by n, viscous coefficients and "
           "stiffnesses times n^2.",
           [&](Fields& of) { state_friction(of, c, n); });
  state_known_loads(f, c.manifest.known_loads);
  state_known_gravity(f, c.manifest.known_gravity);
  state_other_joints(f, c.manifest.other_joints);
  state_arm_gravity(f, c.manifest.arm_gravity);
  state_loop_shapes(f, c.loop_shapes);
  f.object("break_away", "Break-away ramps.",
           [&](Fields& of) { state_break_away(of, c.break_away, n); });
  f.object("cross_checks",
           "Gravity torque and mass by every estimator, against the recommended one.",
           [&](Fields& of) { state_cross_checks(of, c.cross_checks); });
  f.object("ripple", "Torque ripple that the rough sweep shows, motor side.",
           [&](Fields& of) { state_ripple(of, c.rough.ripple); });
  f.object("friction_of_angle",
           "Friction that changes with the angle, as the rough sweep shows it: of a rising joint "
           "angle, motor side.",
           [&](Fields& of) { state_ripple(of, c.rough.friction_of_angle); });
  state_position_plan(f, c.position_plan);
  state_truth_check(f, c.truth_check);
  f.object("provenance", "What the result was made with.",
           [&](Fields& of) { state_provenance(of, provenance); });
}

}  // namespace

std::string calibration_json(const Calibration& c, const Provenance& provenance) {
  const wording::WordsIn english({});
  const wording::TorquesIn unit(c.manifest.torque_unit());
  Fields f(Fields::Purpose::file);
  state_whole(f, c, provenance);
  const Json all = std::move(f).take();
  return json_without_hidden(all.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string calibration_schema() {
  const wording::WordsIn english({});
  Fields f(Fields::Purpose::schema);
  state_whole(f, Calibration(), Provenance());
  Json all{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
           {"$id", "urn:tribolog:calibration:1"},
           {"title", "tribolog calibration"}};
  all["$defs"] = common_definitions();
  all.update(std::move(f).take(
      "Identification result of one robot joint. SI units; joint angles on the arm's side, torques "
      "on the motor's side of the gear unless the key says joint. Every key is present, but for "
      "those that end in _code where an older program wrote the file; what a stage could not give "
      "is null, and the stage's reason says why."));
  return all.dump(1) + "\n";
}

}  // namespace tribolog::calibration
