#pragma once
// Internal to the writers of output files: where a path leads, and the temporary file beside it.

#include <filesystem>
#include <memory>
#include <string>

#include "base/early_end.h"
#include "base/file_descriptor.h"

namespace tribolog {

struct OutputTarget {
  enum class Kind {
    file,        ///< Replaced, or made.
    stream,      ///< A named pipe, a terminal, /dev/null and its kin: opened and written to.
    descriptor,  ///< This process has it open: -, /dev/stdout, /dev/fd/3.
  };
  Kind kind{Kind::file};
  std::filesystem::path path;  ///< Of a file: without the links that lead to it.
  int descriptor{-1};
};

/// "standard output", or the path; safe to print.
std::string shown_output(const std::string& path);

/// "out/report.html: cannot write: " and why. @throw OutputError
[[noreturn]] void refuse_output(const std::string& path, const std::string& why);
[[noreturn]] void refuse_output(const std::string& path, int error);

/// @throw OutputError: a directory, a device that takes no file, a link that leads nowhere, a
/// descriptor that is not open for writing.
OutputTarget output_target(const std::string& path);

/// Of a file that need not exist: its name in its directory, which has one name alone.
std::filesystem::path full_name(const std::filesystem::path& file);

/// Are both the same file, by whatever names, whether it exists or not?
bool is_same(const OutputTarget& a, const OutputTarget& b);

/// Open for writing from the constructor on; removed by the destructor, or by a signal that ends
/// the program, unless it was renamed.
class TemporaryFile {
 public:
  /// Creates `.<name>.tmp-XXXXXX` in the target's directory. is_open() tells whether that worked;
  /// where not, errno does.
  explicit TemporaryFile(const std::filesystem::path& target);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  [[nodiscard]] FileDescriptor& file() { return file_; }
  /// Its bytes are on the disk. Works whether it is open or not. @return false: errno tells why.
  [[nodiscard]] bool flush() const;
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Gets the permissions that a new file has by the umask. @return false: errno tells why.
  [[nodiscard]] bool open_to_others() const;
  /// Gets the permissions, and where the system allows the owner, of the file that it is to
  /// replace; where there is none, as open_to_others(). @return false: errno tells why.
  [[nodiscard]] bool take_permissions_of(const std::filesystem::path& target) const;
  /// Takes the target's name, if nothing has it. @return false: errno tells why, and nothing has
  /// changed.
  [[nodiscard]] bool link_to(const std::filesystem::path& target);
  /// Takes the target's place. @return false: errno tells why, and nothing has changed.
  [[nodiscard]] bool rename_to(const std::filesystem::path& target);
  /// Takes the target's place, and the target takes this one's, to be removed or exchanged back.
  /// @return false: errno tells why (EINVAL: this file system cannot), and nothing has changed.
  [[nodiscard]] bool exchange_with(const std::filesystem::path& target) const;

 private:
  std::string path_;
  std::unique_ptr<Unfinished> unfinished_;
  FileDescriptor file_;
};

/// Removes the temporary files of this target that an interrupted run left more than a day ago.
/// What cannot be removed is left.
void remove_stale_temporary_files(const std::filesystem::path& target);

}  // namespace tribolog
