#pragma once
// The clock of a log: its unit, its rate and what is wrong with it.

#include <cstddef>
#include <string>
#include <vector>

#include "ingest/layout/log_layout.h"
#include "ingest/log/log_table.h"

namespace tribolog::inspect::survey {

struct ClockGap {
  double at_s{};
  double length_s{};
};

struct ClockSurvey {
  std::string column;     ///< As the log names it.
  std::string unit;       ///< "s", "ms", "us" or "ns"; "iso8601".
  bool unit_is_stated{};  ///< By the header or the logger; else told by the magnitude of its steps.
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
};

/// @param column the log's clock. @param meaning its unit, where it is stated.
ClockSurvey survey_clock(const ingest::log::LogColumn& column,
                         const ingest::layout::ColumnMeaning& meaning, bool is_iso);

}  // namespace tribolog::inspect::survey
