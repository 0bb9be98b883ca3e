#pragma once
// The header row of a log.

#include <string>
#include <vector>

#include "error.h"
#include "ingest/csv_dialect.h"

namespace tribolog {

/// Refuses a header with broken UTF-8, with the same name twice, or made of numbers.
/// @throw InputError at the field in question.
void check_header(const std::vector<Field>& header, const Location& line);

/// Index of the column with this name; the full text counts first, then the name without its unit.
/// @throw InputError if there is none (listing those that are, and the closest) or several.
std::size_t find_column(const std::vector<Field>& header, const std::string& name,
                        const std::string& hint_if_missing, const Location& line);

/// Under blanks as delimiter "tau [Nm]" falls into two fields; joins them again.
std::vector<Field> join_units(std::vector<Field> header);

}  // namespace tribolog
