#include "files/atomic_file.h"

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

#include "error.h"
#include "files/temporary_file.h"

namespace tribolog {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  constexpr std::size_t longest_path = 4096;
  throw OutputError(printable(path, longest_path) + ": cannot write: " + why);
}

[[noreturn]] void refuse(const std::string& path, int error) {
  refuse(path, std::generic_category().message(error));
}

/// The file itself, where the path is a link to one.
fs::path resolved(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::canonical(path, error);
  return error ? fs::path(path) : target;
}

void refuse_what_is_no_file(const std::string& path, const fs::path& target) {
  if (path.empty()) refuse(path, "the file name is empty");
  if (path.find('\0') != std::string::npos) refuse(path, "NUL byte in the file name");
  std::error_code error;
  const fs::file_status status = fs::symlink_status(target, error);
  if (fs::is_directory(status) || path.back() == '/') refuse(path, "is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_symlink(status)) {
    refuse(path, "is not a regular file");
  }
}

fs::path directory_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

void write_all(const std::string& path, const FileDescriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(path, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// A directory's entries are flushed too; file systems that cannot do that say EINVAL.
void flush_directory(const std::string& path, const fs::path& directory) {
  const FileDescriptor handle(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (handle.is_open() && ::fsync(handle.get()) != 0 && errno != EINVAL) refuse(path, errno);
}

}  // namespace

void check_output_can_be_written(const std::string& path, const std::vector<std::string>& inputs) {
  const fs::path target = resolved(path);
  refuse_what_is_no_file(path, target);
  for (const std::string& input : inputs) {
    std::error_code error;
    if (fs::equivalent(target, input, error) && !error) {
      throw UsageError(printable(path, 4096) + ": is also an input; it would be overwritten");
    }
  }
  const fs::path directory = directory_of(target);
  std::error_code error;
  const fs::file_status status = fs::status(directory, error);
  if (!fs::exists(status)) refuse(path, "the directory does not exist");
  if (!fs::is_directory(status)) refuse(path, ENOTDIR);
  if (::access(directory.c_str(), W_OK | X_OK) != 0) refuse(path, errno);
}

struct AtomicFiles::Pending {
  std::string path;
  fs::path target;
  std::unique_ptr<TemporaryFile> temporary;
};

AtomicFiles::AtomicFiles() = default;
AtomicFiles::~AtomicFiles() = default;

void AtomicFiles::add(const std::string& path, std::string_view bytes) {
  const fs::path target = resolved(path);
  refuse_what_is_no_file(path, target);
  remove_stale_temporary_files(target);
  auto temporary = std::make_unique<TemporaryFile>(target);
  if (!temporary->file().is_open()) refuse(path, errno);
  write_all(path, temporary->file(), bytes);
  if (!temporary->open_to_others()) refuse(path, errno);
  // Any number of files may be pending: none is kept open until all are flushed.
  if (!temporary->file().close()) refuse(path, errno);
  pending_.push_back({path, target, std::move(temporary)});
}

void AtomicFiles::commit() {
  for (const Pending& file : pending_) {
    if (!file.temporary->flush()) refuse(file.path, errno);
  }
  std::map<fs::path, std::string> directories;
  for (const Pending& file : pending_) {
    if (!file.temporary->rename_to(file.target)) refuse(file.path, errno);
    directories.emplace(directory_of(file.target), file.path);
  }
  for (const auto& [directory, path] : directories) flush_directory(path, directory);
  pending_.clear();
}

void write_file_atomically(const std::string& path, std::string_view bytes) {
  AtomicFiles one;
  one.add(path, bytes);
  one.commit();
}

void create_directory(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!error && fs::is_directory(path, error)) return;
  if (!error) error = std::make_error_code(std::errc::not_a_directory);
  throw OutputError(printable(path, 4096) + ": cannot create the directory: " + error.message());
}

}  // namespace tribolog
