#include "base/file_contents.h"

#include <algorithm>

#include "base/byte_source.h"
#include "base/regular_file.h"

namespace tribolog {

std::uint64_t size_of_file(const std::string& path, std::uint64_t largest_bytes) {
  const FileDescriptor file(open_regular_file(path));
  return size_of_regular_file(file.get(), path, largest_bytes);
}

std::string read_file(const std::string& path, std::uint64_t largest_bytes) {
  InputFileSource file(path, largest_bytes);
  constexpr std::size_t chunk = std::size_t{1} << 24;
  std::string bytes;
  bytes.reserve(file.likely_bytes() + 1);
  for (std::size_t filled = 0;;) {
    const std::size_t likely = file.likely_bytes();
    const std::size_t known_rest = likely > filled ? likely - filled : 0;
    bytes.resize(filled + std::min(chunk, known_rest + 1));
    const std::size_t got = file.read(bytes.data() + filled, bytes.size() - filled);
    filled += got;
    if (got > 0) continue;
    bytes.resize(filled);
    return bytes;
  }
}

}  // namespace tribolog
