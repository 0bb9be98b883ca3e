#include "report/comparison_page.h"

#include <fmt/format.h>

#include "history/comparison_json.h"
#include "report/comparison_view.h"
#include "report/element_values.h"
#include "report/page_style.h"
#include "report/view_parts.h"

namespace tribolog {
namespace {

using namespace report;
using history::ChangeWord;
using history::Comparison;

void fill_verdict(const Comparison& c, TemplateValues& values) {
  TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const std::size_t changed = c.count(ChangeWord::changed);
  const std::size_t same = c.count(ChangeWord::no_change_seen);
  const std::size_t others = c.count(ChangeWord::not_comparable);
  const Outcome outcome = same + changed == 0         ? Outcome::absent
                          : changed > 0 || others > 0 ? Outcome::partial
                                                      : Outcome::good;
  verdict.set("WORD", changed > 0 ? "CHANGED" : same > 0 ? "NO CHANGE SEEN" : "NOT COMPARABLE");
  verdict.set("SENTENCE", comparison_sentence(c));
  fill_outcome(outcome, verdict);
  const std::vector<std::string> notes = comparison_notes(c);
  if (notes.empty()) return;
  TemplateValues& findings = verdict.add_section("FINDINGS");
  for (const std::string& note : notes) findings.add_section("FINDING").set("TEXT", note);
}

}  // namespace

std::string comparison_page(const Comparison& comparison, const Provenance& provenance,
                            const std::string& curves_missing,
                            const std::vector<ReportFigure>& figures,
                            const std::vector<render::DrawnFigure>& drawn, Language language) {
  TemplateValues values;
  fill_head(provenance, values);
  const archive::JointName& of = comparison.first.facts.of;
  values.set("TITLE", fmt::format("{}, joint {}", or_dash(of.robot), or_dash(of.joint)));
  fill_verdict(comparison, values);
  fill_table(compared_quantities_table(comparison), "CHANGES", values);
  fill_table(compared_conditions_table(comparison), "CONDITIONS", values);
  for (const FigureCard& card : figure_cards(figures, drawn)) fill_figure(card, values);
  values.set_optional("CURVES_MISSING", curves_missing);
  values.set_checked_by_modifier("RESULT_JSON", history::comparison_json(comparison));
  return expand_template("diff.tpl", values, language);
}

}  // namespace tribolog
