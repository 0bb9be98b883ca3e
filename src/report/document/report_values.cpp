#include "report/document/report_values.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/document/report_view.h"
#include "report/document/view_parts.h"
#include "report/elements/element_values.h"
#include "report/engine/template_engine.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

// The values of quantities.tpl and data_checks.tpl.

namespace {

using wording::tr;
using wording::tr_count;

void fill_references(const std::vector<int>& findings, engine::TemplateValues& values) {
  for (const int number : findings) {
    values.add_section("REFERENCE").set("NUMBER", std::to_string(number));
  }
}

/// Columns in which something stands.
struct ShownColumns {
  bool joint_side{};
  bool changes{};
  bool parts{};
};

void fill_row(const QuantityRow& row, ShownColumns shown, engine::TemplateValues& out) {
  out.set("WORDS", wording::capitalised(row.words));
  out.set("VERDICT", row.verdict_word);
  elements::fill_state(row.outcome, out);
  fill_references(row.findings, out);
  out.set("AT_MOTOR", wording::or_dash(row.at_motor));
  out.set("MOTOR_KIND", row.at_motor.empty() ? "none" : "some");
  if (shown.joint_side) {
    engine::TemplateValues& cell = out.add_section("JOINT_SIDE");
    cell.set("AT_JOINT", wording::or_dash(row.at_joint));
    cell.set("JOINT_KIND", row.at_joint.empty()   ? "none"
                           : row.at_motor.empty() ? "value some"
                                                  : "some");
  }
  out.set("COVERAGE", wording::or_dash(row.coverage));
  out.set("COVERAGE_KIND", row.coverage.empty() ? "none" : "some");
  const auto add = [&](const LimitCell& limit) {
    engine::TemplateValues& line = out.add_section("LIMIT");
    line.set("RULE", limit.rule);
    line.set("WORD", limit.word);
    elements::fill_state(limit.outcome, line);
  };
  for (const LimitCell& limit : row.limits) add(limit);
  if (row.stated) add(*row.stated);
  if (shown.changes) {
    engine::TemplateValues& cell = out.add_section("CHANGE");
    cell.set("AMOUNT", wording::or_dash(row.change));
    cell.set_optional("WORD", row.change_word);
    cell.set_optional("RANGE", row.change_range);
    cell.set("KIND", row.is_changed ? "changed" : row.change_word.empty() ? "none" : "unchanged");
  }
  if (!shown.parts) return;
  engine::TemplateValues& part = out.add_section("PART");
  part.set("LARGEST_PART", wording::or_dash(row.largest_part));
  part.set("PART_KIND", row.largest_part.empty() ? "none" : "some");
}

void fill_quantities(const ReportView& view, engine::TemplateValues& values) {
  const std::vector<QuantityRow>& rows = view.quantities;
  if (rows.empty()) return;
  engine::TemplateValues& table = values.add_include("QUANTITIES", "quantities.tpl");
  const auto any = [&](auto has) { return std::any_of(rows.begin(), rows.end(), has); };
  const bool has_limits = any([](const QuantityRow& row) { return !row.limits.empty(); });
  const ShownColumns shown{any([](const QuantityRow& row) { return !row.at_joint.empty(); }),
                           !view.last_day.empty(),
                           std::any_of(view.budget.begin(), view.budget.end(),
                                       [](const BudgetRow& row) { return row.parts.size() > 1; })};
  table.set("SIDE", view.has_gear ? tr("At the motor") : tr("At the joint"));
  if (shown.joint_side) table.add_section("JOINT_HEAD");
  if (shown.parts) table.add_section("PARTS_HEAD");
  if (!has_limits) table.add_section("NO_LIMITS");
  engine::TemplateValues& since = table.add_section(shown.changes ? "CHANGES_HEAD" : "NO_CHANGES");
  if (shown.changes) {
    since.set("DAY", view.last_day);
    engine::TemplateValues& note = table.add_section("CHANGES_NOTE");
    note.set("DAY", view.last_day);
    note.set("ID", view.last_id);
  }
  table.set_optional("NOT_ASKED_FOR", view.not_asked_for);
  table.set_optional("LIMITING_EFFECT", view.limiting_effect);
  for (const QuantityRow& row : rows) {
    engine::TemplateValues& out = table.add_section("QUANTITY");
    fill_row(row, shown, out);
  }
}

/// On page one: the first of the steps, and what a plan of them takes.
void fill_next_experiment(const ReportView& view, engine::TemplateValues& values) {
  if (view.next_steps.empty()) return;
  engine::TemplateValues& out = values.add_include("NEXT_EXPERIMENT", "next_experiment.tpl");
  const NextStep& first = view.next_steps.front();
  out.set("TEXT", first.text);
  out.set("QUANTITIES", fmt::format("{}", fmt::join(first.quantities, ", ")));
  const std::size_t more = view.next_steps.size() - 1;
  if (more > 0) {
    out.add_section("MORE").set(
        "COUNT", tr_count(more, "{steps} more step", "{steps} more steps", {{"steps", more}}));
  }
  out.set_optional("PARTS", view.next_parts);
}

void fill_ticks(const std::vector<KeyPicture::Tick>& ticks, const std::string& section,
                engine::TemplateValues& values) {
  for (const KeyPicture::Tick& tick : ticks) {
    engine::TemplateValues& label = values.add_section(section);
    label.set("AT", fmt::format("{:.1f}", tick.at));
    label.set("LABEL", tick.label);
  }
}

void fill_log(const LogPicture& picture, engine::TemplateValues& values) {
  constexpr double narrowest_named_px = 60;
  engine::TemplateValues& out = values.add_include("LOG_PICTURE", "log_picture.tpl");
  out.set("CAPTION", picture.caption);
  fill_ticks(picture.y_ticks, "Y_TICK", out);
  std::string names;
  for (const LogPicture::Phase& phase : picture.phases) {
    engine::TemplateValues& part = out.add_section("PHASE");
    const std::string times =
        phase.recordings > 1 ? fmt::format(" × {}", phase.recordings) : std::string();
    part.set("ROLE", phase.role);
    part.set("FROM", fmt::format("{:.1f}", phase.from));
    part.set("WIDTH", fmt::format("{:.1f}", std::max(1.0, phase.to - phase.from)));
    part.set("PATH", phase.path);
    names += (names.empty() ? "" : ", ") + phase.name + times;
    if (phase.to - phase.from < narrowest_named_px) continue;
    engine::TemplateValues& label = part.add_section("NAMED");
    label.set("MIDDLE", fmt::format("{:.1f}", (phase.from + phase.to) / 2));
    label.set("NAME", phase.name + times);
  }
  out.set("NAMES", names);
}

void fill_pictures(const std::vector<KeyPicture>& pictures, engine::TemplateValues& values) {
  for (const KeyPicture& picture : pictures) {
    engine::TemplateValues& out = values.add_include("KEY_PICTURE", "key_picture.tpl");
    out.set("PICTURE_ID", picture.id);
    out.set("TITLE", picture.title);
    out.set("CAPTION", picture.caption);
    out.set("X_TITLE", picture.x_title);
    out.set("Y_TITLE", picture.y_title);
    out.set("GRID", picture.grid);
    fill_ticks(picture.x_ticks, "X_TICK", out);
    fill_ticks(picture.y_ticks, "Y_TICK", out);
    const std::pair<const char*, const std::string&> paths[] = {
        {"band", picture.band},         {"level", picture.level},
        {"bars", picture.bars},         {"measured", picture.measured},
        {"backward", picture.backward}, {"hollow", picture.backward},
        {"fitted", picture.fitted},     {"forward", picture.forward}};
    for (const auto& [kind, path] : paths) {
      if (path.empty()) continue;
      engine::TemplateValues& line = out.add_section("PATH");
      line.set("KIND", kind);
      line.set("PATH", path);
    }
  }
}

void fill_terms(const ReportView& view, engine::TemplateValues& values) {
  engine::TemplateValues& out = values.add_include("CERTIFICATE", "certificate.tpl");
  out.set("REPORT_NUMBER", view.number);
  for (const Fact& fact : view.boundary) {
    engine::TemplateValues& item = out.add_section("BOUNDARY");
    item.set("NAME", fact.name);
    item.set("TEXT", fact.text);
  }
  for (const Fact& fact : view.certificate) {
    engine::TemplateValues& item = out.add_section("STATED");
    item.set("NAME", fact.name);
    item.set("TEXT", fact.text);
  }
}

void fill_budget_row(const BudgetRow& row, engine::TemplateValues& out) {
  out.set("QUANTITY", wording::capitalised(row.quantity));
  out.set("STANDARD", row.standard);
  out.set("FREEDOM", row.freedom);
  out.set("COVERAGE", row.coverage);
  out.set("EXPANDED", row.expanded);
  for (const BudgetRow::Part& part : row.parts) {
    engine::TemplateValues& bar = out.add_section("BAR");
    bar.set("KIND", part.kind);
    bar.set("FROM", fmt::format("{:.1f}", part.from_percent));
    bar.set("WIDTH", fmt::format("{:.1f}", part.percent));
    engine::TemplateValues& named = out.add_section("PART");
    named.set("KIND", part.kind);
    named.set("NAME", part.name);
  }
  if (row.parts.empty()) out.add_section("NO_PARTS");
  out.set_optional("EFFECTS", row.effects);
}

/// A table where something is beside the recordings; else it would have but one bar a row.
void fill_budget(const std::vector<BudgetRow>& rows, engine::TemplateValues& values) {
  if (rows.empty()) return;
  values.add_section("HAS_BUDGET");
  engine::TemplateValues& budget = values.add_include("BUDGET", "budget.tpl");
  if (std::any_of(rows.begin(), rows.end(),
                  [](const BudgetRow& row) { return row.parts.size() > 1; })) {
    engine::TemplateValues& table = budget.add_section("PARTS_TABLE");
    for (const BudgetRow& row : rows) fill_budget_row(row, table.add_section("ROW"));
    return;
  }
  engine::TemplateValues& alone = budget.add_section("RECORDINGS_ALONE");
  engine::TemplateValues* effects = nullptr;
  for (const BudgetRow& row : rows) {
    if (row.effects.empty()) continue;
    if (effects == nullptr) effects = &alone.add_section("HAS_EFFECTS");
    engine::TemplateValues& one = effects->add_section("EFFECTS_OF");
    one.set("QUANTITY", wording::capitalised(row.quantity));
    one.set("EFFECTS", row.effects);
  }
}

void fill_check(const DataCheckRow& row, engine::TemplateValues& out) {
  out.set("CHECK_ID", row.id);
  out.set("TITLE", row.title);
  out.set_optional("MEASURE", row.measure);
  out.set("STATE", row.state_word);
  elements::fill_state(row.outcome, out);
  out.set("MEASURED", wording::or_dash(row.measured));
  out.set("LIMIT", wording::or_dash(row.limit));
  out.set("FOUND", wording::or_dash(row.found));
  out.set_optional("CONSEQUENCE", row.consequence);
  out.set_optional("EXPERIMENT", row.experiment);
  out.set_optional("RECORDING", row.recording);
}

void fill_data_checks(const ReportView& view, engine::TemplateValues& values) {
  if (view.data_checks.empty()) return;
  values.add_section("HAS_DATA_CHECKS");
  engine::TemplateValues& table = values.add_include("DATA_CHECKS", "data_checks.tpl");
  for (const DataCheckRow& row : view.data_checks) fill_check(row, table.add_section("CHECK"));
  const auto count = [&](Outcome outcome) {
    return static_cast<std::size_t>(
        std::count_if(view.data_checks.begin(), view.data_checks.end(),
                      [&](const DataCheckRow& row) { return row.outcome == outcome; }));
  };
  values.set("CHECKS_PASSED", tr("passed: {passed} of the {all} that apply",
                                 {{"passed", count(Outcome::good)},
                                  {"all", view.data_checks.size() - count(Outcome::absent)}}));
  if (view.rules.empty()) return;
  engine::TemplateValues& rules = table.add_section("HAS_RULES");
  for (const DataCheckRow& row : view.rules) fill_check(row, rules.add_section("RULE"));
}

/// friction_speeds.tpl at the marker FRICTION_SPEEDS; nothing if it has no rows.
void fill_friction_speeds(const FrictionSpeeds& speeds, engine::TemplateValues& values) {
  if (speeds.rows.empty()) return;
  engine::TemplateValues& table = values.add_include("FRICTION_SPEEDS", "friction_speeds.tpl");
  table.set("GOOD_FOR", speeds.good_for);
  table.set("UNIT", speeds.unit);
  const bool has_gear = !speeds.rows.front().speed_at_joint.empty();
  table.set("SPEED", has_gear ? tr("Motor speed") : tr("Joint speed"));
  table.set("SIDE", has_gear ? tr("At the motor") : tr("At the joint"));
  if (has_gear) {
    table.add_section("JOINT_HEAD").set("UNIT_AT_JOINT", speeds.unit_at_joint);
  }
  for (const FrictionRow& row : speeds.rows) {
    engine::TemplateValues& out = table.add_section("SPEED");
    out.set("MOTOR_SPEED", row.speed);
    out.set("AT_MOTOR", wording::or_dash(row.torque));
    out.set("VERDICT", row.verdict_word);
    elements::fill_state(row.outcome, out);
    if (row.speed_at_joint.empty()) continue;
    engine::TemplateValues& there = out.add_section("JOINT_SIDE");
    there.set("JOINT_SPEED", row.speed_at_joint);
    there.set("AT_JOINT", wording::or_dash(row.torque_at_joint));
  }
}

}  // namespace

