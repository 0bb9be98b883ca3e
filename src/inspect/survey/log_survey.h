#pragma once
// What a log holds, as far as it shows by itself: format, tables, columns, clock, and the motion of
// each joint; and how that is stated to people and to programs. Guesses are marked as such.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/statement.h"
#include "ingest/layout/log_layout.h"
#include "ingest/log/log_format.h"
#include "ingest/log/log_table.h"
#include "ingest/log/register.h"
#include "ingest/text/csv_dialect.h"
#include "inspect/motion/motion_segments.h"
#include "inspect/survey/column_guess.h"
#include "inspect/survey/stated_columns.h"

namespace tribolog::inspect::survey {

// The clock: its unit, its rate and what is wrong with it.

struct ClockGap {
  double at_s{};
  double length_s{};
};

/// A column that is added to another to make the clock: nanoseconds, or a date.
struct ClockPartSurvey {
  std::string column;  ///< As the log names it,
  std::string key;     ///< and as a manifest does.
  std::string unit;
};

struct ClockSurvey {
  std::string column;  ///< As the log names it,
  std::string key;     ///< and as a manifest does.
  std::string unit;    ///< "s", "ms", "us", "ns" or a multiple; "iso8601", "hh:mm:ss".
  std::optional<ClockPartSurvey> plus;
  /// It counts samples of the rate that was stated: a lost one shows.
  bool is_counter{};
  double seconds_per_count{};  ///< Of a counter.
  bool unit_is_stated{};  ///< By the header or the logger; else guessed by the magnitude of its
                          ///< steps.
  bool is_proven{};       ///< Not stated, but the log's other numbers leave no other unit.
  std::string unit_by{};  ///< What an unstated unit was guessed by; empty: its steps.
  double seconds_per_unit{1};
  double origin{};  ///< In the clock's unit, taken off; 0 unless it counts from 1970.
  double first_s{};
  double last_s{};
  double interval_s{};      ///< Median step.
  double jitter_percent{};  ///< Scatter of the steps that are no gaps, of the median.
  std::size_t repeated{};   ///< Stamps that stand where the one before stood.
  std::size_t back{};       ///< Steps back.
  double largest_step_back_s{};
  std::vector<ClockGap> gaps;  ///< Steps of more than five intervals, in the order of time.
  std::size_t missing{};       ///< Rows without a time.

  [[nodiscard]] double rate_Hz() const { return interval_s > 0 ? 1 / interval_s : 0; }
  /// Whether a manifest may state it.
  [[nodiscard]] bool is_certain() const { return unit_is_stated || is_proven; }
  /// Whether a manifest has to state that the rate is meant.
  [[nodiscard]] bool has_odd_rate() const;
  /// @param seconds that one of the unit has.
  void change_unit(const std::string& to, double seconds);
};

/// @param column the log's clock. @param meaning its unit, where it is stated.
ClockSurvey survey_clock(const ingest::log::LogColumn& column,
                         const ingest::layout::ColumnMeaning& meaning);

// The log.

struct ColumnSurvey {
  std::string name;  ///< As the log has it; "#1" where it has none.
  std::string key;   ///< What a manifest calls it: "#4" where several have its name.
  std::string file;  ///< In which it stands, where not in the log's own; else empty.
  std::string unit;  ///< In brackets behind it or below; empty: none.
  std::optional<ingest::layout::ColumnMeaning> meaning;
  std::string guessed_by;  ///< What the meaning was guessed by, where not by the name; else empty.
  /// Of an effort: nothing but its place or its file's name says that it is one.
  bool is_guess{};
  std::string unit_by;    ///< What an unstated unit was guessed by; empty: nothing.
  bool unit_is_proven{};  ///< Not stated, but the log's other numbers leave no other.
  std::size_t gaps{};     ///< Rows without a number.
  double lowest{};        ///< NaN where all rows are gaps.
  double highest{};
  double step{};                     ///< In which its numbers come; 0: none was found.
  std::size_t distinct{};            ///< Different numbers, counted up to 1000.
  std::vector<std::string> words{};  ///< What it says, where it holds no numbers.
  std::optional<ingest::log::Register> of_register{};  ///< Its numbers lack their sign.
  bool is_at_motor{};     ///< An angle or a speed whose name says that it is the motor's,
  double gear_ratio{1};   ///< which is this many times the joint's, as far as it is known.
  bool has_gear{};        ///< A gear ratio other than 1 is stated.
  bool side_is_stated{};  ///< By the user.
  /// So wide beside a gear that it may be the motor's, though neither name nor user says so.
  bool side_is_open{};
  /// Whether a manifest may state unit and side.
  [[nodiscard]] bool is_certain() const {
    return meaning && (meaning->unit_is_stated || unit_is_proven) && !side_is_open;
  }
  [[nodiscard]] bool is_one_of_several() const { return file.empty() && key != name; }
  [[nodiscard]] bool is_constant() const { return distinct == 1; }
};

/// One joint's columns and what they do.
struct JointSurvey {
  std::string name;  ///< "0", "elbow"; empty: the log has none.
  std::size_t angle{};
  std::optional<std::size_t> speed;
  std::optional<std::size_t> effort;
  std::optional<std::size_t> temperature;
  std::vector<std::size_t> targets;  ///< Set points and model values of its effort.
  double lowest_rad{};               ///< Of the angle, with the unit that is guessed.
  double highest_rad{};
  std::size_t samples{};
  std::vector<motion::MotionSegment>
      segments;  ///< Empty where it does not move or there is no clock.

