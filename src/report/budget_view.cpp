// What each quantity's uncertainty is made of.

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/view_parts.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report {

namespace {

using calibration::BudgetPart;
using calibration::Influence;
using calibration::UncertaintyBudget;
using wording::tr;

std::string name_of(Influence influence) {
  return wording::words_for("influence", to_string(influence));
}

/// "torque constant 97 % (B), the recordings 3 % (A)"
std::string largest_parts(const UncertaintyBudget& budget) {
  constexpr std::size_t shown = 3;
  std::vector<std::string> parts;
  for (const BudgetPart& part : budget.parts) {
    if (parts.size() == shown || !(part.share > 0)) break;
    const std::string share = part.share < 0.01 ? "< 1" : wording::fixed(100 * part.share, 0);
    parts.push_back(tr("{influence} {share} ({type})", {{"influence", name_of(part.influence)},
                                                        {"share", wording::with_unit(share, "%")},
                                                        {"type", part.is_type_b ? "B" : "A"}}));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string not_included(const UncertaintyBudget& budget) {
  std::vector<std::string> names;
  for (const Influence influence : budget.not_stated) names.push_back(name_of(influence));
  return or_dash(fmt::format("{}", fmt::join(names, ", ")));
}

}  // namespace

Table budget_table(const calibration::Judgement& judgement) {
  Table table;
  table.id = "table-budget";
  table.caption = tr("Uncertainty budgets");
  table.columns = {{tr("Quantity"), "", false, true},
                   {tr("Standard uncertainty u"), "", true},
                   {tr("Degrees of freedom"), "", true},
                   {tr("Coverage factor k"), "", true},
                   {tr("Expanded, 95 %"), "", true},
                   {tr("Largest parts of u²"), "", false, true},
                   {tr("Not stated, not included"), "", false, true}};
  table.is_stacked = true;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    if (!q.budget || q.verdict == calibration::Verdict::not_identifiable) continue;
    const UncertaintyBudget& budget = *q.budget;
    const wording::Scale scale = wording::quantity_scale(q.unit, q.estimate->value);
    constexpr int digits = 2;
    table.rows.push_back(
        {{wording::capitalised(wording::words_for("quantity", to_string(q.quantity))),
          wording::with_unit(
              wording::significant(budget.standard_uncertainty * scale.factor, digits), scale.unit),
          std::isinf(budget.freedom) ? "∞" : wording::fixed(budget.freedom, 1),
          wording::fixed(budget.coverage_factor, 2),
          "± " + wording::with_unit(
                     wording::significant(budget.expanded.half_width() * scale.factor, digits),
                     scale.unit),
          or_dash(largest_parts(budget)), not_included(budget)},
         false});
  }
  table.note = tr(
      "At the motor, after JCGM 100 (GUM). Type A: from the recordings, with noise, ripple and the "
      "choice of the model. Type B: from the manifest's [uncertainty]. Degrees of freedom by "
      "Welch and Satterthwaite; ∞ where the stage does not state them.");
  return table;
}

}  // namespace tribolog::report
