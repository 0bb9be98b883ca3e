#pragma once
// What a log holds, as far as it tells by itself: format, tables, columns, clock, and the motion of
// each joint. Guesses are marked as such.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "ingest/layout/log_layout.h"
#include "ingest/log/log_format.h"
#include "ingest/text/csv_dialect.h"
#include "inspect/motion/motion_segments.h"
#include "inspect/survey/clock_survey.h"

namespace tribolog::inspect::survey {

struct ColumnSurvey {
  std::string name;  ///< As the log has it.
  std::string unit;  ///< In brackets behind it or below; empty: none.
  std::optional<ingest::layout::ColumnMeaning> meaning;
  std::string guessed_by;  ///< What the meaning was told by, where not by the name; else empty.
  std::size_t gaps{};      ///< Rows without a number.
  double lowest{};         ///< NaN where all rows are gaps.
  double highest{};
  double step{};           ///< In which its numbers come; 0: none was found.
  std::size_t distinct{};  ///< Different numbers, counted up to 1000.
  [[nodiscard]] bool is_constant() const { return distinct == 1; }
};

/// One joint's columns and what they do.
struct JointSurvey {
  std::string name;  ///< "0", "elbow"; empty: the log tells none.
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
  std::vector<JointSurvey> joints;  ///< Those with an angle.
};

struct LogSurvey {
  std::string file;  ///< As given.
  ingest::log::LogFormat format{};
  std::string refusal;  ///< Why it cannot be read, for people; nothing else is there then.
  std::vector<TableSurvey> tables;
  std::vector<Statement> notes;
};

/// @throw InputError for a log that cannot be read.
LogSurvey survey_log(const std::string& path, const ingest::text::TextLogRules& rules = {});

}  // namespace tribolog::inspect::survey
