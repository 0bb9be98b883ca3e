#include "report/experiments/robot_plan_page.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/shown_text.h"
#include "exports/experiment/plan_table.h"
#include "joint/degrees.h"
#include "plan/simulated_plan.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::experiments {
namespace {

using wording::tr;
using wording::tr_count;
using RobotPlanJson = nlohmann::ordered_json;

elements::Outcome outcome_of_plan(const RobotPlanJoint& joint) {
  if (joint.plan == nullptr || joint.plan->segments.empty()) return elements::Outcome::bad;
  const bool is_all = std::all_of(joint.plan->parts.begin(), joint.plan->parts.end(),
                                  [](const plan::PlannedPart& part) { return part.is_as_asked(); });
  return is_all && joint.plan->remarks.empty() ? elements::Outcome::good
                                               : elements::Outcome::partial;
}

std::string state_of(const RobotPlanJoint& joint) {
  if (joint.plan == nullptr) return tr("refused");
  if (joint.plan->segments.empty()) return tr("not possible");
  if (joint.plan->is_first_of_two()) return tr("first part of two");
  return outcome_of_plan(joint) == elements::Outcome::good ? tr("planned")
                                                           : tr("planned, with limits");
}

std::size_t recordings_in(const plan::ExperimentPlan& plan) {
  std::size_t recordings = 0;
  for (const plan::PlannedPart& part : plan.parts) recordings += part.recordings;
  return recordings;
}

double whole_duration_s(const std::vector<RobotPlanJoint>& joints) {
  double duration_s = 0;
  for (const RobotPlanJoint& joint : joints) {
    if (joint.plan != nullptr) duration_s += joint.plan->duration_s();
  }
  return duration_s;
}

std::string start_of(const plan::ExperimentPlan& plan) {
  if (plan.segments.empty()) return "–";
  constexpr int digits = 4;
  return exports::experiment::quantity_text(plan.angle_rad(0), truth::ReadingKind::peak_angle,
                                            digits);
}

/// When each joint is measured, from the first set point of the first one on.
elements::Table order_table(const std::vector<RobotPlanJoint>& joints) {
  elements::Table table;
  table.id = "table-order";
  table.is_stacked = true;
  table.caption = tr("One joint after the other");
  table.columns = {{tr("Joint"), "", false, true}, {tr("State"), "", false},
                   {tr("Starts at"), "", true},    {tr("Takes"), "", true},
                   {tr("Recordings"), "", true},   {tr("Angle at the start"), "", true}};
  double start_s = 0;
  for (const RobotPlanJoint& joint : joints) {
    if (joint.plan == nullptr) {
      table.rows.push_back({{printable(joint.name), state_of(joint), "–", "–", "–", "–"}, false});
      continue;
    }
    const double duration_s = joint.plan->duration_s();
    table.rows.push_back(
        {{printable(joint.name), state_of(joint), exports::experiment::duration_text(start_s),
          exports::experiment::duration_text(duration_s),
          wording::count(recordings_in(*joint.plan)), start_of(*joint.plan)},
         false});
    start_s += duration_s;
  }
  table.note =
      tr("Times are those of the set points; moving each joint to its first angle comes "
         "between them.");
  return table;
}

void fill_part(const plan::PlannedPart& part, engine::TemplateValues& values) {
  engine::TemplateValues& out = values.add_section("PART");
  const bool is_there = part.recordings > 0;
  out.set("OUTCOME", elements::class_of(
                         part.state == plan::PartState::planned      ? elements::Outcome::good
                         : part.state == plan::PartState::impossible ? elements::Outcome::bad
                                                                     : elements::Outcome::partial));
  out.set("TITLE", wording::capitalised(exports::experiment::part_title(part.role)));
  out.set_optional("STATE", part.state == plan::PartState::planned
                                ? ""
                                : wording::words(plan::stated(part.state)));
  out.set_optional("MOTION",
                   is_there && !part.motion.empty() ? wording::capitalised(part.motion) : "");
  out.set("TIME", is_there ? exports::experiment::duration_text(part.duration_s) : "–");
}

void fill_plan(const RobotPlanJoint& joint, engine::TemplateValues& values) {
  values.set("SENTENCE", wording::as_sentence(exports::experiment::plan_sentence(*joint.plan)));
  values.set("CAPTION", tr("{joint}, angles and speeds of the joint", {{"joint", joint.name}}));
  for (const plan::PlannedPart& part : joint.plan->parts) fill_part(part, values);
}

void fill_planned_joint(const RobotPlanJoint& joint, engine::TemplateValues& values) {
  values.set("OUTCOME", elements::class_of(outcome_of_plan(joint)));
  values.set("STATE", state_of(joint));
  engine::TemplateValues& name = values.add_section(joint.file.empty() ? "NO_LINK" : "LINK");
  name.set("TEXT", wording::or_dash(joint.name));
  if (!joint.file.empty()) name.set("HREF", elements::link_to(joint.file));
  if (joint.plan == nullptr) {
    values.set_optional("REFUSAL", joint.refusal);
  } else {
    fill_plan(joint, values.add_section("PLAN"));
  }
}

void fill_verdict_of_plans(const std::vector<RobotPlanJoint>& joints,
                           engine::TemplateValues& values) {
  engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  elements::Outcome worst = elements::Outcome::good;
  std::size_t planned = 0;
  bool is_first_of_two = false;
  for (const RobotPlanJoint& joint : joints) {
    worst = std::max(worst, outcome_of_plan(joint));
    planned += joint.plan != nullptr && !joint.plan->segments.empty() ? 1 : 0;
    is_first_of_two |= joint.plan != nullptr && joint.plan->is_first_of_two();
  }
  verdict.set("WORD", planned == 0                       ? tr("NOT POSSIBLE")
                      : worst == elements::Outcome::bad  ? tr("PLAN, NOT OF ALL JOINTS")
                      : is_first_of_two                  ? tr("FIRST PART OF TWO")
                      : worst == elements::Outcome::good ? tr("PLAN")
                                                         : tr("PLAN, WITH LIMITS"));
  verdict.set(
      "SENTENCE",
      tr_count(static_cast<std::int64_t>(planned),
               "{planned} of {joints} joints is measured in {duration}.",
               "{planned} of {joints} joints are measured in {duration}.",
               {{"planned", planned},
                {"joints", joints.size()},
                {"duration", exports::experiment::duration_text(whole_duration_s(joints))}}));
  elements::fill_outcome(worst, verdict);
  engine::TemplateValues& findings = verdict.add_section("FINDINGS");
  const auto add_text = [&](const std::string& text) {
    findings.add_section("FINDING").set("TEXT", text);
  };
  add_text(
      tr("The joints move one at a time, in this order; the others stand still, in a pose in "
         "which the axis of the moving joint is horizontal."));
  if (planned > 0) {
    add_text(
        tr("Each joint's log is kept as {log} in its directory; the manifest of all of them is "
           "dataset.toml: tribolog report dataset.toml -o robot.",
           {{"log", plan::planned_log_name}}));
  }
  if (is_first_of_two) {
    add_text(
        tr("Parts around a gravity peak have to wait for its angle: record these plans, report "
           "on the robot, and plan again with --calibration and the directory of the report."));
  }
}

RobotPlanJson joint_json(const RobotPlanJoint& joint) {
  RobotPlanJson made{
      {"name", joint.name},
      {"plan", joint.file.empty() ? RobotPlanJson(nullptr) : RobotPlanJson(joint.file)},
      {"refusal", joint.plan == nullptr ? RobotPlanJson(joint.refusal) : RobotPlanJson(nullptr)}};
  if (joint.plan == nullptr) return made;
  made["sentence"] = exports::experiment::plan_sentence(*joint.plan);
  made["duration_s"] = joint.plan->duration_s();
  made["recordings"] = recordings_in(*joint.plan);
  made["parts"] = RobotPlanJson::array();
  for (const plan::PlannedPart& part : joint.plan->parts) {
    made["parts"].push_back({{"role", joint::to_string(part.role)},
                             {"state", wording::words(plan::stated(part.state))},
                             {"recordings", part.recordings},
                             {"duration_s", part.duration_s},
                             {"motion", wording::words(part.motion)}});
  }
  return made;
}

std::string plans_json(const std::vector<RobotPlanJoint>& joints,
                       const calibration::Provenance& provenance) {
  const wording::WordsIn english({});
  RobotPlanJson all{{"schema", "tribolog-robot-plan-1"},
                    {"version", provenance.tool_version},
                    {"created_utc", provenance.created_utc},
                    {"duration_s", whole_duration_s(joints)},
                    {"joints", RobotPlanJson::array()}};
  for (const RobotPlanJoint& joint : joints) all["joints"].push_back(joint_json(joint));
  return json_without_hidden(all.dump(2, ' ', false, RobotPlanJson::error_handler_t::replace)) +
         "\n";
}

const joint::JointFacts* facts_of_robot(const std::vector<RobotPlanJoint>& joints) {
  for (const RobotPlanJoint& joint : joints) {
    if (joint.plan != nullptr) return &joint.plan->joint.facts;
  }
  return nullptr;
}

}  // namespace

std::string robot_plan_page(const std::vector<RobotPlanJoint>& joints,
                            const calibration::Provenance& provenance, wording::Language language) {
  const std::string numbers = plans_json(joints, provenance);
  const wording::WordsIn words(language);
  engine::TemplateValues values;
  engine::fill_head(provenance, values, engine::PageKind::robot);
  const joint::JointFacts* facts = facts_of_robot(joints);
  values.set("TITLE", facts == nullptr ? tr("Robot") : wording::or_dash(facts->robot));
  elements::fill_facts(
      {{tr("Joints"), wording::count(joints.size())},
       {tr("Serial number"), wording::or_dash(facts == nullptr ? "" : facts->serial)},
       {tr("Time of all joints"), exports::experiment::duration_text(whole_duration_s(joints))}},
      values);
  fill_verdict_of_plans(joints, values);
  elements::fill_table(order_table(joints), "ORDER", values);
  for (const RobotPlanJoint& joint : joints) fill_planned_joint(joint, values.add_section("JOINT"));
  values.set_checked_by_modifier("RESULT_JSON", numbers);
  return engine::expand_template("robot_plan.tpl", values, language);
}

}  // namespace tribolog::report::experiments
