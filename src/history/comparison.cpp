#include "history/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "base/error.h"
#include "history/quantity_traits.h"
#include "statistics/distributions.h"

namespace tribolog::history {

namespace {

double chance_of(double change, double side_toward_zero) {
  if (change == 0) return 1;
  if (!(side_toward_zero > 0)) return 0;
  return std::erfc(std::abs(change) / (side_toward_zero / statistics::normal_975) /
                   std::numbers::sqrt2);
}

}  // namespace

Change change_between(const statistics::Estimate& first, const statistics::Estimate& second,
                      bool is_angle, double further_half_width) {
  double change = second.value - first.value;
  if (is_angle) change = std::remainder(change, 2 * std::numbers::pi);
  const double below =
      std::hypot(second.value - second.low, first.high - first.value, further_half_width);
  const double above =
      std::hypot(second.high - second.value, first.value - first.low, further_half_width);
  Change made;
  made.absolute = {change, change - below, change + above, {"interval.in_quadrature"}};
  made.chance = chance_of(change, change > 0 ? below : above);
  const bool is_near_zero = first.value == 0 || (first.low <= 0 && first.high >= 0);
  if (!is_angle && !is_near_zero) {
    made.percent = statistics::scaled(made.absolute, 100 / std::abs(first.value));
  }
  return made;
}

std::vector<double> holm_adjusted(const std::vector<double>& chances) {
  std::vector<std::size_t> order(chances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return chances[a] < chances[b]; });
  std::vector<double> adjusted(chances.size());
  double largest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto left = static_cast<double>(chances.size() - k);
    largest = std::max(largest, std::min(1.0, left * chances[order[k]]));
    adjusted[order[k]] = largest;
  }
  return adjusted;
}

