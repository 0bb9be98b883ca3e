#pragma once
// The variables of a MAT file, by matio. To be called under read_isolated().

#include <cstddef>
#include <string>

#include "ingest/arrays/array_tables.h"

namespace tribolog {

/// Reads the first `count` variables.
/// @return how many there were to read, at most `count`. @throw UnreadableFile
std::size_t read_mat_variables(const std::string& path, std::size_t count, FileArrays& found);

}  // namespace tribolog
