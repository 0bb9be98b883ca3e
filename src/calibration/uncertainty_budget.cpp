#include "calibration/uncertainty_budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/enum_text.h"
#include "statistics/distributions.h"

namespace tribolog::calibration {

namespace {

constexpr double well_known = std::numeric_limits<double>::infinity();

double square(double x) { return x * x; }

}  // namespace

std::string to_string(Influence influence) { return own_name(influence); }

std::optional<Influence> influence_of(const std::string& word) {
  return own_names<Influence>.find(word);
}

double coverage_factor(double freedom) {
  return std::isinf(freedom) ? statistics::normal_975
                             : statistics::student_t_975(std::max(1.0, freedom));
}

UncertaintyBudget combined(const statistics::Estimate& estimate, std::vector<BudgetPart> parts,
                           std::vector<Influence> not_stated) {
  UncertaintyBudget out;
  double type_a = 0;
  double type_b = 0;
  double freedom_a = well_known;
  for (const BudgetPart& part : parts) {
    (part.is_type_b ? type_b : type_a) += square(part.standard_uncertainty);
    if (!part.is_type_b) freedom_a = part.freedom;
  }
  const double variance = type_a + type_b;
  for (BudgetPart& part : parts) {
    part.share = variance > 0 ? square(part.standard_uncertainty) / variance : 0;
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  out.parts = std::move(parts);
  out.not_stated = std::move(not_stated);
  out.standard_uncertainty = std::sqrt(variance);
  const bool is_well_known = std::isinf(freedom_a) || !(type_a > 0);
  out.freedom = is_well_known ? well_known : freedom_a * square(variance / type_a);
  out.coverage_factor = coverage_factor(out.freedom);
  out.expanded = estimate;
  if (!(type_b > 0)) return out;
  // Each side by itself: an interval need not be symmetric.
  const double factor_a = coverage_factor(freedom_a);
  const auto side = [&](double half_width) {
    return out.coverage_factor * std::hypot(half_width / factor_a, std::sqrt(type_b));
  };
  out.expanded.low = estimate.value - side(estimate.value - estimate.low);
  out.expanded.high = estimate.value + side(estimate.high - estimate.value);
  out.expanded.method = {"interval.with_type_b", {{"interval", estimate.method}}};
  return out;
}

UncertaintyBudget budget_at(const UncertaintyBudget& budget, const statistics::Estimate& estimate,
                            int gear_power) {
  std::vector<BudgetPart> parts = budget.parts;
  for (BudgetPart& part : parts) {
    if (part.influence != Influence::gear_ratio) continue;
    part.standard_uncertainty = std::abs((part.sensitivity + gear_power) * estimate.value) *
                                part.stated.value_or(0) / 100 / coverage_factor(well_known);
  }
  return combined(estimate, std::move(parts), budget.not_stated);
}

statistics::Estimate expanded_at(const UncertaintyBudget& budget,
                                 const statistics::Estimate& estimate, int gear_power) {
  return budget_at(budget, estimate, gear_power).expanded;
}

}  // namespace tribolog::calibration
