#pragma once
// Output files that are either complete or untouched.
//
// The bytes go to a temporary file `.<name>.tmp-XXXXXX` in the same directory, are flushed to the
// disk, and the temporary file is renamed over the target. A reader sees the old file or the new
// one, never a part. A run that is killed leaves the old file and at most its temporary file, which
// a later run of the same name removes once it is a day old.

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog {

/// To be called before any computation: can `path` be written at all? "-" is standard output;
/// /dev/stdout, /dev/fd/3, a named pipe, a terminal and /dev/null are written to as they are.
/// @param inputs files that must not be overwritten, whether they exist or not; links to them count
///        as the same file, and empty ones not at all.
/// @throw OutputError if the directory is missing or not writable, the file system is read-only, or
///        the target is a directory, a device that takes no file, or a link that leads nowhere.
/// @throw UsageError if the target is one of the inputs.
void check_output_can_be_written(const std::string& path,
                                 const std::vector<std::string>& inputs = {});

/// @param paths of the outputs of one run; empty ones do not count.
/// @throw UsageError where two of them are the same file, by whatever names. OutputError as above.
void check_outputs_differ(const std::vector<std::string>& paths);

/// Does this output go to standard output, where nothing else may be printed then? Asked of a path
/// that can be written.
bool is_standard_output(const std::string& path);

/// Is it a file with a place of its own, not a pipe, a device or standard output?
/// @throw OutputError as above.
bool is_file_output(const std::string& path);

/// Writes the whole file. One that is replaced leaves its permissions, and its owner where the
/// system allows; a new one has those that the umask leaves. A symbolic link to a file stays a
/// link; the file it leads to is replaced. After the return the file is on the disk.
/// @throw OutputError with the system's reason; what was there before is untouched, and the
///        temporary file is gone. A pipe whose reader has gone is no error.
void write_file_atomically(const std::string& path, std::string_view bytes);

/// Files that belong together: none takes its place before all of them are on the disk, so that a
/// full disk leaves every old file. Flushed together, they cost little more than one.
class AtomicFiles {
 public:
  AtomicFiles();
  /// Removes what was not committed, directories too.
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  /// As create_directory(); what was made is removed again where nothing is committed.
  void make_directory(const std::string& path);

  /// Writes the bytes to the temporary file; those for a pipe or a device wait for commit().
  /// @throw OutputError as write_file_atomically. UsageError: it is another one of these files.
  void add(const std::string& path, std::string_view bytes);

  /// Each file takes its place, in the order of add(); signals wait meanwhile. If one cannot, those
  /// before it get their old contents back, as far as the file system can exchange files.
  /// @throw OutputError with the system's reason.
  void commit();

 private:
  struct Pending;
  struct NewDirectory;
  void take_places();

  std::vector<NewDirectory> new_directories_;
  std::vector<Pending> pending_;
  std::set<std::filesystem::path> names_;  ///< Of the files that are pending.
};

/// Makes a directory and those above it; one that exists is fine.
/// @throw OutputError with the system's reason, also where a file is in the way. UsageError for
/// "-".
void create_directory(const std::string& path);

}  // namespace tribolog
