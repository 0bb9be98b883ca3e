#pragma once
// The report as ready text: what the templates print, and nothing that is still to be computed.
//
// Making the view is the only place where numbers are rounded. All texts are plain UTF-8 without
// markup; the template engine escapes them.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "history/comparison.h"
#include "render/workers/renderer.h"
#include "report/elements/elements.h"

namespace tribolog::report::document {

using elements::Column;
using elements::Fact;
using elements::FigureCard;
using elements::Outcome;
using elements::Row;
using elements::Table;

struct Section {
  int number{};
  std::string id;  ///< "stage-3"
  std::string title;
  std::string explanation;  ///< File name of the template that explains the stage.
  Outcome outcome{Outcome::absent};
  std::string status;      ///< The outcome in words: "not identifiable".
  std::string reason;      ///< Of the stage's report; may be empty if done.
  int finding{};           ///< Number of the finding that states the reason; 0: none does.
  std::string experiment;  ///< What would bring the missing numbers; empty if nothing is missing.
  std::vector<Fact> facts;
  std::vector<Table> tables;
  std::vector<FigureCard> figures;
};

/// A limit that the manifest states, and what came of it.
struct LimitCell {
  std::string rule;  ///< "≤ 12 N·m"
  std::string word;  ///< "kept"
  Outcome outcome{Outcome::absent};
};

/// One quantity with its verdict.
struct QuantityRow {
  std::string words;
  Outcome outcome{Outcome::absent};
  std::string verdict_word;  ///< "not identifiable"
  std::string at_motor;      ///< "3.8833 ± 0.0086 N·m"; may be empty.
  std::string at_joint;      ///< The same on the other side of the gear; may be empty.
  std::string coverage;      ///< "1.96"; may be empty.
  std::string largest_part;  ///< Of the budget: "the recordings 97 %"; may be empty.
  std::vector<LimitCell> limits;
  std::optional<LimitCell> stated;  ///< By design or data sheet, and whether it is found again.
  std::string change;               ///< Since the last calibration, with its unit; may be empty.
  std::string change_range;         ///< Of its interval: "± 0.0047"; may be empty.
  std::string change_word;          ///< "no change seen"; empty: there is none to compare with.
  bool is_changed{};
  std::vector<int> findings;  ///< On which the verdict rests, by their numbers.
};

/// Friction at one speed, without units.
struct FrictionRow {
  std::string speed;           ///< "12.5", at the motor.
  std::string speed_at_joint;  ///< Empty without a gear.
  std::string torque;          ///< "0.31 ± 0.02"; empty: its verdict refuses it.
  std::string torque_at_joint;
  Outcome outcome{Outcome::absent};
  std::string verdict_word;
};

struct FrictionSpeeds {
  std::string unit;  ///< Of the torques at the motor.
  std::string unit_at_joint;
  std::vector<FrictionRow> rows;  ///< None: no table.
  std::string good_for;           ///< In which speeds it is usable, or why in none.
};

/// Said once, and referred to by its number.
struct Finding {
  int number{};
  std::string text;
  std::string consequence;              ///< May be empty.
  std::vector<std::string> quantities;  ///< Whose verdict rests on it, where the text names none.
  bool is_note{};                       ///< No verdict rests on it.
};

/// What to record next, and for what.
struct NextStep {
  std::string text;
  std::vector<std::string> quantities;
};

/// A diagram of page one: paths and labels, in the pixels of its drawing.
struct KeyPicture {
  struct Tick {
    double at{};
    std::string label;
  };
  std::string id;
  std::string title;
  std::string caption;  ///< What is drawn how.
  std::string x_title, y_title;
  std::vector<Tick> x_ticks, y_ticks;
  std::string grid;
  std::string band;      ///< Closed; may be empty, as those below.
  std::string level;     ///< A line across.
  std::string measured;  ///< A line.
  std::string forward;   ///< Dots.
  std::string backward;  ///< Dots.
  std::string bars;      ///< Intervals of the dots.
  std::string fitted;
};

/// The joint's angle through the log, its parts named.
struct LogPicture {
  struct Phase {
    std::string name;  ///< "rough sweep"
    std::string role;  ///< Class of its colour: "rough_sweep".
    double from{};
    double to{};
    std::size_t recordings{};
    std::string path;
  };
  std::vector<Phase> phases;  ///< Those of one role that follow each other are one.
  std::vector<KeyPicture::Tick> y_ticks;
  std::string caption;
};

/// One quantity's uncertainty.
struct BudgetRow {
  struct Part {
    std::string name;     ///< "torque constant 97 % (B)"
    std::string kind;     ///< Class of its colour: "torque-constant".
    double from_percent;  ///< Where it begins in the bar.
    double percent;
  };
  std::string quantity;
  std::string standard;  ///< With its unit.
  std::string freedom;
  std::string coverage;
  std::string expanded;
  std::vector<Part> parts;
  std::string effects;  ///< Of what the recordings leave; empty: of no model.
};

/// One check on the data.
struct DataCheckRow {
  std::string id;  ///< Anchor, "check-..."
  std::string title;
  std::string measure;  ///< May be empty.
  Outcome outcome{Outcome::absent};
  std::string state_word;  ///< "passed"
  std::string measured;    ///< With its unit, or a dash.
  std::string limit;       ///< "at most 50 %", or a dash.
  std::string recording;   ///< Or a dash.
  std::string found;
  std::string consequence;  ///< May be empty.
  std::string experiment;   ///< May be empty.
};

struct ReportView {
  std::string title;   ///< Of the document: robot and joint.
  std::string number;  ///< Of the report: "tribolog-0123456789ab", or the laboratory's.
  std::string note;    ///< The operator's note; may be empty.
  Outcome verdict{Outcome::absent};
  std::string verdict_word;      ///< "USABLE"
  std::string verdict_sentence;  ///< May be empty.
  std::string verdict_rows;      ///< Which quantities are usable, doubtful...; may be empty.
  std::vector<Finding> findings;
  std::vector<NextStep> next_steps;
  std::string next_parts;  ///< What to record for them, and how long it takes; may be empty.
  std::string
      not_asked_for;  ///< Quantities that nothing rests on and that do not show; may be empty.
  std::optional<LogPicture> log;  ///< Above all else; absent without recordings.
  std::vector<KeyPicture> pictures;
  std::vector<Fact> boundary;     ///< What went in, is included, is not, was seen.
  std::vector<Fact> certificate;  ///< What ISO/IEC 17025, 7.8 asks for.
  std::string figures_missing;    ///< "2 figures missing"; empty: all are there.
  bool has_gear{};                ///< Else motor and joint are one, and all stands at the joint.
  std::vector<QuantityRow> quantities;
  FrictionSpeeds friction_speeds;
  std::string last_day;  ///< Of the calibration that changes are counted from; empty: none.
  std::string last_id;
  std::vector<DataCheckRow> data_checks;
  std::vector<DataCheckRow> rules;  ///< Of the verdict, in the same columns.
  Table key_numbers;
  std::vector<BudgetRow> budget;
  std::string limiting_effect;           ///< May be empty.
  std::vector<Section> sections;         ///< Stages 1 to 8, then what was recorded beyond.
  std::vector<std::string> notes;        ///< From reading the input.
  std::vector<Table> conversion_tables;  ///< From the log to the motor shaft; speeds.
  std::vector<Table> provenance_tables;
  std::string command_line;
  std::string created_utc;
  std::string tool;  ///< "tribolog 0.2.0 (revision ...)"
};

/// Figures and drawn pictures pair up by id. A figure whose picture is missing or has an error
/// becomes a card that says so; a picture without a figure is left out.
/// `drawn` must outlive the view. @param since_last from the joint's calibration before to this
/// one. @param id of the content, hexadecimal: the report's number where the manifest has none.
ReportView make_report_view(const calibration::Calibration& calibration,
                            const std::vector<figures::ReportFigure>& figures,
                            const std::vector<render::workers::DrawnFigure>& drawn,
                            const calibration::Provenance& provenance,
                            const std::optional<history::Comparison>& since_last = std::nullopt,
                            const std::string& id = {});

}  // namespace tribolog::report::document
