#include "study/trust.h"

#include <algorithm>
#include <cmath>

#include "joint/degrees.h"

namespace tribolog::study {

using truth::ReadingName;

namespace {

std::size_t base_level(const StudyFactor& factor) {
  const auto it = std::find_if(factor.levels.begin(), factor.levels.end(),
                               [](const StudyLevel& level) { return level.is_base; });
  return static_cast<std::size_t>(it - factor.levels.begin());
}

double percent(double error, double truth) { return 100 * error / truth; }

bool is_found_mostly(const StudiedCase& studied, ReadingName reading) {
  constexpr double share = 0.95;
  const StudiedReading* r = studied.find(reading);
  return r != nullptr &&
         static_cast<double>(r->errors.found) >= share * static_cast<double>(r->errors.runs);
}

bool is_biased(const ErrorStatistics& e) {
  return e.is_biased(practical_bounds(truth::ReadingKind::gravity, e.truth).fine);
}

Statement bias_of(const StudiedReading& r) {
  const ErrorStatistics& e = r.errors;
  return {is_biased(e) ? Code("study.biased") : Code("study.free_of_bias"),
          {{"estimator", Statement{Code::of("reading." + to_string(r.name))}},
           {"bias_percent", percent(e.bias, e.truth)},
           {"standard_error_percent", percent(e.bias_standard_error, e.truth)}}};
}

void add_bias_findings(const StudiedCase& base, std::vector<Statement>& findings) {
  std::vector<Statement> biased;
  std::vector<Statement> unbiased;
  for (const StudiedReading& r : base.readings) {
    if (r.quantity != truth::ReadingKind::gravity) continue;
    const bool is_extreme = r.name >= ReadingName::C && r.name <= ReadingName::F;
    if (is_extreme) continue;  // their pair means stand for them
    (is_biased(r.errors) ? biased : unbiased).push_back(bias_of(r));
  }
  for (const std::vector<Statement>& estimators : {biased, unbiased}) {
    if (!estimators.empty()) {
      findings.push_back({"study.gravity_in_base_case", {{"estimators", estimators}}});
    }
  }
}

void add_steady_finding(const StudiedCase& base, std::vector<Statement>& findings) {
  const StudiedReading* a = base.find(ReadingName::A_steady);
  const StudiedReading* b = base.find(ReadingName::B_steady);
  if (a == nullptr || b == nullptr || a->errors.bias * b->errors.bias >= 0) return;
  findings.push_back({"study.steady_loop",
                      {{"point_a_bias_percent", percent(a->errors.bias, a->errors.truth)},
                       {"point_b_bias_percent", percent(b->errors.bias, b->errors.truth)}}});
}

std::string topic_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::fine:
      return "study_fine.";
    case Criterion::coarse:
      return "study_coarse.";
    case Criterion::coverage:
      break;
  }
  return "study_coverage.";
}

/// Levels at which the reading leaves a criterion, over all factors.
std::vector<Statement> limits_of(const StudyResult& study, ReadingName reading,
                                 Criterion criterion) {
  std::vector<Statement> limits;
  for (const StudyFactor& factor : study.factors) {
    const auto add = [&](std::size_t level) {
      const bool is_found = is_found_mostly(study.case_of(factor.levels[level]), reading);
      limits.push_back({Code::of((is_found ? "study_at." : "study_not_found_at.") + factor.key),
                        {{"level", factor.levels[level].text}}});
    };
    const TrustedRange range = trusted_range(study, factor, reading, criterion);
    if (!range.at_base) add(base_level(factor));
    if (range.at_base && range.lowest > 0) add(range.lowest - 1);
    if (range.at_base && range.highest + 1 < factor.levels.size()) add(range.highest + 1);
  }
  return limits;
}

Statement limit_finding(const StudyResult& study, ReadingName reading, Criterion criterion) {
  const std::string topic = topic_of(criterion);
  const Statement estimator{Code::of("studied." + to_string(reading))};
  if (!holds(study.base_case(), reading, criterion)) {
    return {Code::of(topic + "not_in_base_case"), {{"estimator", estimator}}};
  }
  const std::vector<Statement> limits = limits_of(study, reading, criterion);
  if (limits.empty()) return {Code::of(topic + "at_all_levels"), {{"estimator", estimator}}};
  return {Code::of(topic + "left_at"), {{"estimator", estimator}, {"levels", limits}}};
}

}  // namespace

PracticalBounds practical_bounds(truth::ReadingKind quantity, double truth) {
  if (quantity == truth::ReadingKind::peak_angle)
    return {0.02 * joint::rad_per_degree, 0.1 * joint::rad_per_degree};
  if (quantity == truth::ReadingKind::gravity)
    return {1e-3 * std::abs(truth), 3e-3 * std::abs(truth)};
  return {0.01 * std::abs(truth), 0.05 * std::abs(truth)};
}

bool holds(const StudiedCase& studied, ReadingName reading, Criterion criterion) {
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

TrustedRange trusted_range(const StudyResult& study, const StudyFactor& factor, ReadingName reading,
                           Criterion criterion) {
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

std::optional<ReadingName> recommended_reading(const StudyResult& study) {
  for (const ReadingName reading : {ReadingName::model, ReadingName::midline}) {
    if (study.base_case().find(reading) != nullptr) return reading;
  }
  return std::nullopt;
}

Statement study_sentence(const StudyResult& study) {
  const StudiedCase& base = study.base_case();
  const std::optional<ReadingName> recommended = recommended_reading(study);
  if (!recommended) return {"study.no_gravity"};
  const ErrorStatistics& e = base.find(*recommended)->errors;
  std::string code = "study_sentence." + to_string(*recommended);
  std::vector<StatedValue> values{{"error_percent", std::abs(percent(e.error_95, e.truth))},
                                  {"coverage_percent", 100 * e.coverage.value}};
  if (const StudiedReading* b = base.find(ReadingName::B)) {
    code += "_beside_B";
    values.emplace_back("point_b_bias_percent", percent(b->errors.bias, b->errors.truth));
    values.emplace_back("bias_percent", percent(e.bias, e.truth));
  }
  return Statement::with(Code::of(code), values);
}

std::vector<Statement> study_findings(const StudyResult& study) {
  std::vector<Statement> findings;
  const StudiedCase& base = study.base_case();
  add_bias_findings(base, findings);
  add_steady_finding(base, findings);
  for (const ReadingName reading : {ReadingName::midline, ReadingName::fit, ReadingName::model}) {
    if (base.find(reading) == nullptr) continue;
    for (const Criterion criterion : {Criterion::fine, Criterion::coarse, Criterion::coverage}) {
      findings.push_back(limit_finding(study, reading, criterion));
    }
  }
  return findings;
}

}  // namespace tribolog::study
