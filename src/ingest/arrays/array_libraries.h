#pragma once
// What libhdf5 and matio read, in a module that is loaded for logs of theirs alone.

#include <cstddef>
#include <string>

#include "ingest/arrays/array_tables.h"

namespace tribolog {

/// @throw UnreadableFile
FileArrays hdf5_arrays(const std::string& path);

/// Does some link, storage or virtual dataset of the file lead to another file?
/// @throw UnreadableFile
bool hdf5_leads_to_other_files(const std::string& path);

// The variables of a MAT file, by matio. To be called under read_isolated().

/// Reads the first `count` variables.
/// @return how many there were to read, at most `count`. @throw UnreadableFile
std::size_t read_mat_variables(const std::string& path, std::size_t count, FileArrays& found);

struct ArrayLibraries {
  decltype(&tribolog::hdf5_arrays) hdf5_arrays;
  decltype(&tribolog::hdf5_leads_to_other_files) hdf5_leads_to_other_files;
  decltype(&tribolog::read_mat_variables) read_mat_variables;
};

/// Loads the module. @param path of the log that is to be read
/// @throw InputError: it, or a library that it stands on, is missing.
ArrayLibraries array_libraries(const std::string& path);

}  // namespace tribolog

/// What the module tribolog_arrays gives to the program.
extern "C" __attribute__((visibility("default"))) void tribolog_array_libraries(
    tribolog::ArrayLibraries& libraries);
