#include "base/regular_file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include "base/error.h"

namespace tribolog {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what,
                         const std::string& hint = {}) {
  throw InputError({path, 0, 0}, {what, "", "", hint});
}

constexpr const char* save_it_first = "save what comes through it as a file first";

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

void refuse_unreadable(const std::string& path, int error) {
  refuse(path, "cannot read: " + reason(error));
}

void refuse_too_large(const std::string& path, std::uint64_t largest_bytes) {
  refuse(path, "file is larger than the bound of " + std::to_string(largest_bytes) + " bytes",
         "split it, or leave out columns that are not needed");
}

void refuse_shortened(const std::string& path, std::uint64_t read, std::uint64_t expected) {
  throw InputError({path, 0, 0},
                   {"file has become shorter while it was read", std::to_string(read) + " bytes",
                    std::to_string(expected), "is it still being written? read a copy of it"});
}

int open_regular_file(const std::string& path) {
  if (path.find('\0') != std::string::npos) refuse(path, "cannot open: NUL byte in the file name");
  if (path == "-") refuse(path, "standard input is not read", save_it_first);
  // O_NONBLOCK: opening a pipe that nobody writes to must not wait.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) refuse(path, "cannot open: " + reason(errno));
  return file;
}

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

}  // namespace tribolog
