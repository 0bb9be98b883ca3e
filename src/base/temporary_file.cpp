#include "base/temporary_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <sys/stat.h>

namespace tribolog {
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