namespace {

Statement payload_statement(const calibration::Facts& f) {
  const double kg = f.payload_kg.value_or(0);
  const double metres = f.payload_distance_m.value_or(0);
  if (f.payload.empty() && !f.payload_kg) {
    if (!f.payload_distance_m) return {"payload.none_stated"};
    return {"payload.distance", {{"distance_m", metres}}};
  }
  if (f.payload.empty()) {
    if (!f.payload_distance_m) return {"payload.mass", {{"mass_kg", kg}}};
    return {"payload.mass_at_distance", {{"mass_kg", kg}, {"distance_m", metres}}};
  }
  if (!f.payload_kg) {
    if (!f.payload_distance_m) return {"payload.named", {{"payload", f.payload}}};
    return {"payload.named_at_distance", {{"payload", f.payload}, {"distance_m", metres}}};
  }
  if (!f.payload_distance_m) {
    return {"payload.named_mass", {{"payload", f.payload}, {"mass_kg", kg}}};
  }
  return {"payload.named_mass_at_distance",
          {{"payload", f.payload}, {"mass_kg", kg}, {"distance_m", metres}}};
}

void judge_temperature(const calibration::Facts& a, const calibration::Facts& b,
                       const AllowedDifference& allowed, ComparedQuantity& q) {
  if (a.temperature_C && b.temperature_C) {
    const double apart = std::abs(*a.temperature_C - *b.temperature_C);
    if (apart <= allowed.temperature_K) return;
    q.why_not.push_back({"comparison.temperatures_differ",
                         {{"difference_K", apart},
                          {"first_temperature_C", *a.temperature_C},
                          {"second_temperature_C", *b.temperature_C},
                          {"allowed_difference_K", allowed.temperature_K}}});
  } else if (a.temperature_C) {
    q.cautions.push_back({"comparison.no_second_temperature"});
  } else if (b.temperature_C) {
    q.cautions.push_back({"comparison.no_first_temperature"});
  } else {
    q.cautions.push_back({"comparison.no_temperature"});
  }
}

void judge_sampling(const calibration::Facts& a, const calibration::Facts& b,
                    const AllowedDifference& allowed, ComparedQuantity& q) {
  if (!a.sampling_Hz || !b.sampling_Hz) return;
  const auto [slow, fast] = std::minmax(*a.sampling_Hz, *b.sampling_Hz);
  if (fast <= allowed.rate_factor * slow) return;
  q.why_not.push_back({"comparison.sampling_rates_differ",
                       {{"allowed_factor", allowed.rate_factor},
                        {"first_rate_Hz", *a.sampling_Hz},
                        {"second_rate_Hz", *b.sampling_Hz}}});
}

void judge_payload(const calibration::Facts& a, const calibration::Facts& b, ComparedQuantity& q) {
  if (has_same_payload(a, b)) return;
  const Statement first = payload_statement(a);
  const Statement second = payload_statement(b);
  if (traits_of(q.name).depends_on_payload) {
    q.why_not.push_back(
        {"comparison.payloads_differ", {{"first_payload", first}, {"second_payload", second}}});
  } else {
    q.cautions.push_back({"comparison.payloads_load_the_gear",
                          {{"first_payload", first}, {"second_payload", second}}});
  }
}

void judge_conditions(const calibration::Facts& a, const calibration::Facts& b,
                      const AllowedDifference& allowed, ComparedQuantity& q) {
  const QuantityTraits traits = traits_of(q.name);
  if (!has_same_gear(a, b)) {
    q.why_not.push_back({"comparison.gear_ratios_differ",
                         {{"first_ratio", a.gear_ratio}, {"second_ratio", b.gear_ratio}}});
  }
  judge_payload(a, b, q);
  if (traits.depends_on_temperature) judge_temperature(a, b, allowed, q);
  if (traits.depends_on_sampling) judge_sampling(a, b, allowed, q);
}

Statement verdict_statement(calibration::Verdict verdict) {
  return Code::of("archived_verdict." + calibration::to_string(verdict));
}

bool is_usable(const calibration::Quantity& q) {
  return q.verdict == calibration::Verdict::usable && q.estimate;
}

void judge_verdicts(const calibration::Quantity& a, const calibration::Quantity& b,
                    ComparedQuantity& q) {
  if (!is_usable(a)) {
    q.why_not.push_back(
        {"comparison.verdict_of_first", {{"verdict", verdict_statement(a.verdict)}}});
  }
  if (!is_usable(b)) {
    q.why_not.push_back(
        {"comparison.verdict_of_second", {{"verdict", verdict_statement(b.verdict)}}});
  }
  if (a.unit != b.unit) {
    q.why_not.push_back(
        {"comparison.units_differ", {{"first_unit", a.unit}, {"second_unit", b.unit}}});
  }
}

/// Half width of what each has from another source than the other, which is said.
double not_shared(const calibration::Quantity& a, const calibration::Quantity& b,
                  ComparedQuantity& q) {
  double squares = 0;
  for (const calibration::StatedInfluence& first : a.influences) {
    for (const calibration::StatedInfluence& second : b.influences) {
      const bool are_two = first.name == second.name && !first.id.empty() && !second.id.empty() &&
                           first.id != second.id;
      if (!are_two) continue;
      squares += std::pow(first.standard_uncertainty, 2) + std::pow(second.standard_uncertainty, 2);
      q.cautions.push_back({"comparison.different_influence",
                            {{"influence", Statement{Code::of("influence." + first.name)}},
                             {"first_id", printable(first.id)},
                             {"second_id", printable(second.id)}}});
    }
  }
  return statistics::normal_975 * std::sqrt(squares);
}

ComparedQuantity compared(const calibration::Quantity& a, const calibration::Quantity& b,
                          const calibration::Facts& first, const calibration::Facts& second,
                          const AllowedDifference& allowed) {
  ComparedQuantity q;
  q.name = a.name;
  q.words = a.words;
  q.unit = a.unit;
  q.first = a.estimate;
  q.second = b.estimate;
  judge_verdicts(a, b, q);
  judge_conditions(first, second, allowed, q);
  if (q.first && q.second && a.unit == b.unit) {
    q.change = change_between(*q.first, *q.second, traits_of(q.name).is_angle, not_shared(a, b, q));
  }
  return q;
}

/// The word of each that is comparable.
void give_words(std::vector<ComparedQuantity>& quantities) {
  std::vector<ComparedQuantity*> comparable;
  std::vector<double> chances;
  for (ComparedQuantity& q : quantities) {
    if (!q.why_not.empty() || !q.change) continue;
    comparable.push_back(&q);
    chances.push_back(q.change->chance);
  }
  const std::vector<double> adjusted = holm_adjusted(chances);
  for (std::size_t k = 0; k < comparable.size(); ++k) {
    comparable[k]->adjusted_chance = adjusted[k];
    comparable[k]->word =
        adjusted[k] <= changed_chance ? ChangeWord::changed : ChangeWord::no_change_seen;
  }
}

std::string name_text(const calibration::JointName& of) {
  return fmt::format("{} {}, joint {}", printable(of.robot), printable(of.serial),
                     printable(of.joint));
}

std::vector<Statement> remarks_on(const calibration::Facts& a, const calibration::Facts& b) {
  std::vector<Statement> remarks;
  if (a.of != b.of) {
    remarks.push_back({"comparison.different_joints",
                       {{"first_robot", printable(a.of.robot)},
                        {"first_serial", printable(a.of.serial)},
                        {"first_joint", printable(a.of.joint)},
                        {"second_robot", printable(b.of.robot)},
                        {"second_serial", printable(b.of.serial)},
                        {"second_joint", printable(b.of.joint)}}});
  }
  if (a.measured_at > b.measured_at) remarks.push_back({"comparison.backwards_in_time"});
  if (!a.time_is_stated || !b.time_is_stated) remarks.push_back({"comparison.time_not_stated"});
  if (a.configuration != b.configuration) remarks.push_back({"comparison.different_settings"});
  if (a.tool_version != b.tool_version || a.git_revision != b.git_revision) {
    remarks.push_back({"comparison.different_versions"});
  }
  return remarks;
}

}  // namespace

