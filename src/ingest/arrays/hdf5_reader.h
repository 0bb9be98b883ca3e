#pragma once
// Logs in HDF5.

#include <string>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::arrays {

/// Tables of an HDF5 file by the rule of tables_of(); a dataset is named by its path, "run/q", and
/// has the unit of its text attribute "units" or "unit". Numbers and enumerations (booleans of
/// h5py) are read; compound, text, reference and other types are left out with the reason.
///
/// Only what is in the file itself is read: soft and external links, external storage and virtual
/// datasets are left out with the reason, plugins are not loaded. The library runs in a process of
/// its own, see isolated_reading.h.
/// @throw InputError: the library is not installed; the file cannot be read, is no HDF5 file, is
/// damaged, or holds no rows.
std::vector<log::LogTable> read_hdf5(const std::string& path);

}  // namespace tribolog::ingest::arrays
