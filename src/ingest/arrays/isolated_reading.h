#pragma once
// Reading through a library that a damaged file may crash: in a process of its own.

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

}  // namespace tribolog::ingest::arrays
