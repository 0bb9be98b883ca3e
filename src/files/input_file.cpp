#include "files/input_file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include "error.h"

namespace tribolog {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what,
                         const std::string& hint = {}) {
  throw InputError({path, 0, 0}, {what, "", "", hint});
}

std::string reason(int error) { return std::generic_category().message(error); }

int open_for_reading(const std::string& path) {
  if (path.find('\0') != std::string::npos) refuse(path, "cannot open: NUL byte in the file name");
  // O_NONBLOCK: opening a pipe that nobody writes to must not wait.
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

}  // namespace

InputFile::InputFile(const std::string& path) : path_(path), file_(open_for_reading(path)) {
  if (!file_.is_open()) refuse(path, "cannot open: " + reason(errno));
  struct stat status {};
  if (::fstat(file_.get(), &status) != 0) refuse(path, "cannot open: " + reason(errno));
  if (S_ISDIR(status.st_mode)) refuse(path, "cannot read: is a directory");
  if (!S_ISREG(status.st_mode)) {
    refuse(path, "cannot read: is not a regular file", "devices and pipes are not read");
  }
  bytes_ = static_cast<std::uint64_t>(status.st_size);
}

std::size_t InputFile::read(char* to, std::size_t most) {
  for (;;) {
    const ssize_t got = ::read(file_.get(), to, most);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) refuse(path_, "cannot read: " + reason(errno));
  }
}

}  // namespace tribolog
