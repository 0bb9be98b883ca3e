// What each quantity's uncertainty is made of.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using calibration::BudgetPart;
using calibration::Influence;
using calibration::UncertaintyBudget;
using wording::tr;

std::string name_of(Influence influence) {
  return wording::words_for("influence", to_string(influence));
}

/// "hoses and cables, typical 0.1 %: 60 %"
std::string effect_in_words(const calibration::BudgetEffect& one) {
  const std::string name = wording::words_for("effect", one.effect);
  const std::string share = elements::share_in_words(one.share);
  if (one.unit.empty()) return tr("{effect}: {share}", {{"effect", name}, {"share", share}});
  const std::string unit = one.unit == "percent" ? "%" : one.unit;
  constexpr int digits = 2;
  const std::string size = wording::with_unit(wording::significant(one.size, digits), unit);
  return one.is_stated ? tr("{effect}, stated {size}: {share}",
                            {{"effect", name}, {"size", size}, {"share", share}})
                       : tr("{effect}, typical {size}: {share}",
                            {{"effect", name}, {"size", size}, {"share", share}});
}

/// Of the variance that the recordings leave, the largest first; empty: no model states it.
std::string effects_in_words(const UncertaintyBudget& budget) {
  constexpr std::size_t most = 3;
  std::vector<std::string> words;
  for (const calibration::BudgetEffect& one : budget.effects) {
    if (words.size() < most) words.push_back(effect_in_words(one));
  }
  return fmt::format("{}", fmt::join(words, "; "));
}

}  // namespace

std::string largest_part(const calibration::QuantityVerdict& q) {
  if (!q.budget || q.budget->parts.empty() || !(q.budget->parts.front().share > 0)) return "";
  const BudgetPart& part = q.budget->parts.front();
  return tr("{influence} {share}", {{"influence", name_of(part.influence)},
                                    {"share", elements::share_in_words(part.share)}});
}

const UncertaintyBudget* stated_budget(const calibration::QuantityVerdict& q) {
  if (q.verdict == calibration::Verdict::not_identifiable) return nullptr;
  return q.budget ? &*q.budget : nullptr;
}

std::vector<BudgetRow> budget_rows(const calibration::Judgement& judgement) {
  std::vector<BudgetRow> rows;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    const UncertaintyBudget* const stated = stated_budget(q);
    if (stated == nullptr) continue;
    const UncertaintyBudget& budget = *stated;
    const wording::Scale scale = wording::quantity_scale(q.unit, q.estimate->value);
    const auto in_unit = [&](double value) {
      constexpr int digits = 2;
      return wording::with_unit(wording::significant(value * scale.factor, digits), scale.unit);
    };
    BudgetRow row;
    row.quantity = wording::words_for("quantity", to_string(q.quantity));
    row.standard = in_unit(budget.standard_uncertainty);
    row.freedom = std::isinf(budget.freedom) ? "∞" : wording::fixed(budget.freedom, 1);
    row.coverage = wording::fixed(budget.coverage_factor, 2);
    row.expanded = "± " + in_unit(budget.expanded.half_width());
    double from = 0;
    for (const BudgetPart& part : budget.parts) {
      if (!(part.share > 0)) continue;
      BudgetRow::Part shown;
      shown.name =
          tr("{influence} {share} ({type})", {{"influence", name_of(part.influence)},
                                              {"share", elements::share_in_words(part.share)},
                                              {"type", part.is_type_b ? "B" : "A"}});
      shown.kind = to_string(part.influence);
      std::replace(shown.kind.begin(), shown.kind.end(), '_', '-');
      shown.from_percent = from;
      shown.percent = 100 * part.share;
      from += shown.percent;
      row.parts.push_back(std::move(shown));
    }
    row.effects = effects_in_words(budget);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tribolog::report::document
