#pragma once
// What an HDF5 file holds, by libhdf5. To be called under read_isolated().

#include <string>

#include "ingest/arrays/array_tables.h"

namespace tribolog {

/// @throw UnreadableFile
FileArrays hdf5_arrays(const std::string& path);

/// Does some link, storage or virtual dataset of the file lead to another file?
/// @throw UnreadableFile
bool hdf5_leads_to_other_files(const std::string& path);

}  // namespace tribolog
