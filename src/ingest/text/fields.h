#pragma once
// What a field of a text log says: a number, or a time.

#include <cstdint>
#include <optional>
#include <string_view>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::text {

// One field of a log as a number, the same under every locale.

enum class FieldKind {
  number,
  gap,       ///< Empty, nan, inf, null, n/a, a dash and the like.
  overflow,  ///< A number larger than any double.
  text,      ///< Anything else.
};

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

enum class DecimalMark { point, comma };

struct NumberField {
  FieldKind kind{FieldKind::text};
  double value{};  ///< NaN for a gap, 0 for a number too small for a double.
};

/// Without blanks and tabs around it.
std::string_view trimmed(std::string_view text);

/// Reads a whole field: decimal numbers with point and exponent, "+1", "1.", ".5". Not accepted:
/// hexadecimal, "1d3", thousands separators, anything after the number, and the other mark than the
/// one stated.
NumberField read_number(std::string_view field, DecimalMark mark = DecimalMark::point);

/// "1,25": what a decimal comma looks like.
bool looks_like_decimal_comma(std::string_view field);

/// "1,234.5", "1 234.5", "1'234": what separators of thousands look like.
bool looks_like_thousands(std::string_view field, DecimalMark mark = DecimalMark::point);

/// "-", "1.5e", "na": what the start of a number looks like when a file is cut off.
bool looks_like_cut_number(std::string_view field, DecimalMark mark = DecimalMark::point);

// One field of a log's time column, to the nanosecond: a double holds seconds since 1970 to a
// quarter of a microsecond only.

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

/// In seconds since midnight: "08:15:00.250", "8:15:00", a comma for the point. Nothing for
/// anything else, or an hour that does not exist.
std::optional<ClockReading> read_time_of_day(std::string_view field);

/// In seconds from 1970 to its midnight: "2026-03-01", "2026/03/01" and "01.03.2026", whose order
/// of day and month is beyond doubt. Nothing for anything else, or a day that does not exist.
std::optional<ClockReading> read_date(std::string_view field);

/// As the column's reading says. Nothing for a field without it, and for a reading that is no
/// time.
std::optional<ClockReading> read_time(std::string_view field, log::ColumnReading reading,
                                      DecimalMark mark = DecimalMark::point);

}  // namespace tribolog::ingest::text
