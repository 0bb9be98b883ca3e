#include "study/trust.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "joint/degrees.h"
#include "wording/words.h"

namespace tribolog::study {
namespace {

std::size_t base_level(const StudyFactor& factor) {
  const auto it = std::find_if(factor.levels.begin(), factor.levels.end(),
                               [](const StudyLevel& level) { return level.is_base; });
  return static_cast<std::size_t>(it - factor.levels.begin());
}

double percent(double error, double truth) { return 100 * error / truth; }

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

std::string lower(std::string text) {
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] + 32);
  return text;
}

bool is_found_mostly(const StudiedCase& studied, const std::string& reading) {
  constexpr double share = 0.95;
  const StudiedReading* r = studied.find(reading);
  return r != nullptr &&
         static_cast<double>(r->errors.found) >= share * static_cast<double>(r->errors.runs);
}

/// "biased by +1.23 ± 0.02 %" or "free of bias (+0.001 ± 0.002 %)", for gravity.
std::string bias_words(const ErrorStatistics& e) {
  const std::string numbers = fmt::format("{:+.3f} ± {:.3f} %", percent(e.bias, e.truth),
                                          percent(e.bias_standard_error, e.truth));
  const bool biased = e.is_biased(practical_bounds(truth::ReadingKind::gravity, e.truth).fine);
  return biased ? "biased by " + numbers : "free of bias that matters (" + numbers + ")";
}

void add_bias_findings(const StudiedCase& base, std::vector<std::string>& findings) {
  std::vector<std::string> biased;
  std::vector<std::string> unbiased;
  for (const StudiedReading& r : base.readings) {
    if (r.quantity != truth::ReadingKind::gravity) continue;
    const bool is_extreme = r.name.size() == 1 && r.name != "A" && r.name != "B";
    if (is_extreme) continue;  // their pair means stand for them
    const std::string words =
        fmt::format("{} {}", wording::words_for("reading", r.name), bias_words(r.errors));
    const bool is_biased =
        r.errors.is_biased(practical_bounds(truth::ReadingKind::gravity, r.errors.truth).fine);
    (is_biased ? biased : unbiased).push_back(words);
  }
  if (!biased.empty()) {
    findings.push_back(
        fmt::format("Gravity torque in the base case: {}.", fmt::join(biased, "; ")));
  }
  if (!unbiased.empty()) {
    findings.push_back(
        fmt::format("Gravity torque in the base case: {}.", fmt::join(unbiased, "; ")));
  }
}

void add_steady_finding(const StudiedCase& base, std::vector<std::string>& findings) {
  const StudiedReading* a = base.find("A_steady");
  const StudiedReading* b = base.find("B_steady");
  if (a == nullptr || b == nullptr || a->errors.bias * b->errors.bias >= 0) return;
  findings.push_back(fmt::format(
      "In the steady loop A and B lie to both sides of the truth, {:+.2f} % and {:+.2f} %: which "
      "of "
      "them is nearer in the paper's reading rests on the start-up stroke alone.",
      percent(a->errors.bias, a->errors.truth), percent(b->errors.bias, b->errors.truth)));
}

/// Where the reading leaves a criterion, over all factors.
void add_limits(const StudyResult& study, const std::string& reading, Criterion criterion,
                const char* promise, std::vector<std::string>& findings) {
  if (!holds(study.base_case(), reading, criterion)) {
    findings.push_back(fmt::format("{} {} in the base case already.",
                                   capital(wording::words_for("reading", reading)), promise));
    return;
  }
  std::vector<std::string> limits;
  for (const StudyFactor& factor : study.factors) {
    const auto add = [&](std::size_t level) {
      const bool is_found = is_found_mostly(study.case_of(factor.levels[level]), reading);
      limits.push_back(fmt::format("{} {}{}", lower(factor.title), factor.levels[level].text,
                                   is_found ? "" : " (not found there)"));
    };
    const TrustedRange range = trusted_range(study, factor, reading, criterion);
    if (!range.at_base) add(base_level(factor));
    if (range.at_base && range.lowest > 0) add(range.lowest - 1);
    if (range.at_base && range.highest + 1 < factor.levels.size()) add(range.highest + 1);
  }
  const std::string name = capital(wording::words_for("reading", reading));
  findings.push_back(
      limits.empty() ? fmt::format("{} {} at no level tried.", name, promise)
                     : fmt::format("{} {} first at {}.", name, promise, fmt::join(limits, "; ")));
}

}  // namespace

