#include "base/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/early_end.h"
#include "base/error.h"
#include "base/file_descriptor.h"
#include "base/output_place.h"
#include "base/standard_output.h"

namespace tribolog {
namespace {

namespace fs = std::filesystem;
using Kind = OutputTarget::Kind;

fs::path directory_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// A directory's entries are flushed too; file systems that cannot do that say EINVAL.
void flush_directory(const std::string& path, const fs::path& directory) {
  const FileDescriptor handle(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (handle.is_open() && ::fsync(handle.get()) != 0 && errno != EINVAL) {
    refuse_output(path, errno);
  }
}

void check_directory(const std::string& path, const fs::path& directory) {
  std::error_code error;
  const fs::file_status status = fs::status(directory, error);
  if (!fs::exists(status)) refuse_output(path, "the directory does not exist");
  if (!fs::is_directory(status)) refuse_output(path, ENOTDIR);
  if (::access(directory.c_str(), W_OK | X_OK) != 0) refuse_output(path, errno);
}

/// Into what is open already, or is opened like a file.
void write_through(const std::string& path, const OutputTarget& target, std::string_view bytes) {
  if (target.descriptor == STDOUT_FILENO) {
    print(bytes);
    finish_printing();
    return;
  }
  const FileDescriptor file(target.kind == Kind::descriptor
                                ? ::fcntl(target.descriptor, F_DUPFD_CLOEXEC, 0)
                                : ::open(target.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
  if (!file.is_open()) refuse_output(path, errno);
  const int failure = write_all(file.get(), bytes);
  if (failure != 0 && failure != EPIPE) refuse_output(path, failure);
}

[[noreturn]] void refuse_directory(const std::string& path, const std::error_code& error) {
  throw OutputError(printable(path, longest_path) +
                    ": cannot create the directory: " + error.message());
}

void refuse_standard_output(const std::string& directory) {
  if (directory != "-") return;
  throw UsageError(
      "-: several files are written here, and standard output takes one; state a directory "
      "(./- for one of that name)");
}

/// How a file took its place, and so how it leaves it again.
enum class Placed { exchanged, linked, renamed };

Placed place(TemporaryFile& made, const std::string& path, const fs::path& target) {
  if (made.exchange_with(target)) return Placed::exchanged;
  if (errno == ENOENT && made.link_to(target)) return Placed::linked;
  if (!made.rename_to(target)) refuse_output(path, errno);
  return Placed::renamed;
}

void take_back(TemporaryFile& made, const fs::path& target, Placed placed) {
  if (placed == Placed::exchanged) static_cast<void>(made.exchange_with(target));
  if (placed == Placed::linked) ::unlink(target.c_str());
}

}  // namespace

void check_output_can_be_written(const std::string& path, const std::vector<std::string>& inputs) {
  const OutputTarget target = output_target(path);
  for (const std::string& input : inputs) {
    if (!input.empty() && is_same(target, {Kind::file, input, -1})) {
      throw UsageError(shown_output(path) + ": is also an input; it would be overwritten");
    }
  }
  if (target.kind == Kind::file) check_directory(path, directory_of(target.path));
  if (target.kind == Kind::stream && ::access(path.c_str(), W_OK) != 0) refuse_output(path, errno);
}

void check_outputs_differ(const std::vector<std::string>& paths) {
  std::vector<std::pair<std::string, OutputTarget>> known;
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    const OutputTarget target = output_target(path);
    for (const auto& [name, other] : known) {
      if (!is_same(target, other)) continue;
      throw UsageError(name == path ? shown_output(path) + ": is stated for two outputs"
                                    : shown_output(name) + " and " + shown_output(path) +
                                          ": two outputs cannot be the same file");
    }
    known.emplace_back(path, target);
  }
}

bool is_standard_output(const std::string& path) {
  std::error_code error;
  return !path.empty() && !fs::is_directory(path, error) &&
         output_target(path).descriptor == STDOUT_FILENO;
}

bool is_file_output(const std::string& path) { return output_target(path).kind == Kind::file; }

struct AtomicFiles::Pending {
  std::string path;
  OutputTarget target;
  std::unique_ptr<TemporaryFile> temporary;  ///< Of a file.
  std::string bytes;                         ///< Of all else.
};

struct AtomicFiles::NewDirectory {
  fs::path path;
  std::unique_ptr<Unfinished> unfinished;
};

AtomicFiles::AtomicFiles() = default;

AtomicFiles::~AtomicFiles() {
  pending_.clear();
  for (auto made = new_directories_.rbegin(); made != new_directories_.rend(); ++made) {
    ::rmdir(made->path.c_str());
  }
}

void AtomicFiles::make_directory(const std::string& path) {
  refuse_standard_output(path);
  fs::path so_far;
  for (const fs::path& part : fs::path(path)) {
    so_far /= part;
    const Uninterrupted change;
    if (::mkdir(so_far.c_str(), 0777) == 0) {
      new_directories_.push_back({so_far, std::make_unique<Unfinished>(so_far.string())});
    }
  }
  create_directory(path);  // says why it is none
}

void AtomicFiles::add(const std::string& path, std::string_view bytes) {
  const OutputTarget target = output_target(path);
  if (target.kind == Kind::file && !names_.insert(full_name(target.path)).second) {
    throw UsageError(shown_output(path) + ": is stated for two outputs");
  }
  if (target.kind != Kind::file) {
    pending_.push_back({path, target, nullptr, std::string(bytes)});
    return;
  }
  remove_stale_temporary_files(target.path);
  auto temporary = std::make_unique<TemporaryFile>(target.path);
  if (!temporary->file().is_open()) refuse_output(path, errno);
  const int failure = write_all(temporary->file().get(), bytes);
  if (failure != 0) refuse_output(path, failure);
  if (!temporary->take_permissions_of(target.path)) refuse_output(path, errno);
  // Any number of files may be pending: none is kept open until all are flushed.
  if (!temporary->file().close()) refuse_output(path, errno);
  pending_.push_back({path, target, std::move(temporary), ""});
}

void AtomicFiles::take_places() {
  if (pending_.size() == 1) {
    const Pending& file = pending_.front();
    if (!file.temporary->rename_to(file.target.path)) refuse_output(file.path, errno);
    return;
  }
  std::vector<Placed> placed;
  try {
    for (const Pending& file : pending_) {
      placed.push_back(place(*file.temporary, file.path, file.target.path));
    }
  } catch (const OutputError&) {
    for (std::size_t k = placed.size(); k-- > 0;) {
      take_back(*pending_[k].temporary, pending_[k].target.path, placed[k]);
    }
    throw;
  }
}

void AtomicFiles::commit() {
  for (const Pending& file : pending_) {
    if (file.temporary && !file.temporary->flush()) refuse_output(file.path, errno);
  }
  for (const Pending& file : pending_) {
    if (!file.temporary) write_through(file.path, file.target, file.bytes);
  }
  std::erase_if(pending_, [](const Pending& file) { return !file.temporary; });
  std::map<fs::path, std::string> directories;
  {
    const Uninterrupted together;
    take_places();
    new_directories_.clear();
    for (const Pending& file : pending_)
      directories.emplace(directory_of(file.target.path), file.path);
    constexpr std::size_t most_names = 3;
    for (std::size_t k = 0; k < std::min(pending_.size(), most_names); ++k) {
      note_kept(shown_output(pending_[k].path));
    }
    if (pending_.size() > most_names) {
      note_kept(std::to_string(pending_.size() - most_names) + " more");
    }
    pending_.clear();
    names_.clear();
  }
  for (const auto& [directory, path] : directories) flush_directory(path, directory);
}

void write_file_atomically(const std::string& path, std::string_view bytes) {
  AtomicFiles one;
  one.add(path, bytes);
  one.commit();
}

void create_directory(const std::string& path) {
  refuse_standard_output(path);
  std::error_code error;
  fs::create_directories(path, error);
  if (!error && fs::is_directory(path, error)) return;
  if (!error) error = std::make_error_code(std::errc::not_a_directory);
  refuse_directory(path, error);
}

}  // namespace tribolog
