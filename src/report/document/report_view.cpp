#include "report/document/report_view.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "report/document/key_pictures.h"
#include "report/document/log_picture.h"
#include "report/document/view_parts.h"
#include "report/elements/figure_cards.h"
#include "report/elements/result_words.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::report::document {
namespace {

using wording::tr;
using wording::tr_count;

constexpr StageId all_stages[] = {
    StageId::cog_rough,        StageId::cog_precise,    StageId::hysteresis,
    StageId::surrogate_masses, StageId::viscous_curves, StageId::quality_errors,
    StageId::selection,        StageId::parameters,     StageId::break_away};

void describe(const calibration::Calibration& c, StageId stage, Section& section) {
  switch (stage) {
    case StageId::cog_rough:
      return describe_cog_sweep(c.rough, c.manifest.drive.gear_ratio(), section);
    case StageId::cog_precise:
      return describe_cog_sweep(c.precise, c.manifest.drive.gear_ratio(), section);
    case StageId::hysteresis:
      describe_hysteresis(c.hysteresis, c.manifest.drive.gear_ratio(), section);
      section.tables.push_back(
          loop_shapes_table(c.loop_shapes, c.manifest.drive.gear_ratio(), section));
      return;
    case StageId::surrogate_masses:
      return describe_surrogate_masses(c, section);
    case StageId::viscous_curves:
      return describe_viscous_curves(c, section);
    case StageId::quality_errors:
      return describe_quality_errors(c, section);
    case StageId::selection:
      return describe_selection(c, section);
    case StageId::parameters:
      return describe_parameters(c, section);
    case StageId::break_away:
      return describe_break_away(c, section);
  }
}

Section make_section(const calibration::Calibration& c, StageId stage) {
  const statistics::StageReport& report = stage_report(c, stage);
  Section section;
  section.number = stage_number(stage);
  section.id = section_anchor(stage);
  section.title = stage_title(stage);
  section.explanation = explanation_template(stage);
  section.outcome = elements::outcome_of(report.state);
  section.status = status_in_words(report.state);
  section.reason = wording::as_sentence(report.reason);
  if (report.state != statistics::StageState::done) section.experiment = helpful_experiment(stage);
  describe(c, stage, section);
  return section;
}

/// Puts each figure into its stage's section; those of no stage into one of their own.
void place_figures(const calibration::Calibration& c,
                   const std::vector<figures::ReportFigure>& figures,
                   const std::vector<render::workers::DrawnFigure>& drawn, ReportView& view) {
  const std::vector<FigureCard> cards = elements::figure_cards(figures, drawn);
  Section others;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto* const home = std::find_if(
        std::begin(all_stages), std::end(all_stages),
        [&](StageId stage) { return stage_report(c, stage).name == figures[i].stage; });
    // Sections behind the stages go by their anchor.
    const std::string id = home == std::end(all_stages) ? figures[i].stage : section_anchor(*home);
    const auto section = std::find_if(view.sections.begin(), view.sections.end(),
                                      [&](const Section& s) { return s.id == id; });
    (section == view.sections.end() ? others : *section).figures.push_back(cards[i]);
  }
  if (others.figures.empty()) return;
  others.number = static_cast<int>(view.sections.size()) + 1;
  others.id = "other-figures";
  others.title = tr("Other figures");
  others.explanation = "explain_other_figures.tpl";
  others.outcome = Outcome::good;
  others.status = tr("done");
  view.sections.push_back(others);
}

/// In the order in which they stand, those in sight before the folded ones of their section.
void number_figures(ReportView& view) {
  constexpr int loaded_at_once = 3;
  int number = 0;
  for (Section& section : view.sections) {
    std::stable_partition(section.figures.begin(), section.figures.end(),
                          [](const FigureCard& card) { return card.is_primary; });
    for (FigureCard& card : section.figures) {
      ++number;
      const std::initializer_list<StatedValue> values = {
          {"number", number}, {"title", card.title}, {"paper_number", card.paper_number}};
      card.heading = card.paper_number > 0
                         ? tr("Figure {number}: {title} (paper: figure {paper_number})", values)
                         : tr("Figure {number}: {title}", values);
      card.is_lazy = number > loaded_at_once;
    }
  }
}

std::string missing_figures(const ReportView& view) {
  std::size_t missing = 0;
  for (const Section& section : view.sections) {
    for (const FigureCard& card : section.figures) missing += card.png == nullptr ? 1 : 0;
  }
  if (missing == 0) return "";
  return tr_count(missing, "{figures} figure missing", "{figures} figures missing",
                  {{"figures", missing}});
}

