#pragma once
// The clock of a log that has none: its rows come at a rate that is stated.

#include <cstddef>
#include <string>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::log {

/// "row / 1000 Hz": what the clock goes by.
std::string name_of_row_clock(double rate_Hz);

/// In seconds from the first row on. @param rate_Hz > 0.
LogColumn row_clock(double rate_Hz, std::size_t rows);

}  // namespace tribolog::ingest::log
