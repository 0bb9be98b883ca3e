#include "base/input_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace tribolog {

// What may be opened, and how the rest is refused.

namespace {

/// @param now, before bytes.
[[noreturn]] void refuse_shortened(const std::string& path, std::uint64_t now,
                                   std::uint64_t before);
[[noreturn]] void refuse_unreadable(const std::string& path, int error);
[[noreturn]] void refuse_too_large(const std::string& path, std::uint64_t largest_bytes);

[[noreturn]] void refuse(const std::string& path, const std::string& what,
                         const std::string& hint = {}) {
  throw InputError({path, 0, 0}, {what, "", "", hint});
}

constexpr const char* save_it_first = "save what comes through it as a file first";

std::string reason(int error) { return std::generic_category().message(error); }

void refuse_unreadable(const std::string& path, int error) {
  refuse(path, "cannot read: " + reason(error));
}

void refuse_too_large(const std::string& path, std::uint64_t largest_bytes) {
  refuse(path, "file is larger than the bound of " + std::to_string(largest_bytes) + " bytes",
         "split it, or leave out columns that are not needed");
}

void refuse_shortened(const std::string& path, std::uint64_t now, std::uint64_t before) {
  throw InputError({path, 0, 0},
                   {"file has become shorter while it was read", std::to_string(now) + " bytes",
                    std::to_string(before), "is it still being written? read a copy of it"});
}

/// @return a descriptor, to be owned. @throw InputError: cannot be opened (with the system's
/// reason).
int open_regular_file(const std::string& path) {
  if (path.find('\0') != std::string::npos) refuse(path, "cannot open: NUL byte in the file name");
  if (path == "-") refuse(path, "standard input is not read", save_it_first);
  // O_NONBLOCK: opening a pipe that nobody writes to must not wait.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) refuse(path, "cannot open: " + reason(errno));
  return file;
}

/// @throw InputError: a directory, not a regular file (device, pipe, socket), larger than the
/// bound.
std::uint64_t size_of_regular_file(int descriptor, const std::string& path,
                                   std::uint64_t largest_bytes) {
  struct stat status{};
  if (::fstat(descriptor, &status) != 0) refuse(path, "cannot open: " + reason(errno));
  if (S_ISDIR(status.st_mode)) refuse(path, "cannot read: is a directory");
  if (S_ISFIFO(status.st_mode)) refuse(path, "cannot read: is a pipe", save_it_first);
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) {
    refuse(path, "cannot read: is a device", "a log is a file");
  }
  if (!S_ISREG(status.st_mode)) refuse(path, "cannot read: is not a regular file");
  const auto bytes = static_cast<std::uint64_t>(status.st_size);
  if (bytes > largest_bytes) refuse_too_large(path, largest_bytes);
  return bytes;
}

}  // namespace

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

std::string read_start(const std::string& path, std::size_t most_bytes) {
  InputFileSource file(path);
  std::string start(most_bytes, '\0');
  std::size_t filled = 0;
  while (filled < start.size()) {
    const std::size_t got = file.read(start.data() + filled, start.size() - filled);
    if (got == 0) break;
    filled += got;
  }
  start.resize(filled);
  return start;
}

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
    // A read may hand out NUL bytes in place of what is cut off at that moment: the size tells.
    if (has_size) refuse_if_shortened();
    bytes_read_ += bytes;
    if (bytes_read_ > largest_bytes_) refuse_too_large(path_, largest_bytes_);
    return bytes;
  }
}

void InputFileSource::read_at(std::uint64_t at, char* to, std::size_t bytes) const {
  while (bytes > 0) {
    const ssize_t got = ::pread(file_.get(), to, bytes, static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_unreadable(path_, errno);
    refuse_if_shortened();
    if (got == 0) refuse_shortened(path_, at, at + bytes);
    at += static_cast<std::uint64_t>(got);
    to += got;
    bytes -= static_cast<std::size_t>(got);
  }
}

void InputFileSource::refuse_if_shortened() const {
  const std::uint64_t now = size_of_regular_file(file_.get(), path_, UINT64_MAX);
  if (now < likely_bytes_) refuse_shortened(path_, now, likely_bytes_);
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
