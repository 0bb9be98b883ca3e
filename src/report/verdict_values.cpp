#include "report/verdict_values.h"

#include "report/element_values.h"
#include "report/view_parts.h"

namespace tribolog::report {
namespace {

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
  further.set("COUNT", std::to_string(count) + (count == 1 ? " more reason" : " more reasons"));
  for (std::size_t k = 1; k < reasons.size(); ++k) {
    further.add_section("REASON").set("TEXT", reasons[k]);
  }
}

}  // namespace

void fill_quantities(const std::vector<QuantityRow>& rows, TemplateValues& values) {
  if (rows.empty()) return;
  values.add_section("HAS_QUANTITIES");
  TemplateValues& table = values.add_include("QUANTITIES", "quantities.tpl");
  for (const QuantityRow& row : rows) {
    TemplateValues& out = table.add_section("QUANTITY");
    out.set("WORDS", row.words);
    out.set("VERDICT", row.verdict_word);
    fill_state(row.outcome, out);
    out.set("ESTIMATE", or_dash(row.estimate));
    fill_reasons(row.reasons, out);
    for (const std::string& limit : row.limits) out.add_section("LIMIT").set("TEXT", limit);
    out.set_optional("EXPERIMENT", row.experiment);
    if (row.reasons.empty() && row.limits.empty()) out.add_section("FINE");
  }
}

void fill_data_checks(const std::vector<DataCheckRow>& rows, TemplateValues& values) {
  if (rows.empty()) return;
  values.add_section("HAS_DATA_CHECKS");
  TemplateValues& table = values.add_include("DATA_CHECKS", "data_checks.tpl");
  for (const DataCheckRow& row : rows) {
    TemplateValues& out = table.add_section("CHECK");
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
}

}  // namespace tribolog::report
