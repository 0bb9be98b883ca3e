#pragma once
// A file that never reaches a disk, for readers that take a path.

#include <cstdint>
#include <cstdlib>
#include <string>

#include <unistd.h>

namespace tribolog::fuzz {

/// In shared memory under a name of its own: SQLite and libhdf5 resolve a path before they open
/// it, so that a file without a name (memfd) is one they cannot open.
class FileInMemory {
 public:
  FileInMemory() : path_("/dev/shm/tribolog-fuzz-XXXXXX"), descriptor_(::mkstemp(path_.data())) {
    if (descriptor_ < 0) std::abort();
  }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;
  ~FileInMemory() {
    ::close(descriptor_);
    ::unlink(path_.c_str());
  }

  /// The path of these bytes.
  const std::string& holding(const std::uint8_t* data, std::size_t size) {
    const auto length = static_cast<ssize_t>(size);
    if (::ftruncate(descriptor_, length) != 0) std::abort();
    if (::pwrite(descriptor_, data, size, 0) != length) std::abort();
    return path_;
  }

 private:
  std::string path_;
  int descriptor_;
};

}  // namespace tribolog::fuzz