void add_verdict(const calibration::Judgement& judgement, ReportView& view) {
  // That one says what the rows say.
  if (!judgement.sentence.is("verdict.nothing_usable"))
    view.verdict_sentence = wording::as_sentence(judgement.sentence);
  view.verdict_rows = rows_in_words(judgement);
  view.verdict = elements::outcome_of(judgement.verdict);
  view.verdict_word = elements::verdict_heading(judgement.verdict);
}

/// "sweep.csv", "run_1.csv and 2 more logs": they stand for a robot that nobody named.
std::string logs_in_words(const std::vector<joint::InputFile>& inputs) {
  std::vector<std::string> names;
  for (const joint::InputFile& input : inputs) {
    const bool is_new = std::find(names.begin(), names.end(), input.name) == names.end();
    if (!input.conversions.empty() && is_new) names.push_back(input.name);
  }
  if (names.empty()) return tr("Robot not named");
  const std::string first = std::filesystem::path(names.front()).filename().string();
  const auto more = static_cast<std::int64_t>(names.size()) - 1;
  return more == 0 ? first
                   : tr_count(more, "{file} and {more} more log", "{file} and {more} more logs",
                              {{"file", first}, {"more", more}});
}

std::string robot_and_joint(const calibration::Calibration& c) {
  const joint::Manifest& m = c.manifest;
  const bool has_robot = !m.robot.empty() && m.robot != joint::unnamed_robot;
  const std::string robot = has_robot ? m.robot : logs_in_words(c.inputs);
  const bool has_joint = !m.joint.empty() && m.joint != joint::unnamed_joint;
  return has_joint ? tr("{robot}, joint {joint}", {{"robot", robot}, {"joint", m.joint}}) : robot;
}

}  // namespace

ReportView make_report_view(const calibration::Calibration& c,
                            const std::vector<figures::ReportFigure>& figures,
                            const std::vector<render::workers::DrawnFigure>& drawn,
                            const calibration::Provenance& provenance,
                            const std::optional<history::Comparison>& since_last,
                            const std::string& id) {
  ReportView view;
  const NumberedFindings findings(c.judgement);
  view.title = robot_and_joint(c);
  view.number = report_number(c.manifest, id);
  view.note = c.manifest.note;
  add_verdict(c.judgement, view);
  view.has_gear = c.manifest.drive.gear_ratio() != 1.0;
  view.quantities = quantity_rows(c, findings, since_last);
  view.friction_speeds = friction_speeds(c);
  view.not_asked_for = not_asked_for(c.judgement);
  view.findings = findings.all();
  view.next_steps = next_steps(c);
  view.log = log_picture(c);
  view.pictures = key_pictures(c);
  view.boundary = boundary_facts(c);
  view.certificate = certificate_facts(c, provenance);
  if (since_last) {
    view.last_day = wording::date_of(since_last->first.facts.measured_at);
    view.last_id = since_last->first.id.substr(0, calibration::shown_digits);
  }
  view.data_checks = data_check_rows(c.data_checks);
  view.rules = rule_rows(c.judgement.rules);
  view.conversion_tables = conversion_tables(c);
  view.key_numbers = key_numbers_table(c);
  view.budget = budget_rows(c.judgement);
  view.limiting_effect = limiting_effect(c.judgement);
  for (const StageId stage : all_stages) {
    if (stage == StageId::break_away && c.break_away.ramps.empty()) continue;
    view.sections.push_back(make_section(c, stage));
    view.sections.back().finding = findings.number_of(stage_report(c, stage).reason);
  }
  if (!c.cross_checks.checks.empty()) {
    view.sections.push_back(cross_checks_section(c));
    view.sections.back().number = static_cast<int>(view.sections.size());
  }
  if (c.truth_check.runs > 0) {
    view.sections.push_back(
        truth_check_section(c.truth_check, static_cast<int>(view.sections.size()) + 1));
  }
  place_figures(c, figures, drawn, view);
  number_figures(view);
  view.figures_missing = missing_figures(view);
  for (const Statement& note : c.notes) view.notes.push_back(wording::as_sentence(note));
  view.provenance_tables = provenance_tables(c, provenance);
  view.command_line = wording::or_dash(provenance.command_line);
  view.created_utc = wording::or_dash(provenance.created_utc);
  view.tool = "tribolog " + provenance.tool_version;
  return view;
}

}  // namespace tribolog::report::document
