#include "archive/store/compressed.h"

#include <stdexcept>

#include <zstd.h>

#include "base/error.h"

namespace tribolog::archive {
namespace {

/// Dense where that costs little; a report is mostly pictures, which no effort makes much smaller.
int level_for(std::size_t bytes) {
  constexpr std::size_t few_bytes = std::size_t{1} << 19;
  return bytes <= few_bytes ? 19 : 9;
}

[[noreturn]] void refuse(const std::string& name) {
  throw ArchiveError(printable(name, longest_path) +
                     ": a document in the archive is damaged; restore a backup");
}

}  // namespace

std::string compressed(std::string_view bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t written =
      ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), level_for(bytes.size()));
  if (ZSTD_isError(written) != 0) {
    throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(written));
  }
  out.resize(written);
  return out;
}

std::string uncompressed(const std::string& stored, std::uint64_t bytes, const std::string& name) {
  // The length comes from the archive and may be damaged: only what the frame states is made room
  // for, and no more than a frame of this size can hold.
  constexpr std::uint64_t smallest_block = 4;
  if (ZSTD_getFrameContentSize(stored.data(), stored.size()) != bytes) refuse(name);
  if (bytes / ZSTD_BLOCKSIZE_MAX > stored.size() / smallest_block) refuse(name);
  std::string out(bytes, '\0');
  const std::size_t read = ZSTD_decompress(out.data(), out.size(), stored.data(), stored.size());
  if (ZSTD_isError(read) != 0 || read != bytes) refuse(name);
  return out;
}

}  // namespace tribolog::archive
