#include "base/output_place.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
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

// The temporary file.

namespace {

constexpr std::string_view random_part = "XXXXXX";

/// `.<name>.tmp-`, with the name cut where the whole would exceed what file systems allow.
std::string prefix_of(const std::filesystem::path& target) {
  constexpr std::size_t longest_name = 255;
  constexpr std::string_view tail = ".tmp-";
  std::string prefix = ".";
  prefix += target.filename().string();
  prefix.resize(std::min(prefix.size(), longest_name - tail.size() - random_part.size()));
  return prefix.append(tail);
}

bool is_temporary_of(std::string_view name, std::string_view prefix) {
  const auto is_letter_or_digit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  return name.size() == prefix.size() + random_part.size() &&
         name.substr(0, prefix.size()) == prefix &&
         std::all_of(name.end() - random_part.size(), name.end(), is_letter_or_digit);
}

/// @return the descriptor; -1: errno tells why.
int make(std::string& path, std::unique_ptr<Unfinished>& unfinished) {
  const Uninterrupted making;
  const int file = ::mkostemp(path.data(), O_CLOEXEC);
  if (file >= 0) unfinished = std::make_unique<Unfinished>(path);
  return file;
}

/// As the system lists it: to set it in order to read it would be seen by other threads.
mode_t current_umask() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    constexpr std::string_view name = "Umask:";
    if (line.starts_with(name)) {
      return static_cast<mode_t>(std::strtoul(line.c_str() + name.size(), nullptr, 8));
    }
  }
  const mode_t mask = ::umask(0);  // without /proc, or with Linux before 4.7
  ::umask(mask);
  return mask;
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& target)
    : path_((target.parent_path() / (prefix_of(target) + std::string(random_part))).string()),
      file_(make(path_, unfinished_)) {
  if (!file_.is_open()) path_.clear();
}

TemporaryFile::~TemporaryFile() {
  const Uninterrupted removing;
  if (!path_.empty()) ::unlink(path_.c_str());
  unfinished_.reset();
}

bool TemporaryFile::flush() const {
  const FileDescriptor handle(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
  return handle.is_open() && ::fsync(handle.get()) == 0;
}

bool TemporaryFile::open_to_others() const {
  return ::chmod(path_.c_str(), 0666 & ~current_umask()) == 0;
}

bool TemporaryFile::take_permissions_of(const std::filesystem::path& target) const {
  struct stat old{};
  if (::stat(target.c_str(), &old) != 0) return open_to_others();
  mode_t mode = old.st_mode & 0777;
  if (::chown(path_.c_str(), old.st_uid, old.st_gid) != 0 &&
      ::chown(path_.c_str(), static_cast<uid_t>(-1), old.st_gid) != 0) {
    // Another group than the old one: it gets no more than everybody has.
    mode = (mode & 0707) | ((mode & 07) << 3);
  }
  return ::chmod(path_.c_str(), mode) == 0;
}

bool TemporaryFile::link_to(const std::filesystem::path& target) {
  return ::link(path_.c_str(), target.c_str()) == 0;
}

bool TemporaryFile::rename_to(const std::filesystem::path& target) {
  if (std::rename(path_.c_str(), target.c_str()) != 0) return false;
  path_.clear();
  unfinished_.reset();
  return true;
}

bool TemporaryFile::exchange_with(const std::filesystem::path& target) const {
  struct stat old{};
  if (::lstat(target.c_str(), &old) != 0) return false;
  if (!S_ISREG(old.st_mode)) {
    errno = EINVAL;
    return false;
  }
  return ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0;
}

void remove_stale_temporary_files(const std::filesystem::path& target) {
  constexpr std::time_t one_day_s = 24 * 60 * 60;
  const std::string prefix = prefix_of(target);
  const std::filesystem::path directory = target.has_parent_path() ? target.parent_path() : ".";
  std::error_code error;
  std::filesystem::directory_iterator entry(directory, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (!is_temporary_of(entry->path().filename().string(), prefix)) continue;
    struct stat status{};
    if (::lstat(entry->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
    if (std::time(nullptr) - status.st_mtime > one_day_s) ::unlink(entry->path().c_str());
  }
}

}  // namespace tribolog
