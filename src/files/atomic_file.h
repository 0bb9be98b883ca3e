#pragma once
// Output files that are either complete or untouched.
//
// The bytes go to a temporary file `.<name>.tmp-XXXXXX` in the same directory, are flushed to the
// disk, and the temporary file is renamed over the target. A reader sees the old file or the new
// one, never a part. A run that is killed leaves the old file and at most its temporary file, which
// a later run of the same name removes once it is a day old.

#include <string>
#include <string_view>
#include <vector>

namespace tribolog {

/// To be called before any computation: can `path` be written at all?
/// @param inputs files that must not be overwritten; links to them count as the same file.
/// @throw OutputError if the directory is missing or not writable, the file system is read-only, or
///        the target is a directory or not a regular file.
/// @throw UsageError if the target is one of the inputs.
void check_output_can_be_written(const std::string& path,
                                 const std::vector<std::string>& inputs = {});

/// Writes the whole file, with the permissions that the umask leaves. A symbolic link to a file
/// stays a link; the file it leads to is replaced. After the return the file is on the disk.
/// @throw OutputError with the system's reason; what was there before is untouched, and the
///        temporary file is gone.
void write_file_atomically(const std::string& path, std::string_view bytes);

/// Files that belong together: none takes its place before all of them are on the disk, so that a
/// full disk leaves every old file. Flushed together, they cost little more than one.
class AtomicFiles {
 public:
  AtomicFiles();
  /// Removes what was not committed.
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  /// Writes the bytes to the temporary file. @throw OutputError as write_file_atomically.
  void add(const std::string& path, std::string_view bytes);

  /// Each file takes its place, in the order of add(). @throw OutputError with the system's reason.
  void commit();

 private:
  struct Pending;
  std::vector<Pending> pending_;
};

/// Makes a directory and those above it; one that exists is fine.
/// @throw OutputError with the system's reason, also where a file is in the way.
void create_directory(const std::string& path);

}  // namespace tribolog
