#pragma once
// The variables of a MAT file, by matio.

#include <cstddef>
#include <string>

#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::hdf5_matlab {

/// Characters of a text that is read, from a MAT file or from HDF5.
inline constexpr std::size_t longest_text = 4096;

/// As ArrayLibraries::read_mat_variables.
std::size_t read_mat_variables(const std::string& path, std::size_t count,
                               arrays::FileArrays& found);

}  // namespace tribolog::ingest::hdf5_matlab
