#include "files/file_contents.h"

#include <algorithm>

#include "error.h"
#include "files/input_file.h"

namespace tribolog {
namespace {

void refuse_too_large(const std::string& path, std::uint64_t largest_bytes) {
  throw InputError({path, 0, 0},
                   {"file is larger than the bound of " + std::to_string(largest_bytes) + " bytes",
                    "", "", "split it, or leave out columns that are not needed"});
}

}  // namespace

std::string read_file(const std::string& path, std::uint64_t largest_bytes) {
  InputFile file(path);
  if (file.bytes() > largest_bytes) refuse_too_large(path, largest_bytes);

  constexpr std::size_t chunk = std::size_t{1} << 24;
  std::string bytes;
  bytes.reserve(file.bytes() + 1);
  for (std::size_t filled = 0;;) {
    const std::size_t known_rest = file.bytes() > filled ? file.bytes() - filled : 0;
    bytes.resize(filled + std::min(chunk, known_rest + 1));
    const std::size_t got = file.read(bytes.data() + filled, bytes.size() - filled);
    filled += got;
    if (got == 0) {
      bytes.resize(filled);
      return bytes;
    }
    if (filled > largest_bytes) refuse_too_large(path, largest_bytes);
  }
}

}  // namespace tribolog
