#pragma once
// An input file, read piece by piece.

#include <cstddef>
#include <cstdint>
#include <string>

#include "files/file_descriptor.h"

namespace tribolog {

/// A regular file, open for reading from its start on. It is read, not mapped: a file that shrinks
/// meanwhile gives fewer bytes and never a signal.
class InputFile {
 public:
  /// @throw InputError naming the file: it cannot be opened (with the system's reason), is a
  ///        directory, or is not a regular file (device, pipe, socket).
  explicit InputFile(const std::string& path);

  /// Size at the moment of opening.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// Reads up to `most` bytes. @return how many; 0 only at the end of the file.
  /// @throw InputError with the system's reason.
  std::size_t read(char* to, std::size_t most);

 private:
  std::string path_;
  FileDescriptor file_;
  std::uint64_t bytes_{};
};

}  // namespace tribolog
