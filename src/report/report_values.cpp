#include "report/report_values.h"

#include <sstream>

#include "report/element_values.h"
#include "report/view_parts.h"

namespace tribolog::report {
namespace {

void fill_section(const Section& section, TemplateValues& values) {
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

/// The operator's note, line by line.
void fill_note(const std::string& note, TemplateValues& values) {
  if (note.empty()) return;
  TemplateValues& out = values.add_section("NOTE");
  std::istringstream lines(note);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty()) out.add_section("NOTE_LINE").set("TEXT", line);
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

void fill_errata(const ReportView& view, TemplateValues& values) {
  TemplateValues& out = values.add_include("ERRATA", "errata.tpl");
  const ErrataNumbers& e = view.errata;
  out.set("TORQUE_A", e.torque_A);
  out.set("MASS_A_PRINTED", e.mass_A_printed);
  out.set("MASS_A_500_MM", e.mass_A_with_500_mm);
  out.set("MASS_A_500_M", e.mass_A_with_500_m);
  out.set("MASS_A_N_BELOW", e.mass_A_with_n_below);
  out.set("MASS_A_ARM_N_BELOW", e.mass_A_arm_torque_with_n_below);
  out.set("LARGEST_DEVIATION", e.largest_deviation);
  out.set("ALLOWED_DEVIATION", e.allowed_deviation);
  out.set("COS_Q_C", e.cos_q_c);
  out.set("MASS_A_COS_Q_C", e.mass_A_with_cos_q_c);
  out.set("RAD_OF_22", e.rad_of_22);
  out.set("RAD_OF_PRECISE", e.rad_of_precise);
  out.set("CUT_OF_22", e.cut_of_22);
  out.set("CUT_OF_PRECISE", e.cut_of_precise);
  out.set("DEFLECTION_PRINTED", e.table_1_deflection_printed);
  out.set("DEFLECTION_MEANT", e.table_1_deflection_meant);
  out.set("DAMPING_MEANT", e.table_1_damping);
  out.set("PAIR_MASSES", e.pair_masses);
  out.set("PAIR_SPREAD", e.pair_spread);
  out.set("SINGLE_SPREAD", e.single_spread);
  // The paper's own joint has the table, with its own masses beside it, in stage 4.
  bool is_in_stage_4 = false;
  for (const Section& section : view.sections) {
    for (const Table& table : section.tables) is_in_stage_4 |= table.id == view.paper_table.id;
  }
  if (is_in_stage_4) {
    out.add_section("TABLE_ABOVE");
  } else {
    fill_table(view.paper_table, "TABLE", out);
  }
}

}  // namespace

void fill_report(const ReportView& view, TemplateValues& values) {
  values.set("DOCUMENT_TITLE", view.title);
  values.set("SUBTITLE", view.subtitle);
  values.set("CREATED", view.created_utc);
  values.set("TOOL", view.tool);
  fill_facts(view.identity, values);
  fill_note(view.note, values);
  fill_contents(view, values);

  TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  verdict.set("WORD", view.verdict_word);
  verdict.set("SENTENCE", view.verdict_sentence);
  fill_outcome(view.verdict, verdict);
  verdict.set_optional("FIGURES_MISSING", view.figures_missing);
  if (!view.findings.empty()) {
    TemplateValues& findings = verdict.add_section("FINDINGS");
    for (const std::string& finding : view.findings) {
      findings.add_section("FINDING").set("TEXT", or_dash(finding));
    }
  }

  fill_table(view.key_numbers, "KEY_NUMBERS", values);
  fill_missing(view.missing, values);
  if (!view.missing.empty()) values.add_section("HAS_MISSING");
  for (const Section& section : view.sections) fill_section(section, values);
  fill_errata(view, values);

  TemplateValues& provenance = values.add_include("PROVENANCE", "provenance.tpl");
  provenance.set("COMMAND_LINE", view.command_line);
  provenance.set("CREATED", view.created_utc);
  if (!view.notes.empty()) {
    TemplateValues& notes = provenance.add_section("INPUT_NOTES");
    for (const std::string& note : view.notes)
      notes.add_section("INPUT_NOTE").set("TEXT", or_dash(note));
  }
  for (const Table& table : view.provenance_tables) fill_table(table, "TABLE", provenance);
}

}  // namespace tribolog::report
