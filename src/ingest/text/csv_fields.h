#pragma once
// One row of a log as fields.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace tribolog {

enum class Delimiter : char { comma = ',', semicolon = ';', tab = '\t', spaces = ' ' };

struct Field {
  std::string text;      ///< Without quotes and without blanks around it.
  std::size_t column{};  ///< Of its first byte in the line; counts from 1.
};

inline constexpr std::size_t longest_field_bytes = 64 * 1024;
inline constexpr std::size_t most_columns = 65'536;

/// Splits a row. Quoted fields may hold delimiters and "" for a quote. With spaces as delimiter any
/// number of blanks counts as one.
/// @throw InputError at the opening quote of a field that does not end in its line, at a field
///        longer than 64 KiB, or for more than 65536 columns.
std::vector<Field> split_row(std::string_view row, Delimiter delimiter, const Location& line);

}  // namespace tribolog
