#pragma once
// One NumPy array.

#include <string>
#include <string_view>

#include "ingest/arrays/array_tables.h"

namespace tribolog {

/// Adds an array of numbers, booleans or times (datetime64 and timedelta64 in s, ms, us or ns, NaT
/// a gap), or a single text. Objects, which are pickles and could run code, complex numbers,
/// records and texts are left out with the reason.
/// @throw InputError where the header is damaged, or the values are more or fewer than it says.
void add_npy_array(std::string_view bytes, const std::string& name, const std::string& file,
                   FileArrays& found);

}  // namespace tribolog
