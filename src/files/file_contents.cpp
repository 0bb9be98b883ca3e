#include "files/file_contents.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include "error.h"
#include "files/file_descriptor.h"

namespace tribolog {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what,
                         const std::string& hint = {}) {
  throw InputError({path, 0, 0}, {what, "", "", hint});
}

std::string reason(int error) { return std::generic_category().message(error); }

void refuse_too_large(const std::string& path, std::uint64_t largest_bytes) {
  refuse(path, "file is larger than the bound of " + std::to_string(largest_bytes) + " bytes",
         "split it, or leave out columns that are not needed");
}

int open_to_read(const std::string& path) {
  if (path.find('\0') != std::string::npos) refuse(path, "cannot open: NUL byte in the file name");
  // O_NONBLOCK: opening a pipe that nobody writes to must not wait.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) refuse(path, "cannot open: " + reason(errno));
  return descriptor;
}

std::uint64_t size_of_regular(const FileDescriptor& file, const std::string& path,
                              std::uint64_t largest_bytes) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) refuse(path, "cannot open: " + reason(errno));
  if (S_ISDIR(status.st_mode)) refuse(path, "cannot read: is a directory");
  if (!S_ISREG(status.st_mode)) {
    refuse(path, "cannot read: is not a regular file", "devices and pipes are not read");
  }
  const auto bytes = static_cast<std::uint64_t>(status.st_size);
  if (bytes > largest_bytes) refuse_too_large(path, largest_bytes);
  return bytes;
}

}  // namespace

std::uint64_t size_of_file(const std::string& path, std::uint64_t largest_bytes) {
  return size_of_regular(FileDescriptor(open_to_read(path)), path, largest_bytes);
}

std::string read_file(const std::string& path, std::uint64_t largest_bytes) {
  const FileDescriptor file(open_to_read(path));
  const std::uint64_t expected_bytes = size_of_regular(file, path, largest_bytes);

  constexpr std::size_t chunk = std::size_t{1} << 24;
  std::string bytes;
  bytes.reserve(expected_bytes + 1);
  for (std::size_t filled = 0;;) {
    const std::size_t known_rest = expected_bytes > filled ? expected_bytes - filled : 0;
    bytes.resize(filled + std::min(chunk, known_rest + 1));
    const ssize_t got = ::read(file.get(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(path, "cannot read: " + reason(errno));
    filled += static_cast<std::size_t>(got);
    if (got == 0) {
      bytes.resize(filled);
      return bytes;
    }
    if (filled > largest_bytes) refuse_too_large(path, largest_bytes);
  }
}

}  // namespace tribolog