PracticalBounds practical_bounds(truth::ReadingKind quantity, double truth) {
  if (quantity == truth::ReadingKind::peak_angle)
    return {0.02 * joint::rad_per_degree, 0.1 * joint::rad_per_degree};
  if (quantity == truth::ReadingKind::gravity)
    return {1e-3 * std::abs(truth), 3e-3 * std::abs(truth)};
  return {0.01 * std::abs(truth), 0.05 * std::abs(truth)};
}

bool holds(const StudiedCase& studied, const std::string& reading, Criterion criterion) {
  if (!is_found_mostly(studied, reading)) return false;
  const StudiedReading* r = studied.find(reading);
  const PracticalBounds bounds = practical_bounds(r->quantity, r->errors.truth);
  switch (criterion) {
    case Criterion::fine:
      return r->errors.error_95 <= bounds.fine;
    case Criterion::coarse:
      return r->errors.error_95 <= bounds.coarse;
    case Criterion::coverage:
      break;
  }
  return r->errors.all_alike() || !r->errors.intervals_too_narrow();
}

TrustedRange trusted_range(const StudyResult& study, const StudyFactor& factor,
                           const std::string& reading, Criterion criterion) {
  const auto good = [&](std::size_t level) {
    return holds(study.case_of(factor.levels[level]), reading, criterion);
  };
  TrustedRange range;
  range.lowest = range.highest = base_level(factor);
  range.at_base = good(range.lowest);
  if (!range.at_base) return range;
  while (range.lowest > 0 && good(range.lowest - 1)) --range.lowest;
  while (range.highest + 1 < factor.levels.size() && good(range.highest + 1)) ++range.highest;
  range.all_levels = range.lowest == 0 && range.highest + 1 == factor.levels.size();
  return range;
}

std::string recommended_reading(const StudyResult& study) {
  for (const char* reading : {"midline", "sweep"}) {
    if (study.base_case().find(reading) != nullptr) return reading;
  }
  return {};
}

std::string study_sentence(const StudyResult& study) {
  const StudiedCase& base = study.base_case();
  const StudiedReading* best = base.find(recommended_reading(study));
  if (best == nullptr) return "No gravity torque was found in the base case.";
  const ErrorStatistics& e = best->errors;
  std::string sentence = fmt::format(
      "In the base case the {} is within {:.2g} % of the true gravity torque in 95 of 100 runs, "
      "and {:.0f} % of its stated intervals hold the truth",
      wording::words_for("reading", best->name), std::abs(percent(e.error_95, e.truth)),
      100 * e.coverage.value);
  if (const StudiedReading* b = base.find("B")) {
    sentence += fmt::format("; point B is off by {:+.2f} %, the {} by {:+.3f} %",
                            percent(b->errors.bias, b->errors.truth),
                            wording::words_for("reading", best->name), percent(e.bias, e.truth));
  }
  return sentence + ".";
}

std::vector<std::string> study_findings(const StudyResult& study) {
  std::vector<std::string> findings;
  const StudiedCase& base = study.base_case();
  add_bias_findings(base, findings);
  add_steady_finding(base, findings);
  for (const char* reading : {"midline", "fit", "sweep"}) {
    if (base.find(reading) == nullptr) continue;
    add_limits(study, reading, Criterion::fine, "leaves 0.1 %", findings);
    add_limits(study, reading, Criterion::coarse, "leaves 0.3 %", findings);
    add_limits(study, reading, Criterion::coverage, "has intervals narrower than they claim",
               findings);
  }
  return findings;
}

}  // namespace tribolog::study
