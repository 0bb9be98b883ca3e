#pragma once
// What libhdf5 and matio read, in a module that is loaded for logs of theirs alone.

#include <cstddef>
#include <string>

#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::arrays {

/// To be called under read_isolated().
struct ArrayLibraries {
  /// What an HDF5 file holds, by libhdf5. @throw UnreadableFile
  FileArrays (*hdf5_arrays)(const std::string& path);
  /// Does some link, storage or virtual dataset of the file lead to another file?
  /// @throw UnreadableFile
  bool (*hdf5_leads_to_other_files)(const std::string& path);
  /// The first `count` variables of a MAT file, by matio.
  /// @return how many there were to read, at most `count`. @throw UnreadableFile
  std::size_t (*read_mat_variables)(const std::string& path, std::size_t count, FileArrays& found);
};

/// Loads the module. @param path of the log that is to be read
/// @throw InputError: it, or a library that it stands on, is missing.
ArrayLibraries array_libraries(const std::string& path);

}  // namespace tribolog::ingest::arrays

/// What the module tribolog_arrays gives to the program.
extern "C" __attribute__((visibility("default"))) void tribolog_array_libraries(
    tribolog::ingest::arrays::ArrayLibraries& libraries);
