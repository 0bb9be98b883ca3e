#pragma once
// Reading through libraries that a damaged file may crash, in a process of its own; those for HDF5
// and MATLAB lie in a module that is loaded for such logs alone.

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::arrays {

/// What `read` throws to refuse the file, as one line without the file's name.
class UnreadableFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs `read` in a child process and takes over what it found. Whatever happens there, a crash, an
/// endless loop or a claim of more memory than the file can fill, is a refusal here. What the
/// library prints is not seen. Memory is bounded by 1 GiB and what the file could unpack to, at
/// most 24 GiB; computing time by 60 s and one second for each MiB of the file.
/// @throw InputError: the path is no regular file, is larger than largest_input_bytes, or `read`
///        threw, crashed or ran over a bound.
FileArrays read_isolated(const std::string& path, const std::function<FileArrays()>& read);

// What libhdf5 and matio read.

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