  [[nodiscard]] double range_rad() const { return highest_rad - lowest_rad; }
};

struct TableSurvey {
  std::vector<ingest::layout::ForeignUnit>
      foreign;        ///< Columns of a known quantity in an unknown unit.
  std::string group;  ///< Topic or variable; empty: the only one.
  std::size_t rows{};
  std::string logger;  ///< That is known; empty: none.
  std::vector<ColumnSurvey> columns;
  std::optional<std::size_t> time;  ///< Column of the clock.
  std::optional<ClockSurvey> clock;
  /// A column that counts rows or milliseconds, in a log without a clock; at a stated rate, one
  /// that shows lost samples and begins anew, so that it is no clock.
  std::string counter;
  std::vector<JointSurvey> joints;  ///< Those with an angle.
  /// Of a log in which each row is one joint's, or which holds several recordings: the column that
  /// tells which, as a manifest names it, and what stands there in these rows.
  std::optional<std::pair<std::string, std::string>> rows_of;
  bool is_one_of_several{};            ///< Recordings, which rows_of tells apart.
  bool has_impossible_values{};        ///< Single numbers that no joint has, taken as gaps.
  std::optional<ColumnGroups> groups;  ///< Of columns without names, where they come in such.
};

struct LogSurvey {
  std::string file;  ///< As given.
  ingest::log::LogFormat format{};
  std::string refusal;        ///< Why it cannot be read, for people; nothing else is there then.
  bool has_decimal_commas{};  ///< Found, or stated.
  std::vector<TableSurvey> tables;
  std::vector<Statement> notes;
};

/// @throw InputError for a log that cannot be read, or has not the columns that are stated.
LogSurvey survey_log(const std::string& path, const ingest::text::TextLogRules& rules = {},
                     const StatedColumns& stated = {});

// A recording in several files, one for each quantity.

struct FileOfQuantity {
  std::string path;
  ingest::log::Quantity quantity{};
};

struct FileSet {
  std::string path;                    ///< Of the angle; or of a log by itself.
  std::vector<FileOfQuantity> beside;  ///< Empty: it is by itself.
};

/// Files whose names, folders included, differ in the one word that names a quantity, one of them
/// an angle's: "pos1_run.t" and "tau1_run.t". Each path is in one of the sets, whose order is that
/// of their first ones.
std::vector<FileSet> sets_of_files(const std::vector<std::string>& paths);

/// The files as one log, where their content bears out what their names say: columns without names,
/// as many in each, a column for each joint behind a clock that is the same in all, or without any
/// at a stated rate.
/// @return nothing where it does not, or one of them cannot be read.
std::optional<LogSurvey> survey_set(const FileSet& set,
                                    const ingest::text::TextLogRules& rules = {},
                                    const StatedColumns& stated = {});

// Surveys as a person reads them: what `tribolog inspect` prints.

/// A block for each log; logs with the same columns share one, with a row for each. Fits into 100
/// places; control characters of a log are made visible.
/// @param joint whose motion the rows tell; empty: the one that moves most.
std::string survey_text(const std::vector<LogSurvey>& logs, const std::string& joint = "");

// Surveys as JSON: what `tribolog inspect --json` writes.

/// All of the surveys, in SI but for the columns' own ranges, which are in the log's unit.
/// @param manifest the proposed one; empty: none could be proposed.
std::string survey_json(const std::vector<LogSurvey>& logs, const std::string& manifest);

/// The logs that a path names: itself or, of a folder, what rosbag2's metadata.yaml lists, of a
/// data set of LeRobot the files of its data, else all files in it whose names end as those of
/// logs, by their names.
/// @throw InputError: a folder without any.
std::vector<std::string> log_files_in(const std::string& path);

}  // namespace tribolog::inspect::survey
