#pragma once
// Internal to the writers of output files: where a path leads.

#include <filesystem>
#include <string>

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

}  // namespace tribolog
