#pragma once
// Numbers and times of a NumPy array, from their places in its bytes to doubles.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/npy_type.h"

namespace tribolog {

/// "<f8" in parts; "<M8[ns]" with its unit.
struct NpyNumberType {
  bool big_endian{};
  char kind{};
  std::size_t bytes{};
  std::string unit;
};

/// nullopt where it is no type of numbers, booleans or times that is read.
std::optional<NpyNumberType> npy_number_type(const std::string& type);

/// Appends the values of an array's dimensions, the last one fastest, to `array.values`.
/// @param first offset of the first value; the caller has checked that all lie in `bytes`.
/// @param dimensions of which no more than two are longer than 1.
void append_npy_values(const NpyNumberType& type, std::string_view bytes, std::uint64_t first,
                       const std::vector<NpyDimension>& dimensions, NamedArray& array);

}  // namespace tribolog
