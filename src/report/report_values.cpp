#include "report/report_values.h"

#include <algorithm>
#include <vector>

#include "report/element_values.h"
#include "report/report_view.h"
#include "report/template_engine.h"
#include "report/view_parts.h"
#include "wording/tr.h"

namespace tribolog::report {

// The values of quantities.tpl and data_checks.tpl.

namespace {

using wording::tr_count;

/// Nothing where there are none.
void fill_quantities(const ReportView& view, TemplateValues& values);
void fill_data_checks(const ReportView& view, TemplateValues& values);

/// Beside the word and the colour.
const char* icon_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::good:
      return "✓";
    case Outcome::partial:
      return "!";
    case Outcome::bad:
      return "✗";
    case Outcome::absent:
      break;
  }
  return "–";
}

void fill_state(Outcome outcome, TemplateValues& values) {
  values.set("OUTCOME", class_of(outcome));
  values.set("ICON", icon_of(outcome));
}

/// The weightiest in sight, the others behind a click.
void fill_reasons(const std::vector<std::string>& reasons, TemplateValues& values) {
  if (reasons.empty()) return;
  values.add_section("REASON").set("TEXT", reasons.front());
  if (reasons.size() == 1) return;
  TemplateValues& further = values.add_section("FURTHER");
  const std::size_t count = reasons.size() - 1;
  further.set("COUNT", tr_count(count, "{reasons} more reason", "{reasons} more reasons",
                                {{"reasons", count}}));
  for (std::size_t k = 1; k < reasons.size(); ++k) {
    further.add_section("REASON").set("TEXT", reasons[k]);
  }
}

/// Columns that nothing stands in are not shown.
struct ShownColumns {
  bool limits{};
  bool changes{};
  [[nodiscard]] int count() const { return 4 + (limits ? 1 : 0) + (changes ? 1 : 0); }
};

void fill_row(const QuantityRow& row, ShownColumns shown, TemplateValues& out) {
  out.set("WORDS", row.words);
  out.set("VERDICT", row.verdict_word);
  fill_state(row.outcome, out);
  out.set("ESTIMATE", or_dash(row.estimate));
  out.set("INTERVAL", or_dash(row.interval));
  if (row.estimate.empty()) out.add_section("NO_ESTIMATE");
  if (row.interval.empty()) out.add_section("NO_INTERVAL");
  if (shown.limits) {
    TemplateValues& cell = out.add_section("LIMITS");
    for (const LimitCell& limit : row.limits) {
      TemplateValues& line = cell.add_section("LIMIT");
      line.set("RULE", limit.rule);
      line.set("WORD", limit.word);
      fill_state(limit.outcome, line);
    }
    if (row.limits.empty()) cell.add_section("NONE");
  }
  if (shown.changes) {
    TemplateValues& cell = out.add_section("CHANGE");
    cell.set("AMOUNT", or_dash(row.change));
    cell.set_optional("WORD", row.change_word);
    cell.set_optional("RANGE", row.change_range);
    cell.set("KIND", row.is_changed ? "changed" : row.change_word.empty() ? "none" : "unchanged");
  }
  if (row.reasons.empty() && row.experiment.empty()) return;
  TemplateValues& why = out.add_section("WHY");
  why.set("COLUMNS", std::to_string(shown.count()));
  fill_reasons(row.reasons, why);
  why.set_optional("EXPERIMENT", row.experiment);
}

void fill_quantities(const ReportView& view, TemplateValues& values) {
  const std::vector<QuantityRow>& rows = view.quantities;
  if (rows.empty()) return;
  values.add_section("HAS_QUANTITIES");
  TemplateValues& table = values.add_include("QUANTITIES", "quantities.tpl");
  const bool has_limits = std::any_of(rows.begin(), rows.end(),
                                      [](const QuantityRow& row) { return !row.limits.empty(); });
  const ShownColumns shown{has_limits, !view.last_day.empty()};
  table.add_section(shown.limits ? "LIMITS_HEAD" : "NO_LIMITS");
  TemplateValues& since = table.add_section(shown.changes ? "CHANGES_HEAD" : "NO_CHANGES");
  if (shown.changes) {
    since.set("DAY", view.last_day);
    TemplateValues& note = table.add_section("CHANGES_NOTE");
    note.set("DAY", view.last_day);
    note.set("ID", view.last_id);
  }
  for (const QuantityRow& row : rows) fill_row(row, shown, table.add_section("QUANTITY"));
}

void fill_check(const DataCheckRow& row, TemplateValues& out) {
  out.set("CHECK_ID", row.id);
  out.set("TITLE", row.title);
  out.set_optional("MEASURE", row.measure);
  out.set("STATE", row.state_word);
  fill_state(row.outcome, out);
  out.set("MEASURED", or_dash(row.measured));
  out.set("LIMIT", or_dash(row.limit));
  out.set("FOUND", or_dash(row.found));
  out.set_optional("CONSEQUENCE", row.consequence);
  out.set_optional("EXPERIMENT", row.experiment);
  out.set_optional("RECORDING", row.recording);
}

void fill_data_checks(const ReportView& view, TemplateValues& values) {
  if (view.data_checks.empty()) return;
  values.add_section("HAS_DATA_CHECKS");
  TemplateValues& table = values.add_include("DATA_CHECKS", "data_checks.tpl");
  for (const DataCheckRow& row : view.data_checks) fill_check(row, table.add_section("CHECK"));
  if (view.rules.empty()) return;
  TemplateValues& rules = table.add_section("HAS_RULES");
  for (const DataCheckRow& row : view.rules) fill_check(row, rules.add_section("RULE"));
}

}  // namespace

