// Names and standing texts of the stages.

#include <algorithm>

#include "base/enum_text.h"
#include "figures/figure_csv.h"
#include "report/view_parts.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report {

namespace {
using wording::tr;
}

const statistics::StageReport& stage_report(const calibration::Calibration& c, StageId stage) {
  switch (stage) {
    case StageId::cog_rough:
      return c.rough.stage;
    case StageId::cog_precise:
      return c.precise.stage;
    case StageId::hysteresis:
      return c.hysteresis.stage;
    case StageId::surrogate_masses:
      return c.masses.stage;
    case StageId::viscous_curves:
      return c.viscous.stage;
    case StageId::quality_errors:
      return c.quality.stage;
    case StageId::selection:
      return c.selection.stage;
    case StageId::break_away:
      return c.break_away.stage;
    case StageId::parameters:
      break;
  }
  return c.friction.stage;
}

int stage_number(StageId stage) { return static_cast<int>(stage) + 1; }

std::string section_anchor(StageId stage) { return "stage-" + std::to_string(stage_number(stage)); }

std::string stage_title(StageId stage) { return wording::words_for("stage", own_name(stage)); }

std::string explanation_template(StageId stage) { return "explain_" + own_name(stage) + ".tpl"; }

std::string helpful_experiment(StageId stage) {
  switch (stage) {
    case StageId::cog_rough:
      return tr(
          "Move the joint slowly and steadily (about 2 °/s) over as much of its range as it "
          "allows, across the angle at which the arm's centre of gravity is level with the "
          "axis, once in each direction. Log time, joint angle and motor torque, or motor "
          "current with the torque constant of the drive.");
    case StageId::cog_precise:
      return tr(
          "Repeat the slow sweep within ±1° of the rough result, slower (0.1 to 0.5 °/s) and "
          "in both directions, several times.");
    case StageId::hysteresis:
      return tr(
          "Oscillate the joint about the gravity peak with a sine of about 1 Hz and so small a "
          "stroke that it stays in pre-sliding (about 0.1 mrad at the joint), ten cycles or more, "
          "sampled at 1 kHz. The encoder must resolve the stroke into at least fifty steps. Repeat "
          "at several motor positions if the torque ripples with position.");
    case StageId::surrogate_masses:
      return "The gravity torque of a rough sweep gives one mass; the others need the hysteresis "
             "loop of stage 3.";
    case StageId::viscous_curves:
      return tr(
          "Run the joint at ten to twenty constant speeds, from the slowest that is smooth to "
          "the fastest allowed, in both directions over the same angles.");
    case StageId::quality_errors:
      return tr(
          "Run every constant speed in both directions over the same angles: half the difference "
          "between the two torques is friction, whatever gravity is.");
    case StageId::selection:
      return "It follows from the stages above; see what they are missing.";
    case StageId::break_away:
      return tr(
          "From rest, let the torque rise slowly (a tenth of the expected break-away torque per "
          "second or less) until the joint slides, five times in each direction from the same "
          "angle, and stop only after the slip.");
    case StageId::parameters:
      break;
  }
  return "Record at least ten constant speeds spread over the Stribeck dip and the viscous branch; "
         "for the bristle parameters, a micro-oscillation that the encoder resolves.";
}

std::string stage_reference(StageId stage) {
  return tr("stage {stage}", {{"stage", stage_number(stage)}});
}

Outcome outcome_of(statistics::StageState state) {
  switch (state) {
    case statistics::StageState::done:
      return Outcome::good;
    case statistics::StageState::partial:
      return Outcome::partial;
    case statistics::StageState::not_identifiable:
      return Outcome::bad;
    case statistics::StageState::skipped:
      break;
  }
  return Outcome::absent;
}

std::string status_in_words(statistics::StageState state) {
  return wording::words_for("stage_state", to_string(state));
}

// Figures and their pictures, paired by id.

namespace {

constexpr std::size_t eager_figures = 3;

FigureCard card(const figures::ReportFigure& figure, const render::workers::DrawnFigure* drawn) {
  FigureCard made;
  made.id = figure.id;
  made.title = figure.title;
  made.paper_number = figure.paper_number.value_or(0);
  made.is_primary = figure.is_primary;
  // Only the paper's figures have numbers, where a page does not number its own.
  made.heading = figure.paper_number
                     ? tr("Figure {number}: {title}",
                          {{"number", *figure.paper_number}, {"title", figure.title}})
                     : figure.title;
  made.caption = as_sentence(figure.caption);
  made.how_to_read = figure.how_to_read;
  made.alt = or_dash(figure.alt);
  if (drawn == nullptr) {
    made.error = tr("It was not drawn.");
  } else if (!drawn->error.empty()) {
    made.error = as_sentence(wording::words(drawn->error));
  } else if (drawn->png.empty()) {
    made.error = tr("Its picture is empty.");
  } else {
    made.png = &drawn->png;
    made.width_px = drawn->width_px;
    made.height_px = drawn->height_px;
  }
  if (drawn != nullptr) made.warnings = wording::words(drawn->warnings);
  made.csv = figure.english_csv.empty() ? figures::figure_csv(figure, figures::most_csv_rows)
                                        : figure.english_csv;
  return made;
}

}  // namespace

std::vector<FigureCard> figure_cards(const std::vector<figures::ReportFigure>& figures,
                                     const std::vector<render::workers::DrawnFigure>& drawn) {
  std::vector<FigureCard> cards;
  for (const figures::ReportFigure& figure : figures) {
    const auto picture = std::find_if(
        drawn.begin(), drawn.end(),
        [&figure](const render::workers::DrawnFigure& d) { return d.id == figure.id; });
    cards.push_back(card(figure, picture == drawn.end() ? nullptr : &*picture));
    cards.back().is_lazy = cards.size() > eager_figures;
  }
  return cards;
}

}  // namespace tribolog::report
