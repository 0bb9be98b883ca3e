#include "report/verdict_values.h"

#include <algorithm>

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

}  // namespace

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