void fill_provenance(const std::string& command_line, const std::string& created_utc,
                     const std::vector<std::string>& notes, const std::vector<Table>& tables,
                     TemplateValues& values) {
  TemplateValues& out = values.add_include("PROVENANCE", "provenance.tpl");
  out.set("COMMAND_LINE", command_line);
  out.set("CREATED", created_utc);
  if (!notes.empty()) {
    TemplateValues& list = out.add_section("INPUT_NOTES");
    for (const std::string& note : notes) list.add_section("INPUT_NOTE").set("TEXT", or_dash(note));
  }
  for (const Table& table : tables) fill_table(table, "TABLE", out);
}

namespace {

void fill_section(const Section& section, bool has_viewer, TemplateValues& values) {
  TemplateValues& out = values.add_include("STAGE", "stage.tpl");
  out.set("SECTION_ID", section.id);
  out.set("NUMBER", std::to_string(section.number));
  out.set("TITLE", section.title);
  out.set("STATUS", section.status);
  fill_outcome(section.outcome, out);
  out.add_include("EXPLANATION", section.explanation);
  out.set_optional("REASON", section.reason);
  out.set_optional("EXPERIMENT", section.experiment);
  fill_facts(section.facts, out);
  if (has_viewer && section.id == section_anchor(StageId::hysteresis)) {
    out.add_include("REVIEW", "review.tpl");
  }
  for (const FigureCard& figure : section.figures) fill_figure(figure, out);
  for (const Table& table : section.tables) fill_table(table, "TABLE", out);
}

void fill_contents(const ReportView& view, TemplateValues& values) {
  for (const Section& section : view.sections) {
    TemplateValues& entry = values.add_section("CONTENTS_ENTRY");
    entry.set("SECTION_ID", section.id);
    entry.set("NUMBER", std::to_string(section.number));
    entry.set("TITLE", section.title);
    entry.set("STATUS", section.status);
    entry.set("OUTCOME", class_of(section.outcome));
  }
}

/// The weightiest in sight, the others behind a click.
void fill_findings(const std::vector<std::string>& findings, TemplateValues& verdict) {
  constexpr std::size_t in_sight = findings_in_sight;
  if (findings.empty()) return;
  TemplateValues& first = verdict.add_section("FINDINGS");
  for (std::size_t k = 0; k < std::min(in_sight, findings.size()); ++k) {
    first.add_section("FINDING").set("TEXT", or_dash(findings[k]));
  }
  if (findings.size() <= in_sight) return;
  const std::size_t others = findings.size() - in_sight;
  TemplateValues& further = verdict.add_section("FURTHER");
  further.set("COUNT", tr_count(others, "{findings} more finding", "{findings} more findings",
                                {{"findings", others}}));
  for (std::size_t k = in_sight; k < findings.size(); ++k) {
    further.add_section("FINDING").set("TEXT", or_dash(findings[k]));
  }
}

void fill_missing(const std::vector<MissingResult>& missing, TemplateValues& values) {
  if (missing.empty()) return;
  TemplateValues& list = values.add_include("MISSING", "missing.tpl");
  for (const MissingResult& result : missing) {
    TemplateValues& item = list.add_section("ITEM");
    item.set("STAGE_NAME", result.stage);
    item.set("SECTION_ID", result.section_id);
    item.set("REASON", result.reason);
    item.set_optional("EXPERIMENT", result.experiment);
  }
}

void fill_conversions(const std::vector<Table>& tables, TemplateValues& values) {
  const bool is_empty = std::all_of(tables.begin(), tables.end(),
                                    [](const Table& table) { return table.rows.empty(); });
  if (is_empty) return;
  values.add_section("HAS_CONVERSIONS");
  TemplateValues& out = values.add_include("CONVERSIONS", "conversions.tpl");
  for (const Table& table : tables) fill_table(table, "TABLE", out);
}

}  // namespace

void fill_report(const ReportView& view, bool has_viewer, TemplateValues& values) {
  values.set("DOCUMENT_TITLE", view.title);
  values.set("SUBTITLE", view.subtitle);
  values.set("CREATED", view.created_utc);
  values.set("TOOL", view.tool);
  fill_facts(view.identity, values);
  if (!view.note.empty()) fill_lines(view.note, "NOTE_LINE", "TEXT", values.add_section("NOTE"));
  fill_contents(view, values);

  TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  verdict.set("WORD", view.verdict_word);
  verdict.set("SENTENCE", view.verdict_sentence);
  fill_outcome(view.verdict, verdict);
  verdict.set_optional("FIGURES_MISSING", view.figures_missing);
  fill_findings(view.findings, verdict);

  fill_quantities(view, values);
  fill_data_checks(view, values);
  fill_conversions(view.conversion_tables, values);
  fill_table(view.key_numbers, "KEY_NUMBERS", values);
  fill_table(view.budget, "BUDGET", values);
  fill_missing(view.missing, values);
  if (!view.missing.empty()) values.add_section("HAS_MISSING");
  for (const Section& section : view.sections) fill_section(section, has_viewer, values);
  fill_provenance(view.command_line, view.created_utc, view.notes, view.provenance_tables, values);
}

}  // namespace tribolog::report
