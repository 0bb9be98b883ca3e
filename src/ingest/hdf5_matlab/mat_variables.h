#pragma once
// The variables of a MAT file, by matio.

#include <cstddef>
#include <string>

#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::hdf5_matlab {

/// As ArrayLibraries::read_mat_variables.
std::size_t read_mat_variables(const std::string& path, std::size_t count,
                               arrays::FileArrays& found);

}  // namespace tribolog::ingest::hdf5_matlab
