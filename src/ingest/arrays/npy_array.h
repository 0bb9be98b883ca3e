#pragma once
// One NumPy array.

#include <string>
#include <string_view>

#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::arrays {

/// What the fields of an array of records are called.
enum class RecordNames {
  by_field,           ///< "q": where the array's name is only its file's.
  by_array_and_field  ///< "run.q"
};

/// Adds an array of numbers, booleans or times (datetime64 and timedelta64 in s, ms, us or ns, NaT
/// a gap), or a single text. Of an array of records each field is an array of its own, those of
/// nested records too; a field that is an array itself adds its dimensions. Objects, which are
/// pickles and could run code, complex numbers and texts are left out with the reason; with an
/// object in it, the whole array is one.
/// @throw InputError where the header is damaged, or the values are more or fewer than it says.
void add_npy_array(std::string_view bytes, const std::string& name, const std::string& file,
                   RecordNames names, FileArrays& found);

}  // namespace tribolog::ingest::arrays
