#include "report/document/robot_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "report/document/robot_matrix.h"
#include "report/document/thumbnail.h"
#include "report/document/view_parts.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/result_words.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "wording/number_text.h"
#include "wording/torques_in.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {
namespace {

using wording::tr;
using wording::tr_count;

elements::Outcome outcome_of(const RobotJoint& joint) {
  return joint.calibration == nullptr ? elements::Outcome::bad
                                      : elements::outcome_of(joint.calibration->judgement.verdict);
}

std::string word_of(const RobotJoint& joint) {
  return joint.calibration == nullptr
             ? tr("refused")
             : elements::verdict_in_words(joint.calibration->judgement.verdict);
}

void fill_thumbnail(const std::optional<Thumbnail>& picture, const std::string& name,
                    engine::TemplateValues& values) {
  if (!picture) return;
  engine::TemplateValues& out = values.add_section("THUMBNAIL");
  out.set("NAME", name);
  out.set("ZERO", picture->zero);
  out.set("KIND", picture->is_of_points ? "measured dots" : "measured");
  out.set("MEASURED", picture->measured);
  out.set_optional("FITTED", picture->fitted);
  out.set("SIZE", tr("{width}, {height}", {{"width", picture->across}, {"height", picture->up}}));
}

void fill_numbers(const RobotJoint& joint, engine::TemplateValues& values) {
  const calibration::Calibration& c = *joint.calibration;
  const wording::TorquesIn unit(c.manifest.torque_unit());
  values.set_optional("SENTENCE", wording::as_sentence(c.judgement.sentence));
  fill_thumbnail(loop_thumbnail(c), tr("Hysteresis loop"), values);
  fill_thumbnail(curve_thumbnail(c), tr("Friction over speed"), values);
}

void fill_name(const RobotJoint& joint, engine::TemplateValues& values) {
  engine::TemplateValues& name = values.add_section(joint.file.empty() ? "NO_LINK" : "LINK");
  name.set("TEXT", wording::or_dash(joint.name));
  if (!joint.file.empty()) name.set("HREF", elements::link_to(joint.file));
}

void fill_cell(const MatrixCell& cell, engine::TemplateValues& row) {
  engine::TemplateValues& out = row.add_section("CELL");
  out.set("OUTCOME", elements::class_of(cell.outcome));
  out.set("TEXT", wording::or_dash(cell.text));
  out.set_optional("VERDICT", cell.outcome == elements::Outcome::good ? "" : cell.verdict_word);
  if (cell.change.empty()) return;
  engine::TemplateValues& change = out.add_section("CHANGE_IF");
  change.set("CHANGE", cell.change);
  change.set("CHANGE_KIND", cell.is_changed ? "changed" : "same");
  change.set_optional("CHANGE_WORD", cell.change_word);
}

void fill_matrix(const std::vector<RobotJoint>& joints, engine::TemplateValues& values) {
  const std::vector<MatrixRow> rows = robot_matrix(joints);
  if (rows.empty()) return;
  engine::TemplateValues& matrix = values.add_section("MATRIX");
  for (const RobotJoint& joint : joints) {
    engine::TemplateValues& head = matrix.add_section("HEAD");
    fill_name(joint, head);
    head.set("OUTCOME", elements::class_of(outcome_of(joint)));
    head.set("VERDICT", word_of(joint));
  }
  for (const MatrixRow& row : rows) {
    engine::TemplateValues& out = matrix.add_section("ROW");
    out.set("WORDS", row.words);
    out.set_optional("UNIT", row.unit);
    for (const MatrixCell& cell : row.cells) fill_cell(cell, out);
  }
}

void fill_joint(const RobotJoint& joint, engine::TemplateValues& values) {
  values.set("OUTCOME", elements::class_of(outcome_of(joint)));
  values.set("VERDICT", word_of(joint));
  fill_name(joint, values);
  if (joint.calibration == nullptr) {
    values.set_optional("REFUSAL", joint.refusal);
  } else {
    fill_numbers(joint, values.add_section("NUMBERS"));
  }
}

/// Of the first joint that has one: all of them are of one robot.
const joint::Manifest* manifest_of(const std::vector<RobotJoint>& joints) {
  const auto known = std::find_if(joints.begin(), joints.end(), [](const RobotJoint& joint) {
    return joint.calibration != nullptr;
  });
  return known == joints.end() ? nullptr : &known->calibration->manifest;
}

std::vector<elements::Fact> facts_of(const std::vector<RobotJoint>& joints) {
  std::vector<elements::Fact> facts{{tr("Joints"), wording::count(joints.size())}};
  if (const joint::Manifest* m = manifest_of(joints)) {
    facts.push_back({tr("Serial number"), wording::or_dash(m->serial)});
    facts.push_back({tr("Measured on"), wording::or_dash(m->measured_on)});
    facts.push_back({tr("Operator"), wording::or_dash(m->operator_name)});
  }
  return facts;
}

std::string heading_of(const RobotJoint& joint) {
  return joint.calibration == nullptr
             ? tr("REFUSED")
             : elements::verdict_heading(joint.calibration->judgement.verdict);
}

void fill_verdict(const std::vector<RobotJoint>& joints, engine::TemplateValues& values) {
  engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const auto worst = std::max_element(
      joints.begin(), joints.end(),
      [](const RobotJoint& a, const RobotJoint& b) { return outcome_of(a) < outcome_of(b); });
  const auto usable = std::count_if(joints.begin(), joints.end(), [](const RobotJoint& joint) {
    return outcome_of(joint) == elements::Outcome::good;
  });
  verdict.set("WORD", heading_of(*worst));
  verdict.set("SENTENCE",
              tr_count(static_cast<std::int64_t>(usable), "{usable} of {joints} joints is usable.",
                       "{usable} of {joints} joints are usable.",
                       {{"usable", static_cast<std::size_t>(usable)}, {"joints", joints.size()}}));
  elements::fill_outcome(outcome_of(*worst), verdict);
  std::map<std::string, std::vector<std::string>> others;
  for (const RobotJoint& joint : joints) {
    if (outcome_of(joint) != elements::Outcome::good) others[word_of(joint)].push_back(joint.name);
  }
  if (others.empty()) return;
  engine::TemplateValues& findings = verdict.add_section("FINDINGS");
  for (const auto& [word, names] : others) {
    findings.add_section("FINDING").set(
        "TEXT", wording::as_sentence(tr(
                    "{verdict}: {joints}",
                    {{"verdict", word}, {"joints", fmt::format("{}", fmt::join(names, ", "))}})));
  }
}

using RobotJson = nlohmann::ordered_json;

RobotJson quantity_json(const calibration::QuantityVerdict& q) {
  const std::string key = to_string(q.quantity);
  RobotJson made{{"key", key},
                 {"words", wording::words_for("quantity", key)},
                 {"verdict", calibration::to_string(q.verdict)},
                 {"unit", q.unit},
                 {"estimate", nullptr}};
  if (!q.estimate || !std::isfinite(q.estimate->value)) return made;
  const statistics::Estimate& stated = q.budget ? q.budget->expanded : *q.estimate;
  const auto number = [](double value) {
    return std::isfinite(value) ? RobotJson(value) : RobotJson(nullptr);
  };
  made["estimate"] = {{"value", number(q.estimate->value)},
                      {"low", number(stated.low)},
                      {"high", number(stated.high)}};
  return made;
}

RobotJson joint_result_json(const RobotJoint& joint) {
  const auto text_or_null = [](const std::string& text) {
    return text.empty() ? RobotJson(nullptr) : RobotJson(text);
  };
  RobotJson made{{"name", joint.name},
                 {"report", text_or_null(joint.file)},
                 {"refusal", text_or_null(joint.refusal)}};
  if (joint.calibration == nullptr) return made;
  const wording::TorquesIn unit(joint.calibration->manifest.torque_unit());
  const calibration::Judgement& judgement = joint.calibration->judgement;
  made["verdict"] = calibration::to_string(judgement.verdict);
  made["sentence"] = wording::words(judgement.sentence);
  made["gear_ratio"] = joint.calibration->manifest.drive.gear_ratio();
  made["quantities"] = RobotJson::array();
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    if (!q.unit.empty()) made["quantities"].push_back(quantity_json(q));
  }
  return made;
}

