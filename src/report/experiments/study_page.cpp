#include "report/experiments/study_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "joint/degrees.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/figure_cards.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "study/trust.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::experiments {

namespace {

using wording::tr;
using wording::tr_count;

/// Errors of a quantity as its tables show them: in % of the truth, angles in thousandths of a
/// degree.
struct ErrorScale {
  double factor;
  std::string unit;
};

ErrorScale error_scale(const study::StudiedReading& r) {
  if (r.quantity == truth::ReadingKind::peak_angle) return {1e3 * joint::degrees_per_rad, "10⁻³ °"};
  return {100 / std::abs(r.errors.truth), "%"};
}

/// "−0.614 ± 0.007", the standard error to two digits; without scatter three decimals.
std::string bias_text(const study::StudiedReading& r) {
  const double factor = error_scale(r).factor;
  const double error = r.errors.bias_standard_error * factor;
  const int decimals = error > 0 ? std::clamp(wording::decimals_for(error), 0, 6) : 3;
  const std::string bias =
      wording::with_plus_sign(wording::fixed(r.errors.bias * factor, decimals));
  return error > 0 ? bias + " ± " + wording::fixed(error, decimals) : bias;
}

std::string scatter_text(const study::StudiedReading& r) {
  constexpr int digits = 3;
  return wording::significant(r.errors.scatter * error_scale(r).factor, digits);
}

/// "94.5 (90.4 … 96.9)"
std::string coverage_text(const study::StudiedReading& r) {
  const study::Share& c = r.errors.coverage;
  return fmt::format("{} ({} … {})", wording::fixed(100 * c.value, 1),
                     wording::fixed(100 * c.low, 1), wording::fixed(100 * c.high, 1));
}

std::string capital_words(truth::ReadingName reading) {
  return wording::capitalised(wording::words_for("reading", to_string(reading)));
}

/// Readings that a factor's cases show, in their order.
std::vector<truth::ReadingName> readings_of_factor(const study::StudyResult& study,
                                                   const study::StudyFactor& factor) {
  std::vector<truth::ReadingName> names;
  // A level may lose some; the base case has them all.
  for (const study::StudyLevel& level : factor.levels) {
    if (!level.is_base) continue;
    for (const study::StudiedReading& r : study.case_of(level).readings) names.push_back(r.name);
  }
  return names;
}

elements::Table level_table(const study::StudyResult& study, const study::StudyFactor& factor,
                            const std::string& id, const std::string& caption,
                            std::string (*text)(const study::StudiedReading&), bool has_unit) {
  elements::Table table;
  table.id = fmt::format("table-{}-{}", factor.key, id);
  std::replace(table.id.begin(), table.id.end(), '_', '-');
  table.caption = caption;
  table.columns = {{tr("Estimator"), "", false, true}};
  if (has_unit) table.columns.push_back({tr("In"), "", false});
  for (const study::StudyLevel& level : factor.levels) {
    table.columns.push_back(
        {level.is_base ? tr("{level}, base", {{"level", level.text}}) : wording::words(level.text),
         "", true});
  }
  for (const truth::ReadingName name : readings_of_factor(study, factor)) {
    elements::Row row{{capital_words(name)}, name == study::recommended_reading(study)};
    std::string unit;
    std::vector<std::string> cells;
    for (const study::StudyLevel& level : factor.levels) {
      const study::StudiedReading* r = study.case_of(level).find(name);
      if (r == nullptr) {
        cells.push_back(tr("not found"));
        continue;
      }
      unit = error_scale(*r).unit;
      std::string cell = text(*r);
      if (r->errors.found < r->errors.runs) {
        cell = tr("{errors} [{found} of {runs}]",
                  {{"errors", cell}, {"found", r->errors.found}, {"runs", r->errors.runs}});
      }
      cells.push_back(std::move(cell));
    }
    if (has_unit) row.cells.push_back(unit);
    row.cells.insert(row.cells.end(), cells.begin(), cells.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<elements::Table> tables_of(const study::StudyResult& study,
                                       const study::StudyFactor& factor) {
  elements::Table bias =
      level_table(study, factor, "bias", tr("Bias ± its standard error"), bias_text, true);
  bias.note =
      tr("Gravity and friction in % of the true value, the angle in thousandths of a degree. “[k "
         "of n]”: found in k of n runs only.");
  elements::Table scatter =
      level_table(study, factor, "scatter", tr("Scatter from run to run (standard deviation)"),
                  scatter_text, true);
  elements::Table coverage =
      level_table(study, factor, "coverage",
                  tr("Runs whose stated 95 % interval contains the true value, in % "
                     "(with its own 95 % interval)"),
                  coverage_text, false);
  return {std::move(bias), std::move(scatter), std::move(coverage)};
}

std::string range_text(const study::StudyFactor& factor, const study::TrustedRange& range) {
  if (!range.at_base) return tr("no");
  if (range.all_levels) return tr("all levels");
  const Statement& lowest = factor.levels[range.lowest].text;
  if (range.lowest == range.highest) return tr("{level} only", {{"level", lowest}});
  return wording::words(lowest) + " … " + wording::words(factor.levels[range.highest].text);
}

elements::Table trust_table(const study::StudyResult& study, study::Criterion criterion,
                            const std::string& id, const std::string& caption) {
  elements::Table table;
  table.id = "table-trust-" + id;
  table.caption = caption;
  table.columns = {{tr("Estimator"), "", false, true}};
  for (const study::StudyFactor& factor : study.factors) {
    table.columns.push_back({wording::words_for("factor", factor.key), "", false});
  }
  for (const study::StudiedReading& r : study.base_case().readings) {
    elements::Row row{{capital_words(r.name)}, r.name == study::recommended_reading(study)};
    for (const study::StudyFactor& factor : study.factors) {
      const std::vector<truth::ReadingName> shown = readings_of_factor(study, factor);
      const bool is_studied = std::find(shown.begin(), shown.end(), r.name) != shown.end();
      row.cells.push_back(
          is_studied ? range_text(factor, study::trusted_range(study, factor, r.name, criterion))
                     : "–");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

void fill_trust(const study::StudyResult& study, engine::TemplateValues& values) {
  elements::Table fine =
      trust_table(study, study::Criterion::fine, "fine",
                  tr("95 of 100 runs within 0.1 % of the gravity torque, 0.02° of the "
                     "angle, 1 % of a friction parameter"));
  elements::Table coarse = trust_table(study, study::Criterion::coarse, "coarse",
                                       tr("95 of 100 runs within 0.3 %, 0.1°, 5 %"));
  elements::Table coverage = trust_table(
      study, study::Criterion::coverage, "coverage",
      tr("The stated 95 % intervals contain the true value in 91 % of the runs or more"));
  coverage.note =
      tr("An interval counts as too narrow where even the upper end of the coverage's own interval "
         "is below 91 %. Levels at which all runs are identical, for lack of noise, are skipped.");
  for (const elements::Table& table : {fine, coarse, coverage})
    elements::fill_table(table, "TRUST", values);
}

void fill_verdict(const study::StudyResult& study, engine::TemplateValues& values) {
  engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const std::optional<truth::ReadingName> best = study::recommended_reading(study);
  const auto best_holds = [&](study::Criterion criterion) {
    return best && study::holds(study.base_case(), *best, criterion);
  };
  const bool covers = best_holds(study::Criterion::coverage);
  const bool fine = covers && best_holds(study::Criterion::fine);
  const bool coarse = covers && best_holds(study::Criterion::coarse);
  verdict.set("WORD", fine     ? tr("TO BE TRUSTED IN THE BASE CASE")
                      : coarse ? tr("TO BE TRUSTED WITHIN 0.3 % IN THE BASE CASE")
                               : tr("NOT TO BE TRUSTED IN THE BASE CASE"));
  verdict.set("SENTENCE", wording::words(study::study_sentence(study)));
  elements::fill_outcome(fine     ? elements::Outcome::good
                         : coarse ? elements::Outcome::partial
                                  : elements::Outcome::bad,
                         verdict);
  engine::TemplateValues& findings = verdict.add_section("FINDINGS");
  for (const std::string& finding : wording::words(study::study_findings(study))) {
    findings.add_section("FINDING").set("TEXT", finding);
  }
}

std::string counts_a_turn(double counts) {
  return tr_count(std::llrint(counts), "{counts}\u00a0count a turn", "{counts}\u00a0counts a turn",
                  {{"counts", wording::as_stated(counts)}});
}

std::string oscillation_text(const simulate::OscillationExperiment& e) {
  constexpr int digits = 4;
  const auto whole_cycles = std::llrint(std::ceil(e.cycles));  // a part of one makes it many
  return tr_count(whole_cycles, "{amplitude}, {frequency}, {cycles}\u00a0cycle",
                  "{amplitude}, {frequency}, {cycles}\u00a0cycles",
                  {{"amplitude", wording::with_unit(
                                     wording::significant(e.amplitude_rad * 1e6, digits), "µrad")},
                   {"frequency", wording::with_unit(wording::as_stated(e.frequency_Hz), "Hz")},
                   {"cycles", wording::as_stated(e.cycles)}});
}

std::vector<elements::Fact> base_facts(const StudyReport& report) {
  const study::StudyResult& study = report.study;
  const simulate::Noise& noise = study.base.noise;
  constexpr int digits = 4;
  std::vector<elements::Fact> facts{
      {tr("Scenario"), wording::or_dash(study.base.name)},
      {tr("Runs per case"), std::to_string(study.options.runs)},
      {tr("Cases"), std::to_string(study.cases.size())},
      {tr("Seed"), std::to_string(study.options.seed)},
      {tr("True gravity torque at the motor"),
       wording::with_unit(
           wording::significant(study.base.load.amplitude_Nm() / study.base.gear_ratio, digits + 2),
           "N·m")},
      {tr("White torque noise"),
       wording::with_unit(wording::significant(noise.torque_white_Nm, digits), "N·m")},
      {tr("Torque step"),
       wording::with_unit(wording::significant(noise.torque_step_Nm, digits), "N·m")},
      {tr("Motor encoder"), counts_a_turn(noise.encoder_counts_per_turn)}};
  if (const auto& e = study.base.oscillation) {
    facts.push_back({tr("Oscillation"), oscillation_text(*e)});
  }
  return facts;
}

}  // namespace

std::string study_page(const StudyReport& report, const std::vector<figures::ReportFigure>& figures,
                       const std::vector<render::workers::DrawnFigure>& drawn,
                       wording::Language language) {
  const study::StudyResult& study = report.study;
  engine::TemplateValues values;
  engine::fill_head(report.provenance, values);
  values.set("SCENARIO_FILE", wording::or_dash(report.scenario_file));
  values.set("SCENARIO_TEXT", wording::or_dash(report.scenario_text));
  elements::fill_facts(base_facts(report), values);
  fill_verdict(study, values);
  fill_trust(study, values);
  const std::vector<elements::FigureCard> cards = elements::figure_cards(figures, drawn);
  for (const study::StudyFactor& factor : study.factors) {
    std::string id = factor.key;
    std::replace(id.begin(), id.end(), '_', '-');
    engine::TemplateValues& entry = values.add_section("CONTENTS_ENTRY");
    engine::TemplateValues& section = values.add_section("FACTOR");
    for (engine::TemplateValues* both : {&entry, &section}) {
      both->set("SECTION_ID", id);
      both->set("TITLE", wording::words_for("factor", factor.key));
    }
    section.set("NOTE_TEXT", wording::words_for("factor_note", factor.key));
    for (std::size_t i = 0; i < figures.size(); ++i) {
      if (figures[i].stage == factor.key) elements::fill_figure(cards[i], section);
    }
    engine::TemplateValues& tables = section.add_section("TABLES");
    for (const elements::Table& table : tables_of(study, factor))
      elements::fill_table(table, "TABLE", tables);
  }
  values.set_checked_by_modifier("RESULT_JSON", study_json(report));
  return engine::expand_template("study.tpl", values, language);
}

// All numbers of a study.

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json errors_json(const study::StudiedReading& r) {
  const study::ErrorStatistics& e = r.errors;
  const study::PracticalBounds bounds = study::practical_bounds(r.quantity, e.truth);
  return {{"estimator", to_string(r.name)},
          {"unit", truth::unit_of(r.quantity)},
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

Json case_json(const study::StudiedCase& studied) {
  Json readings = Json::array();
  for (const study::StudiedReading& r : studied.readings) readings.push_back(errors_json(r));
  return {{"name", studied.name}, {"estimators", std::move(readings)}};
}

Json factor_json(const study::StudyFactor& factor) {
  Json levels = Json::array();
  for (const study::StudyLevel& level : factor.levels) {
    levels.push_back({{"value", number(level.value)},
                      {"text", wording::words(level.text)},
                      {"base", level.is_base},
                      {"case", level.case_name}});
  }
  return {{"key", factor.key},
          {"title", wording::words_for("factor", factor.key)},
          {"axis", wording::words_for("factor_axis", factor.key)},
          {"note", wording::words_for("factor_note", factor.key)},
          {"levels", std::move(levels)}};
}

}  // namespace

std::string study_json(const StudyReport& report) {
  const wording::WordsIn english({});
  const study::StudyResult& study = report.study;
  Json factors = Json::array();
  for (const study::StudyFactor& factor : study.factors) factors.push_back(factor_json(factor));
  Json cases = Json::array();
  for (const study::StudiedCase& studied : study.cases) cases.push_back(case_json(studied));
  const Json all{{"schema", "tribolog-study-1"},
                 {"tool", report.provenance.tool_version},
                 {"scenario", study.base.name},
                 {"scenario_file", report.scenario_file},
                 {"runs", study.options.runs},
                 {"seed", study.options.seed},
                 {"sentence", wording::words(study::study_sentence(study))},
                 {"findings", wording::words(study::study_findings(study))},
                 {"factors", std::move(factors)},
                 {"cases", std::move(cases)}};
  return json_without_hidden(all.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace tribolog::report::experiments
