#include "ingest/log/row_clock.h"

#include <fmt/format.h>

namespace tribolog::ingest::log {

std::string name_of_row_clock(double rate_Hz) { return fmt::format("row / {} Hz", rate_Hz); }

LogColumn row_clock(double rate_Hz, std::size_t rows) {
  LogColumn clock;
  clock.header.full = clock.header.name = name_of_row_clock(rate_Hz);
  clock.values.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) clock.values[i] = static_cast<double>(i) / rate_Hz;
  return clock;
}

}  // namespace tribolog::ingest::log
