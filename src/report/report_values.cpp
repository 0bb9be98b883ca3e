#include "report/report_values.h"

#include <algorithm>

#include "report/closing_values.h"
#include "report/element_values.h"
#include "report/verdict_values.h"
#include "report/view_parts.h"

namespace tribolog::report {
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
  further.set("COUNT", std::to_string(others) + (others == 1 ? " more finding" : " more findings"));
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
  fill_data_checks(view.data_checks, values);
  fill_conversions(view.conversion_tables, values);
  fill_table(view.key_numbers, "KEY_NUMBERS", values);
  fill_missing(view.missing, values);
  if (!view.missing.empty()) values.add_section("HAS_MISSING");
  for (const Section& section : view.sections) fill_section(section, has_viewer, values);
  // The paper's own joint has the table, with its own masses beside it, in stage 4.
  bool is_in_stage_4 = false;
  for (const Section& section : view.sections) {
    for (const Table& table : section.tables) is_in_stage_4 |= table.id == view.paper_table.id;
  }
  if (is_in_stage_4) {
    fill_errata(view.errata, "stage 4", values);
  } else {
    fill_errata(view.errata, view.paper_table, values);
  }
  fill_provenance(view.command_line, view.created_utc, view.notes, view.provenance_tables, values);
}

}  // namespace tribolog::report
