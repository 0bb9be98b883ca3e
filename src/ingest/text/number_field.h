#pragma once
// One field of a log as a number, the same under every locale.

#include <string_view>

namespace tribolog::ingest::text {

enum class FieldKind {
  number,
  gap,       ///< Empty, nan, inf, null, n/a and the like.
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

}  // namespace tribolog::ingest::text