std::size_t Comparison::count(ChangeWord word) const {
  return static_cast<std::size_t>(
      std::count_if(quantities.begin(), quantities.end(),
                    [&](const ComparedQuantity& q) { return q.word == word; }));
}

const ComparedQuantity* Comparison::largest_change() const {
  const auto certain_percent = [](const ComparedQuantity& q) {
    const std::optional<statistics::Estimate>& percent = q.change->percent;
    return percent ? std::max({percent->low, -percent->high, 0.0}) : -1.0;
  };
  const ComparedQuantity* largest = nullptr;
  for (const ComparedQuantity& q : quantities) {
    if (q.word != ChangeWord::changed || !q.change) continue;
    if (largest == nullptr || certain_percent(q) > certain_percent(*largest)) largest = &q;
  }
  return largest;
}

Comparison compare(const calibration::Measured& first, const calibration::Measured& second,
                   const AllowedDifference& allowed, bool different_joints) {
  const calibration::Facts& a = first.entry.facts;
  const calibration::Facts& b = second.entry.facts;
  if (first.entry.id == second.entry.id) {
    throw UsageError("both ids are the same calibration; there is nothing to compare");
  }
  if (a.of != b.of && !different_joints) {
    throw UsageError(fmt::format("{} and {} are different joints; --different-joints compares them",
                                 name_text(a.of), name_text(b.of)));
  }
  Comparison made{first.entry, second.entry, allowed, {}, remarks_on(a, b)};
  for (const calibration::Quantity& of_first : first.quantities) {
    const auto of_second =
        std::find_if(second.quantities.begin(), second.quantities.end(),
                     [&](const calibration::Quantity& q) { return q.name == of_first.name; });
    if (of_second == second.quantities.end()) continue;
    if (!of_first.estimate && !of_second->estimate) continue;
    made.quantities.push_back(compared(of_first, *of_second, a, b, allowed));
  }
  give_words(made.quantities);
  return made;
}

}  // namespace tribolog::history
