#pragma once
// Running the real program, as a user would.

#include <string>
#include <vector>

namespace tribolog::test {

struct ProgramRun {
  int status{};  ///< Exit status; 128 + signal if killed.
  std::string out;
  std::string err;
};

/// Runs a command line through the shell, so that redirections and variables work.
ProgramRun run_shell(const std::string& command);

/// A new empty directory, removed with all it holds at the end.
class ScratchDirectory {
 public:
  ScratchDirectory();
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const;

 private:
  std::string path_;
};

std::string read_text(const std::string& path);

}  // namespace tribolog::test
