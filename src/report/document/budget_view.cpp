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

/// In the unit in which the quantity is shown.
std::string width_in_words(double width, const calibration::QuantityVerdict& q) {
  const wording::Scale scale = wording::quantity_scale(q.unit, q.estimate->value);
  constexpr int digits = 2;
  return wording::with_unit(wording::significant(width * scale.factor, digits), scale.unit);
}

/// "hoses and cables, typical 0.1 %"
std::string size_in_words(const calibration::BudgetEffect& one) {
  const std::string name = wording::words_for("effect", one.effect);
  if (one.unit.empty()) return name;
  constexpr int digits = 2;
  const std::string size = wording::with_unit(wording::significant(one.size, digits),
                                              one.unit == "percent" ? "%" : one.unit);
  return one.is_stated ? tr("{effect}, stated {size}", {{"effect", name}, {"size", size}})
                       : tr("{effect}, typical {size}", {{"effect", name}, {"size", size}});
}

/// "hoses and cables, typical 0.1 %: 60 %"
std::string effect_in_words(const calibration::BudgetEffect& one) {
  return tr("{effect}: {share}",
            {{"effect", size_in_words(one)}, {"share", elements::share_in_words(one.share)}});
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

double share_of_recordings(const UncertaintyBudget& budget) {
  const auto found =
      std::find_if(budget.parts.begin(), budget.parts.end(),
                   [](const BudgetPart& p) { return p.influence == Influence::recordings; });
  return found == budget.parts.end() ? 0 : found->share;
}

/// "Coulomb torque ± 0.01 N·m instead of ± 0.02 N·m", without that share of u².
std::string width_without(double share, const calibration::QuantityVerdict& q,
                          const UncertaintyBudget& budget) {
  const double half_width = budget.expanded.half_width();
  return tr("{quantity} ± {without} instead of ± {half_width}",
            {{"quantity", name_within_a_sentence(q.quantity)},
             {"without", width_in_words(half_width * std::sqrt(std::max(0.0, 1 - share)), q)},
             {"half_width", width_in_words(half_width, q)}});
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

std::string limiting_effect(const calibration::Judgement& judgement) {
  struct Limiting {
    calibration::BudgetEffect effect;
    double share{};                   ///< Of the variances of all quantities.
    std::vector<std::string> widths;  ///< Of those that it makes much wider.
  };
  constexpr double least_share_told = 0.25;
  constexpr std::size_t most_told = 2;
  std::vector<Limiting> all;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    const UncertaintyBudget* const budget = stated_budget(q);
    if (budget == nullptr || !q.decides) continue;
    for (const calibration::BudgetEffect& one : budget->effects) {
      if (one.is_stated || one.unit.empty()) continue;
      auto at = std::find_if(all.begin(), all.end(), [&](const Limiting& other) {
        return other.effect.effect == one.effect;
      });
      if (at == all.end()) at = all.insert(all.end(), Limiting{one, 0, {}});
      const double share = one.share * share_of_recordings(*budget);
      at->share += share;
      if (share < least_share_told || at->widths.size() == most_told) continue;
      at->widths.push_back(width_without(share, q, *budget));
    }
  }
  const auto most =
      std::max_element(all.begin(), all.end(),
                       [](const Limiting& a, const Limiting& b) { return a.share < b.share; });
  if (most == all.end() || most->widths.empty()) return "";
  return tr("{effect}. Without it: {widths}. Where it is known, state {key} under [effects].",
            {{"effect", wording::capitalised(size_in_words(most->effect))},
             {"widths", fmt::format("{}", fmt::join(most->widths, ", "))},
             {"key", most->effect.effect + "_" + most->effect.unit}});
}

std::vector<BudgetRow> budget_rows(const calibration::Judgement& judgement) {
  std::vector<BudgetRow> rows;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    const UncertaintyBudget* const stated = stated_budget(q);
    if (stated == nullptr) continue;
    const UncertaintyBudget& budget = *stated;
    BudgetRow row;
    row.quantity = wording::words_for("quantity", to_string(q.quantity));
    row.standard = width_in_words(budget.standard_uncertainty, q);
    row.freedom = std::isinf(budget.freedom) ? "∞" : wording::fixed(budget.freedom, 1);
    row.coverage = wording::fixed(budget.coverage_factor, 2);
    row.expanded = "± " + width_in_words(budget.expanded.half_width(), q);
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
