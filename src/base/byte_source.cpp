#include "base/byte_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <unistd.h>

#include "base/regular_file.h"

namespace tribolog {

std::size_t MemorySource::read(char* to, std::size_t most) {
  const std::size_t bytes = std::min(most, rest_.size());
  std::memcpy(to, rest_.data(), bytes);
  rest_.remove_prefix(bytes);
  return bytes;
}

InputFileSource::InputFileSource(const std::string& path, std::uint64_t largest_bytes)
    : path_(path),
      file_(open_regular_file(path)),
      largest_bytes_(largest_bytes),
      likely_bytes_(size_of_regular_file(file_.get(), path, largest_bytes)) {}

std::size_t InputFileSource::read(char* to, std::size_t most) {
  const bool has_size = likely_bytes_ > 0;
  if (has_size) most = std::min<std::uint64_t>(most, likely_bytes_ - bytes_read_);
  if (most == 0) return 0;
  for (;;) {
    const ssize_t got = ::read(file_.get(), to, most);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_unreadable(path_, errno);
    const auto bytes = static_cast<std::size_t>(got);
    if (has_size && bytes == 0) refuse_shortened(path_, bytes_read_, likely_bytes_);
    bytes_read_ += bytes;
    if (bytes_read_ > largest_bytes_) refuse_too_large(path_, largest_bytes_);
    return bytes;
  }
}

bool InputFileSource::has_grown() const {
  return likely_bytes_ > 0 && size_of_regular_file(file_.get(), path_, UINT64_MAX) > likely_bytes_;
}

std::size_t FingerprintedSource::read(char* to, std::size_t most) {
  const std::size_t bytes = source_.read(to, most);
  sha_.add({to, bytes});
  return bytes;
}

}  // namespace tribolog