void fill_provenance(const std::string& command_line, const std::string& created_utc,
                     const std::vector<std::string>& notes, const std::vector<Table>& tables,
                     engine::TemplateValues& values) {
  engine::TemplateValues& out = values.add_include("PROVENANCE", "provenance.tpl");
  out.set("COMMAND_LINE", command_line);
  out.set("CREATED", created_utc);
  if (!notes.empty()) {
    engine::TemplateValues& list = out.add_section("INPUT_NOTES");
    for (const std::string& note : notes)
      list.add_section("INPUT_NOTE").set("TEXT", wording::or_dash(note));
  }
  for (const Table& table : tables) elements::fill_table(table, "TABLE", out);
}

namespace {

/// What the fold of a section holds.
std::string fold_in_words(bool has_tables, bool has_figures) {
  if (has_tables && has_figures) return tr("Method, tables and further figures");
  if (has_tables) return tr("Method and tables");
  return has_figures ? tr("Method and further figures") : tr("Method");
}

/// A stage without data: its title says all, and its method explains nothing that is there.
bool is_empty(const Section& section) {
  return section.outcome == Outcome::absent && section.facts.empty() && section.figures.empty() &&
         std::all_of(section.tables.begin(), section.tables.end(),
                     [](const Table& table) { return table.rows.empty(); });
}

void fill_section(const Section& section, bool has_viewer, engine::TemplateValues& values) {
  engine::TemplateValues& out = values.add_include("STAGE", "stage.tpl");
  out.set("EXTENT", is_empty(section) ? "stage empty" : "stage");
  out.set("SECTION_ID", section.id);
  out.set("NUMBER", std::to_string(section.number));
  out.set("TITLE", section.title);
  out.set("STATUS", section.status);
  elements::fill_outcome(section.outcome, out);
  if (section.finding > 0) {
    out.add_section("REFERENCE").set("NUMBER", std::to_string(section.finding));
  } else {
    out.set_optional("REASON", section.reason);
  }
  if (has_viewer && section.id == section_anchor(StageId::hysteresis)) {
    out.add_include("REVIEW", "review.tpl");
  }
  if (is_empty(section)) return;
  engine::TemplateValues& fold = out.add_section("FOLD");
  fold.set_optional("EXPERIMENT", section.experiment);
  elements::fill_facts(section.facts, fold);
  fold.add_include("EXPLANATION", section.explanation);
  bool has_tables = false;
  for (const Table& table : section.tables) {
    has_tables |= !table.rows.empty();
    elements::fill_table(table, "TABLE", fold);
  }
  bool has_figures = false;
  for (const FigureCard& figure : section.figures) {
    has_figures |= !figure.is_primary;
    if (figure.is_primary) {
      elements::fill_figure(figure, out);
    } else {
      elements::fill_figure(figure, fold, "FOLDED_FIGURE");
    }
  }
  fold.set("WHAT", fold_in_words(has_tables, has_figures));
}

void fill_contents(const ReportView& view, engine::TemplateValues& values) {
  for (const Section& section : view.sections) {
    engine::TemplateValues& entry = values.add_section("CONTENTS_ENTRY");
    entry.set("SECTION_ID", section.id);
    entry.set("NUMBER", std::to_string(section.number));
    entry.set("TITLE", section.title);
    entry.set("STATUS", section.status);
    entry.set("OUTCOME", elements::class_of(section.outcome));
  }
}

void fill_finding(const Finding& finding, const std::string& section,
                  engine::TemplateValues& values) {
  engine::TemplateValues& item = values.add_section(section);
  item.set("NUMBER", std::to_string(finding.number));
  item.set("TEXT", wording::or_dash(finding.text));
  item.set_optional("CONSEQUENCE", finding.consequence);
  item.set_optional("QUANTITIES", fmt::format("{}", fmt::join(finding.quantities, ", ")));
}

/// The first on page one; of the others those that lower a verdict in sight, notes behind a click.
void fill_findings(const ReportView& view, engine::TemplateValues& verdict,
                   engine::TemplateValues& values) {
  const std::vector<Finding>& all = view.findings;
  const std::size_t first = std::min(findings_on_page_one, all.size());
  if (first > 0) {
    engine::TemplateValues& list = verdict.add_section("NUMBERED");
    for (std::size_t k = 0; k < first; ++k) fill_finding(all[k], "FINDING", list);
    if (all.size() > first) {
      verdict.add_section("FURTHER_LINK")
          .set("COUNT", tr_count(all.size() - first, "{findings} more finding",
                                 "{findings} more findings", {{"findings", all.size() - first}}));
    }
  }
  if (all.size() <= first && view.next_steps.empty()) return;
  values.add_section("HAS_FINDINGS");
  engine::TemplateValues& section = values.add_include("FURTHER_FINDINGS", "findings.tpl");
  std::vector<const Finding*> notes;
  engine::TemplateValues* list = nullptr;
  for (std::size_t k = first; k < all.size(); ++k) {
    if (all[k].is_note) {
      notes.push_back(&all[k]);
      continue;
    }
    if (list == nullptr) list = &section.add_section("FINDINGS");
    fill_finding(all[k], "FINDING", *list);
  }
  if (!notes.empty()) {
    engine::TemplateValues& folded = section.add_section("NOTES");
    folded.set("COUNT", tr_count(notes.size(), "{notes} note that lowers no verdict",
                                 "{notes} notes that lower no verdict", {{"notes", notes.size()}}));
    for (const Finding* note : notes) fill_finding(*note, "FINDING", folded);
  }
  if (view.next_steps.empty()) return;
  engine::TemplateValues& steps = section.add_section("STEPS");
  for (const NextStep& step : view.next_steps) {
    engine::TemplateValues& item = steps.add_section("STEP");
    item.set("TEXT", step.text);
    item.set("QUANTITIES", fmt::format("{}", fmt::join(step.quantities, ", ")));
  }
}

void fill_conversions(const std::vector<Table>& tables, engine::TemplateValues& values) {
  const bool is_empty = std::all_of(tables.begin(), tables.end(),
                                    [](const Table& table) { return table.rows.empty(); });
  if (is_empty) return;
  values.add_section("HAS_CONVERSIONS");
  engine::TemplateValues& out = values.add_include("CONVERSIONS", "conversions.tpl");
  for (const Table& table : tables) elements::fill_table(table, "TABLE", out);
}

}  // namespace

