// All numbers of a study.

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "report/study_page.h"
#include "study/trust.h"

namespace tribolog {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json errors_json(const StudiedReading& r) {
  const ErrorStatistics& e = r.errors;
  const PracticalBounds bounds = practical_bounds(r.quantity, e.truth);
  return {{"estimator", r.name},
          {"unit", unit_of(r.quantity)},
          {"truth", number(e.truth)},
          {"runs", e.runs},
          {"found", e.found},
          {"bias", number(e.bias)},
          {"bias_standard_error", number(e.bias_standard_error)},
          {"biased", e.is_biased(bounds.fine)},
          {"scatter", number(e.scatter)},
          {"error_95", number(e.error_95)},
          {"half_width", number(e.half_width)},
          {"coverage",
           {{"share", number(e.coverage.value)},
            {"low", number(e.coverage.low)},
            {"high", number(e.coverage.high)}}},
          {"fine_bound", number(bounds.fine)},
          {"coarse_bound", number(bounds.coarse)}};
}

Json case_json(const StudiedCase& studied) {
  Json readings = Json::array();
  for (const StudiedReading& r : studied.readings) readings.push_back(errors_json(r));
  return {{"name", studied.name}, {"estimators", std::move(readings)}};
}

Json factor_json(const StudyFactor& factor) {
  Json levels = Json::array();
  for (const StudyLevel& level : factor.levels) {
    levels.push_back({{"value", number(level.value)},
                      {"text", level.text},
                      {"base", level.is_base},
                      {"case", level.case_name}});
  }
  return {{"key", factor.key},
          {"title", factor.title},
          {"axis", factor.axis},
          {"note", factor.note},
          {"levels", std::move(levels)}};
}

}  // namespace

std::string study_json(const StudyReport& report) {
  const StudyResult& study = report.study;
  Json factors = Json::array();
  for (const StudyFactor& factor : study.factors) factors.push_back(factor_json(factor));
  Json cases = Json::array();
  for (const StudiedCase& studied : study.cases) cases.push_back(case_json(studied));
  const Json all{{"schema", "tribolog-study-1"},
                 {"tool", report.provenance.tool_version},
                 {"scenario", study.base.name},
                 {"scenario_file", report.scenario_file},
                 {"runs", study.options.runs},
                 {"seed", study.options.seed},
                 {"resamples", study.options.resamples},
                 {"sentence", study_sentence(study)},
                 {"findings", study_findings(study)},
                 {"factors", std::move(factors)},
                 {"cases", std::move(cases)}};
  return json_without_hidden(all.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace tribolog
