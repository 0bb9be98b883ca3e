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

namespace tribolog::report {

struct Column {
  std::string heading;
  std::string unit;      ///< Shown in brackets below the heading; empty: none.
  bool is_number{true};  ///< Right-aligned, tabular digits.
  bool is_wide{false};   ///< Words that should not be squeezed into one per line.
};

struct Row {
  std::vector<std::string> cells;  ///< One per column; the first is the row's heading.
  bool is_chosen{false};           ///< Emphasised: the value to use.
};

/// A table without rows is not printed.
struct Table {
  std::string id;  ///< Anchor, "table-..."
  std::string caption;
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::string note;   ///< Below the table; empty: none.
  bool is_stacked{};  ///< On a narrow screen each row is a list of named values.
  bool is_of_estimates{};
};

struct Fact {
  std::string name;
  std::string text;
};

struct FigureCard {
  std::string id;
  std::string heading;  ///< "Figure 15: Friction hysteresis"
  std::string caption;
  std::string how_to_read;
  std::string alt;
  const std::vector<std::byte>* png{nullptr};  ///< Null if the figure is missing.
  int width_px{};
  int height_px{};
  bool is_lazy{false};
  std::string error;  ///< Why the figure is missing.
  std::vector<std::string> warnings;
  std::string csv;  ///< The data behind it; empty: it shows none.
};

/// How far a stage came; decides icon, word and colour.
enum class Outcome { good, partial, bad, absent };

struct Section {
  int number{};
  std::string id;  ///< "stage-3"
  std::string title;
  std::string explanation;  ///< File name of the template that explains the stage.
  Outcome outcome{Outcome::absent};
  std::string status;      ///< The outcome in words: "not identifiable".
  std::string reason;      ///< Of the stage's report; may be empty if done.
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
  std::string estimate;      ///< With its unit; may be empty.
  std::string interval;      ///< "3.8789 … 3.8875"; may be empty.
  std::vector<LimitCell> limits;
  std::string change;        ///< Since the last calibration, with its unit; may be empty.
  std::string change_range;  ///< Of its interval: "± 0.0047"; may be empty.
  std::string change_word;   ///< "no change seen"; empty: there is none to compare with.
  bool is_changed{};
  std::vector<std::string> reasons;
  std::string experiment;  ///< What to record next; may be empty.
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

struct MissingResult {
  std::string stage;
  std::string section_id;
  std::string reason;
  std::string experiment;
};

struct ReportView {
  std::string title;  ///< Of the document: robot and joint.
  std::string subtitle;
  std::vector<Fact> identity;  ///< Robot, serial, joint, date...
  std::string note;            ///< The operator's note; may be empty.
  Outcome verdict{Outcome::absent};
  std::string verdict_word;  ///< "USABLE"
  std::string verdict_sentence;
  std::vector<std::string> findings;
  std::string figures_missing;  ///< "2 figures missing"; empty: all are there.
  std::vector<QuantityRow> quantities;
  std::string last_day;  ///< Of the calibration that changes are counted from; empty: none.
  std::string last_id;
  std::vector<DataCheckRow> data_checks;
  std::vector<DataCheckRow> rules;  ///< Of the verdict, in the same columns.
  Table key_numbers;
  Table budget;  ///< Of the uncertainty of each quantity.
  std::vector<MissingResult> missing;
  std::vector<Section> sections;         ///< Stages 1 to 8, then what was recorded beyond.
  std::vector<std::string> notes;        ///< From reading the input.
  std::vector<Table> conversion_tables;  ///< From the log to the motor shaft; speeds.
  std::vector<Table> provenance_tables;
  std::string command_line;
  std::string created_utc;
  std::string tool;  ///< "tribolog 0.1.0 (revision ...)"
};

/// Figures and drawn pictures pair up by id. A figure whose picture is missing or has an error
/// becomes a card that says so; a picture without a figure is left out.
/// `drawn` must outlive the view. @param since_last from the joint's calibration before to this
/// one.
ReportView make_report_view(const calibration::Calibration& calibration,
                            const std::vector<figures::ReportFigure>& figures,
                            const std::vector<render::workers::DrawnFigure>& drawn,
                            const calibration::Provenance& provenance,
                            const std::optional<history::Comparison>& since_last = std::nullopt);

}  // namespace tribolog::report
