#pragma once
// One field of a log's time column, to the nanosecond: a double holds seconds since 1970 to a
// quarter of a microsecond only.

#include <cstdint>
#include <optional>
#include <string_view>

#include "ingest/text/number_field.h"

namespace tribolog::ingest::text {

/// A time as whole units and the rest, 0 <= rest < 1: what a double cannot hold in one.
struct ClockReading {
  std::int64_t whole{};
  double rest{};

  /// This less the earlier one.
  [[nodiscard]] double since(const ClockReading& earlier) const {
    return static_cast<double>(whole - earlier.whole) + (rest - earlier.rest);
  }
};

/// A decimal number without exponent whose whole part an int64 holds; nothing otherwise.
std::optional<ClockReading> read_clock_number(std::string_view field,
                                              DecimalMark mark = DecimalMark::point);

/// ISO 8601 in seconds since 1970: "2026-03-01T08:15:00.250Z", a blank for the T, a comma for the
/// point, an offset "+01:00", "+0100" or "+01"; without one the clock is taken as it is. Nothing
/// for anything else, or a day or hour that does not exist.
std::optional<ClockReading> read_iso_time(std::string_view field);

}  // namespace tribolog::ingest::text
