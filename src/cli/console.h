#pragma once
// What the user sees while a command works: a bar on a terminal, plain lines in a pipe, nothing
// with --quiet. Goes to standard error; results go to standard output. What a terminal would obey
// in a name from outside is escaped.

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace tribolog::cli {

class Console {
 public:
  explicit Console(bool quiet);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// A step of work: `done` of `all`. Drawn on a terminal once the work has taken a second; in a
  /// pipe each new step is one line.
  void progress(const std::string& what, std::size_t done, std::size_t all);
  /// Steps of works that go on at the same time, a line each: on a terminal below each other, in a
  /// pipe those that are new.
  struct Step {
    std::string name;  ///< Of the work.
    std::string what;  ///< Empty: it has not begun.
    std::size_t done{}, all{1};
  };
  void progress(const std::vector<Step>& steps);
  /// Ends the bar, so that the next line starts clean.
  void finish();
  /// An output that goes to standard output has it for itself: say() goes to standard error then.
  /// @throw OutputError: it cannot be written.
  void make_way_for(const std::string& output);
  /// A line about the result, to standard output; nothing with --quiet.
  void say(const std::string& line);
  /// A line that the user must not miss, to standard error, also with --quiet.
  void warn(const std::string& line);

 private:
  bool quiet_;
  bool terminal_;
  int lines_drawn_{0};
  bool is_output_elsewhere_{false};
  [[nodiscard]] bool is_too_early() const;
  std::vector<std::string> last_;  ///< Of each work, in a pipe.
  std::chrono::steady_clock::time_point start_;
};

}  // namespace tribolog::cli