void fill_report(const ReportView& view, bool has_viewer, engine::TemplateValues& values) {
  values.set("DOCUMENT_TITLE", view.title);
  values.set("REPORT_NUMBER", view.number);
  values.set("CREATED", view.created_utc);
  values.set("TOOL", view.tool);
  if (!view.note.empty())
    elements::fill_lines(view.note, "NOTE_LINE", "TEXT", values.add_section("NOTE"));
  fill_contents(view, values);

  engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  verdict.set("WORD", view.verdict_word);
  const bool has_sentence = !view.verdict_sentence.empty();
  verdict.set("SENTENCE",
              has_sentence ? view.verdict_sentence : wording::or_dash(view.verdict_rows));
  if (has_sentence) verdict.set_optional("ROWS", view.verdict_rows);
  elements::fill_outcome(view.verdict, verdict);
  verdict.set_optional("FIGURES_MISSING", view.figures_missing);
  fill_findings(view, verdict, values);

  fill_quantities(view, values);
  fill_next_experiment(view, values);
  fill_friction_speeds(view.friction_speeds, values);
  if (view.log) fill_log(*view.log, values);
  fill_pictures(view.pictures, values);
  fill_terms(view, values);
  fill_data_checks(view, values);
  fill_conversions(view.conversion_tables, values);
  elements::fill_table(view.key_numbers, "KEY_NUMBERS", values);
  fill_budget(view.budget, values);
  for (const Section& section : view.sections) fill_section(section, has_viewer, values);
  fill_provenance(view.command_line, view.created_utc, view.notes, view.provenance_tables, values);
}

}  // namespace tribolog::report::document