/// In English, whatever the page is in.
std::string results_json(const std::vector<RobotJoint>& joints,
                         const calibration::Provenance& provenance) {
  const wording::WordsIn english({});
  const joint::Manifest* manifest = manifest_of(joints);
  RobotJson all{{"schema", "tribolog-robot-result-1"},
                {"version", provenance.tool_version},
                {"created_utc", provenance.created_utc},
                {"robot", manifest == nullptr ? "" : manifest->robot},
                {"serial", manifest == nullptr ? "" : manifest->serial},
                {"joints", RobotJson::array()}};
  for (const RobotJoint& joint : joints) all["joints"].push_back(joint_result_json(joint));
  return json_without_hidden(all.dump(2, ' ', false, RobotJson::error_handler_t::replace)) + "\n";
}

}  // namespace

std::string robot_page(const std::vector<RobotJoint>& joints,
                       const calibration::Provenance& provenance, wording::Language language) {
  const std::string numbers = results_json(joints, provenance);
  const wording::WordsIn words(language);
  engine::TemplateValues values;
  engine::fill_head(provenance, values, engine::PageKind::robot);
  const joint::Manifest* manifest = manifest_of(joints);
  const bool is_unnamed = manifest != nullptr && manifest->robot == joint::unnamed_robot;
  values.set("TITLE", manifest == nullptr ? tr("Robot")
                      : is_unnamed        ? tr("Robot not named")
                                          : wording::or_dash(manifest->robot));
  elements::fill_facts(facts_of(joints), values);
  fill_verdict(joints, values);
  fill_matrix(joints, values);
  for (const RobotJoint& joint : joints) fill_joint(joint, values.add_section("JOINT"));
  values.set_checked_by_modifier("RESULT_JSON", numbers);
  return engine::expand_template("robot.tpl", values, language);
}

}  // namespace tribolog::report::document
