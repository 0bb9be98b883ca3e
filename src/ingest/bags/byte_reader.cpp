#include "ingest/bags/byte_reader.h"

#include <algorithm>
#include <cstdint>

namespace tribolog::ingest::bags {
namespace {

/// A small source gets a small buffer; where it grows meanwhile, it is read in more pieces.
std::size_t buffer_bytes(const ByteSource& source) {
  constexpr std::uint64_t least = 4096;
  constexpr std::uint64_t most = std::uint64_t{1} << 18;
  return std::clamp(source.likely_bytes(), least, most);
}

}  // namespace

ByteReader::ByteReader(ByteSource& source) : source_(source), buffer_(buffer_bytes(source), '\0') {}

std::string_view ByteReader::next(std::uint64_t most) {
  if (most == 0) return {};
  if (fetched_.empty()) fetched_ = {buffer_.data(), source_.read(buffer_.data(), buffer_.size())};
  const std::string_view bytes = fetched_.substr(0, std::min<std::uint64_t>(most, fetched_.size()));
  fetched_.remove_prefix(bytes.size());
  position_ += bytes.size();
  return bytes;
}

bool ByteReader::append(std::string& to, std::uint64_t bytes) {
  while (bytes > 0) {
    const std::string_view more = next(bytes);
    if (more.empty()) return false;
    to += more;
    bytes -= more.size();
  }
  return true;
}

std::uint64_t ByteReader::skip(std::uint64_t bytes) {
  std::uint64_t skipped = 0;
  while (skipped < bytes) {
    const std::string_view more = next(bytes - skipped);
    if (more.empty()) break;
    skipped += more.size();
  }
  return skipped;
}

}  // namespace tribolog::ingest::bags
