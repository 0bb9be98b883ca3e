#pragma once
// The header of a NumPy array: format versions 1 to 3.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/arrays/npy_type.h"

namespace tribolog {

struct NpyHeader {
  NpyType type;
  bool fortran_order{};
  std::vector<std::uint64_t> shape;
  std::size_t bytes{};  ///< Where the values start.
};

/// @throw InputError saying what is wrong with the header of array `name`.
NpyHeader read_npy_header(std::string_view bytes, const std::string& name, const std::string& file);

}  // namespace tribolog
