#include "exports/experiment/plan_files.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "exports/experiment/plan_table.h"
#include "ingest/manifest/toml_document.h"
#include "joint/degrees.h"
#include "plan/simulated_plan.h"
#include "wording/language.h"
#include "wording/words.h"

namespace tribolog::exports::experiment {

namespace {

/// What the reader of a manifest is to do before logs can be read by it.
std::string head(const std::string& logs) {
  return fmt::format(
      "# {}\n"
      "# or correct the names below. A log's clock starts with the set points; where it does not,\n"
      "# its from_s and to_s shift by the difference. Columns and units are to be corrected to\n"
      "# the log's own.\nschema = \"tribolog-dataset-1\"\n",
      logs);
}

std::string robot_table(const joint::JointFacts& f) {
  std::string text = fmt::format("\n[robot]\nname = {}\n", ingest::manifest::toml_text(f.robot));
  if (!f.serial.empty())
    text += fmt::format("serial = {}\n", ingest::manifest::toml_text(f.serial));
  return text;
}

std::string name_and_gear(const joint::JointFacts& f) {
  return fmt::format("name = {}\ngear_ratio = {}\n", ingest::manifest::toml_text(f.joint),
                     ingest::manifest::toml_number(f.gear_ratio));
}

/// Effort, columns and recordings. @param of before the tables' names: "", or "joints." of a robot.
std::string log_tables(const plan::ExperimentPlan& plan, const std::string& of,
                       const std::string& log) {
  const joint::JointFacts& f = plan.joint.facts;
  std::string text = fmt::format(
      "\n[{}effort]  # what the log's effort is: correct it if it is not this\n"
      "kind = \"{}\"\nside = \"{}\"\n",
      of, joint::to_string(f.effort_kind), joint::to_string(f.effort_side));
  if (f.torque_constant_Nm_A) {
    text += fmt::format("torque_constant_Nm_A = {}\n",
                        ingest::manifest::toml_number(*f.torque_constant_Nm_A));
  }
  const bool is_current = f.effort_kind == joint::EffortKind::motor_current;
  text += fmt::format(
      "\n[{}columns]\ntime = {{name = \"t_s\", unit = \"s\"}}\n"
      "angle = {{name = \"q_rad\", unit = \"rad\"}}\n"
      "speed = {{name = \"dq_rad_s\", unit = \"rad/s\"}}  # leave out where there is none\n"
      "effort = {{name = \"{}\", unit = \"{}\"}}\n",
      of, is_current ? "current_A" : "torque_Nm", is_current ? "A" : "Nm");
  for (const plan::PlannedSegment& s : plan.segments) {
    if (!s.role) continue;
    text += fmt::format(
        "\n[[{}recording]]\nrole = \"{}\"\nfile = {}\nfrom_s = {}\nto_s = {}\n"
        "note = {}\n",
        of, joint::to_string(*s.role), ingest::manifest::toml_text(log),
        ingest::manifest::toml_number(s.from_s), ingest::manifest::toml_number(s.to_s),
        ingest::manifest::toml_text(wording::words(s.name)));
  }
  return text;
}

}  // namespace

std::string plan_dataset_toml(const plan::ExperimentPlan& plan) {
  const wording::WordsIn english({});
  const joint::JointFacts& f = plan.joint.facts;
  return head(fmt::format(
             "The log that is recorded while the joint follows setpoints.csv: name it {}",
             plan::planned_log_name)) +
         robot_table(f) + "\n[joint]\n" + name_and_gear(f) +
         log_tables(plan, "", plan::planned_log_name);
}

std::string joint_toml(const joint::JointFacts& f) {
  std::string text =
      "# What the joint did in the recordings: put its true limits here, and plan again.\n"
      "schema = \"tribolog-joint-1\"\n" +
      robot_table(f) + "\n[joint]\n" + name_and_gear(f);
  const auto add = [&](const char* key, double value) {
    text += fmt::format("{} = {:.6g}\n", key, value);
  };
  add("lowest_deg", f.lowest_rad * joint::degrees_per_rad);
  add("highest_deg", f.highest_rad * joint::degrees_per_rad);
  add("speed_limit_deg_s", f.speed_limit_rad_s * joint::degrees_per_rad);
  add("acceleration_limit_deg_s2", f.acceleration_limit_rad_s2 * joint::degrees_per_rad);
  add("motor_torque_limit_Nm", f.torque_limit_Nm);
  const auto add_table =
      [&](const char* name,
          const std::vector<std::pair<const char*, std::optional<double>>>& keys) {
        std::string lines;
        for (const auto& [key, value] : keys) {
          if (value) lines += fmt::format("{} = {:.6g}\n", key, *value);
        }
        if (!lines.empty()) text += fmt::format("\n[{}]\n", name) + lines;
      };
  std::optional<double> q_peak_deg = f.q_peak_rad;
  if (q_peak_deg) *q_peak_deg *= joint::degrees_per_rad;
  add_table("gravity", {{"motor_torque_Nm", f.gravity_Nm}, {"q_peak_deg", q_peak_deg}});
  add_table("friction", {{"static_Nm", f.static_Nm},
                         {"coulomb_Nm", f.coulomb_Nm},
                         {"stribeck_speed_rad_s", f.stribeck_speed_rad_s},
                         {"bristle_stiffness_Nm_rad", f.bristle_stiffness_Nm_rad}});
  add_table("log", {{"sample_rate_Hz", f.sample_rate_Hz},
                    {"encoder_counts_per_turn", f.encoder_counts_per_turn}});
  if (!f.ripple_periods_per_turn.empty()) {
    text += fmt::format("\n[ripple]\nperiods_per_turn = [{:.6g}]\n",
                        fmt::join(f.ripple_periods_per_turn, ", "));
  }
  text += fmt::format("\n[effort]\nkind = \"{}\"\nside = \"{}\"\n", joint::to_string(f.effort_kind),
                      joint::to_string(f.effort_side));
  if (f.torque_constant_Nm_A) add("torque_constant_Nm_A", *f.torque_constant_Nm_A);
  return text;
}

std::string plan_robot_toml(const std::vector<PlannedJoint>& joints) {
  const wording::WordsIn english({});
  std::string text = head(
      fmt::format("The logs that are recorded while each joint follows its setpoints.csv: name "
                  "them\n# {} in the joints' directories",
                  plan::planned_log_name));
  if (!joints.empty()) text += robot_table(joints.front().plan->joint.facts);
  for (const PlannedJoint& one : joints) {
    text += "\n[[joints]]\n" + name_and_gear(one.plan->joint.facts) +
            log_tables(*one.plan, "joints.", one.directory + "/" + plan::planned_log_name);
  }
  return text;
}

namespace {

void append_row(const plan::ExperimentPlan& plan, double t_s, std::string& csv) {
  append_number(csv, t_s);
  csv += ',';
  append_number(csv, plan.angle_rad(t_s));
  csv += ',';
  append_number(csv, plan.speed_rad_s(t_s));
  const plan::PlannedSegment& s = plan.segments[plan.segment_at(t_s)];
  const bool torque_leads = s.ramp && t_s >= s.from_s && t_s < s.to_s;
  csv += torque_leads ? ",1," : ",0,";
  append_number(csv, torque_leads ? s.ramp->direction * s.ramp->rate_Nm_s * (t_s - s.from_s) : 0.0);
  csv += '\n';
}

}  // namespace

std::string set_points_csv(const plan::ExperimentPlan& plan) {
  std::string csv = "t_s,q_rad,dq_rad_s,torque_mode,ramp_torque_Nm\n";
  if (plan.segments.empty()) return csv;
  const double rate = plan.joint.set_point_rate_Hz;
  const double end = plan.duration_s();
  const auto rows = static_cast<std::size_t>(std::floor(end * rate));
  constexpr std::size_t usual_row_bytes = 56;
  csv.reserve(rows * usual_row_bytes);
  double t_s = 0;
  for (std::size_t i = 0; i <= rows; ++i) {
    t_s = static_cast<double>(i) / rate;
    append_row(plan, std::min(t_s, end), csv);
  }
  if (t_s < end) append_row(plan, end, csv);
  return csv;
}

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json words_or_null(const Statement& statement) { return text_or_null(wording::words(statement)); }

Json part_json(const plan::PlannedPart& part) {
  return {
      {"role", joint::to_string(part.role)},  {"state", wording::words(plan::stated(part.state))},
      {"recordings", part.recordings},        {"duration_s", number(part.duration_s)},
      {"motion", words_or_null(part.motion)}, {"gives", wording::words(part.gives)},
      {"why", words_or_null(part.why)},       {"help", words_or_null(part.help)}};
}

Json segment_json(const plan::PlannedSegment& s) {
  Json made{{"name", wording::words(s.name)},
            {"role", s.role ? Json(joint::to_string(*s.role)) : Json(nullptr)},
            {"start_s", number(s.start_s)},
            {"end_s", number(s.end_s())}};
  if (s.role) {
    made["from_s"] = number(s.from_s);
    made["to_s"] = number(s.to_s);
  }
  if (s.ramp) {
    made["ramp"] = {{"direction", s.ramp->direction},
                    {"rate_Nm_s", number(s.ramp->rate_Nm_s)},
                    {"largest_change_Nm", number(s.ramp->largest_change_Nm)},
                    {"largest_travel_joint_rad", number(s.ramp->largest_travel_rad)}};
  }
  return made;
}

Json expectation_json(const plan::ExpectedInterval& e) {
  return {{"name", to_string(e.name)},        {"unit", truth::unit_of(e.quantity)},
          {"assumed_truth", number(e.truth)}, {"half_width", number(e.half_width)},
          {"scatter", number(e.scatter)},     {"runs", e.runs},
          {"identified_in", e.found},         {"held_by_interval_in", e.inside}};
}

template <class List, class ToJson>
Json list_json(const List& list, const ToJson& to_json) {
  Json all = Json::array();
  for (const auto& one : list) all.push_back(to_json(one));
  return all;
}

}  // namespace

