#pragma once
// A file that never reaches a disk, for readers that take a path.

#include <cstdint>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace tribolog::fuzz {

class FileInMemory {
 public:
  FileInMemory() : descriptor_(memfd_create("fuzz", 0)) {
    if (descriptor_ < 0) std::abort();
    path_ = "/proc/self/fd/" + std::to_string(descriptor_);
  }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;
  ~FileInMemory() { ::close(descriptor_); }

  /// The path of these bytes.
  const std::string& holding(const std::uint8_t* data, std::size_t size) {
    const auto length = static_cast<ssize_t>(size);
    if (::ftruncate(descriptor_, length) != 0) std::abort();
    if (::pwrite(descriptor_, data, size, 0) != length) std::abort();
    return path_;
  }

 private:
  int descriptor_;
  std::string path_;
};

}  // namespace tribolog::fuzz
