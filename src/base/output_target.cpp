#include "base/output_target.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file_descriptor.h"

namespace tribolog {
namespace {

namespace fs = std::filesystem;

/// The N of /proc/self/fd/N; -1 for all else.
int own_descriptor(const fs::path& link) {
  const std::string name = link.filename().string();
  constexpr std::size_t most_digits = 7;
  if (name.empty() || name.size() > most_digits ||
      !std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return -1;
  }
  std::error_code error;
  const fs::path own = fs::canonical("/proc/self/fd", error);
  if (error || fs::canonical(link.parent_path(), error) != own || error) return -1;
  return std::stoi(name);
}

OutputTarget open_descriptor(const std::string& path, int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags < 0) refuse_output(path, errno);
  if ((flags & O_ACCMODE) == O_RDONLY) {
    refuse_output(path, descriptor == STDOUT_FILENO ? "it is closed" : "is open only for reading");
  }
  return {OutputTarget::Kind::descriptor, path, descriptor};
}

/// /dev/null, /dev/zero and /dev/full take everything, as far as they do; a terminal shows it.
bool takes_a_file(const std::string& device, dev_t number) {
  constexpr unsigned memory_devices = 1;
  const unsigned which = minor(number);
  if (major(number) == memory_devices) return which == 3 || which == 5 || which == 7;
  const FileDescriptor opened(::open(device.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  return opened.is_open() && ::isatty(opened.get()) != 0;
}

/// What a path with all its links leads to; absent where nothing is there.
std::optional<OutputTarget> stream_at(const std::string& path) {
  struct stat status{};
  if (::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return std::nullopt;
  if (S_ISDIR(status.st_mode)) refuse_output(path, "is a directory");
  if (S_ISFIFO(status.st_mode) || (S_ISCHR(status.st_mode) && takes_a_file(path, status.st_rdev))) {
    return OutputTarget{OutputTarget::Kind::stream, path, -1};
  }
  refuse_output(path, "is not a regular file");
}

std::optional<struct stat> status_of(const OutputTarget& target) {
  struct stat status{};
  const int failed = target.kind == OutputTarget::Kind::descriptor
                         ? ::fstat(target.descriptor, &status)
                         : ::stat(target.path.c_str(), &status);
  return failed == 0 ? std::optional(status) : std::nullopt;
}

}  // namespace

fs::path full_name(const fs::path& file) {
  std::error_code error;
  const fs::path directory =
      fs::canonical(file.has_parent_path() ? file.parent_path() : fs::path("."), error);
  return error ? file : directory / file.filename();
}

std::string shown_output(const std::string& path) {
  return path == "-" ? "standard output" : printable(path, longest_path);
}

void refuse_output(const std::string& path, const std::string& why) {
  throw OutputError(shown_output(path) + ": cannot write: " + why);
}

void refuse_output(const std::string& path, int error) {
  refuse_output(path, std::generic_category().message(error));
}

OutputTarget output_target(const std::string& path) {
  constexpr int most_links = 40;
  if (path.empty()) refuse_output(path, "the file name is empty");
  if (path.find('\0') != std::string::npos) refuse_output(path, "NUL byte in the file name");
  if (path == "-") return open_descriptor(path, STDOUT_FILENO);
  fs::path at = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(at, error)); ++links) {
    if (links == most_links) refuse_output(path, ELOOP);
    if (const int descriptor = own_descriptor(at); descriptor >= 0) {
      return open_descriptor(path, descriptor);
    }
    const fs::path to = fs::read_symlink(at, error);
    if (error) refuse_output(path, error.value());
    at = at.parent_path() / to;
  }
  if (auto stream = stream_at(path)) return *stream;
  if (path.back() == '/') refuse_output(path, "is a directory");
  if (at != path && !fs::exists(at, error)) {
    refuse_output(
        path, "is a link to " + printable(at.string(), longest_path) + ", which does not exist");
  }
  return {OutputTarget::Kind::file, at, -1};
}

bool is_same(const OutputTarget& a, const OutputTarget& b) {
  if (a.kind == OutputTarget::Kind::descriptor && b.kind == a.kind &&
      a.descriptor == b.descriptor) {
    return true;
  }
  const auto of_a = status_of(a);
  const auto of_b = status_of(b);
  if (of_a && of_b) {
    return of_a->st_dev == of_b->st_dev && of_a->st_ino == of_b->st_ino && !S_ISCHR(of_a->st_mode);
  }
  return !of_a && !of_b && full_name(a.path) == full_name(b.path);
}

}  // namespace tribolog