std::string plan_json(const plan::ExperimentPlan& plan, const plan::ExpectedIntervals& expected,
                      const calibration::Provenance& provenance) {
  const wording::WordsIn english({});
  const joint::JointFacts& f = plan.joint.facts;
  const Json all{{"schema", "tribolog-plan-1"},
                 {"tool", provenance.tool_version},
                 {"created_utc", provenance.created_utc},
                 {"robot", f.robot},
                 {"joint", f.joint},
                 {"gear_ratio", f.gear_ratio},
                 {"sentence", plan_sentence(plan)},
                 {"duration_s", number(plan.duration_s())},
                 {"effort", plan.effort},
                 {"first_of_two", plan.is_first_of_two()},
                 {"parts", list_json(plan.parts, part_json)},
                 {"remarks", wording::words(plan.remarks)},
                 {"instructions", plan_instructions(plan)},
                 {"positions_joint_rad", plan.positions_rad},
                 {"ripple_left_share", number(plan.ripple_left_share)},
                 {"amplitude_joint_rad", number(plan.amplitude_rad)},
                 {"frequency_Hz", number(plan.frequency_Hz)},
                 {"motor_speeds_rad_s", plan.motor_speeds_rad_s},
                 {"segments", list_json(plan.segments, segment_json)},
                 {"assumptions", list_json(plan.joint.assumptions,
                                           [](const plan::Assumption& a) {
                                             return Json{{"what", wording::words(a.what)},
                                                         {"value", number(a.value)},
                                                         {"unit", text_or_null(a.unit)},
                                                         {"source", wording::words(a.source)},
                                                         {"known", a.is_known}};
                                           })},
                 {"expected",
                  {{"runs", expected.runs},
                   {"seed", expected.seed},
                   {"quantities", list_json(expected.quantities, expectation_json)}}}};
  return json_without_hidden(all.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace tribolog::exports::experiment
