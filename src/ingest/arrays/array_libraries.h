#pragma once
// What libhdf5 and matio read, in a module that is loaded for logs of theirs alone.

#include <string>

#include "ingest/arrays/hdf5_walk.h"
#include "ingest/arrays/mat_variables.h"

namespace tribolog {

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
