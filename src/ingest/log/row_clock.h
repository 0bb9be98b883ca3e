#pragma once
// Clocks that no single column of a log holds: its rows come at a rate that is stated, the clock
// stands in two columns, or it begins anew at midnight.

#include <cstddef>
#include <string>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::log {

/// "row / 1000 Hz": what the clock goes by.
std::string name_of_row_clock(double rate_Hz);

/// In seconds from the first row on. @param rate_Hz > 0.
LogColumn row_clock(double rate_Hz, std::size_t rows);

/// Of a clock that counts from 1970 the whole units of its first reading are taken off, as a text
/// log's are.
void count_from_first(LogColumn& clock);

/// Adds the second part of a clock that stands in two columns: nanoseconds to seconds, a date to a
/// time of day. The sum counts as count_from_first() says.
/// @param factor the part's unit in that of the clock.
void add_to_clock(const LogColumn& part, double factor, LogColumn& clock);

/// Times of day behind midnight go on from those before it.
/// @return how often it is midnight.
std::size_t go_on_past_midnight(LogColumn& times_of_day);

/// Median of the rising steps, in the unit of the times; 0 where none rises. Gaps (NaN) and steps
/// back or of no length say nothing.
double median_clock_step(const std::vector<double>& times);

/// A clock that was set back while it was logged, as by a time server, goes on from the row before,
/// by the median step. Nothing happens where rows of several writers alternate, or the clock begins
/// anew as that of another log.
/// @return how often it was set back.
std::size_t go_on_past_set_back(LogColumn& clock);

}  // namespace tribolog::ingest::log
