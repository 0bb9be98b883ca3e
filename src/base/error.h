#pragma once
// What can go wrong, sorted by what the user does about it. Each kind has one exit status.

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/statement.h"

namespace tribolog {

/// The documented exit statuses of the program.
enum class ExitStatus : int {
  done = 0,
  verdict_failed = 1,  ///< Only where --fail-on asked for it.
  usage = 2,           ///< The command line.
  input_refused = 3,   ///< A file that was read.
  output_failed = 4,   ///< A file that was to be written, or standard output.
  figure_failed = 5,   ///< Numbers are kept, a figure is missing.
  archive_failed = 6,  ///< Archive damaged, locked or newer.
  internal = 70,       ///< A fault of the program.
};

/// Base of everything that is reported to the user as one clear line.
class Error : public std::runtime_error {
 public:
  Error(ExitStatus status, const std::string& message)
      : std::runtime_error(message), status_(status) {}
  [[nodiscard]] ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

/// The command line asks for something impossible.
class UsageError : public Error {
 public:
  explicit UsageError(const std::string& message) : Error(ExitStatus::usage, message) {}
};

/// A place in an input file. Line and column count from 1; 0 means "not known".
struct Location {
  std::string file;
  long line{0};
  long column{0};
};

/// An input file says something that cannot be used.
/// The message has the form `file:line:column: what, found ..., expected ...; hint: ...`.
class InputError : public Error {
 public:
  struct Problem {
    std::string what;      ///< "column 'tau': not a number"
    std::string found;     ///< What stands there; empty: left out.
    std::string expected;  ///< What should; empty: left out.
    std::string hint;      ///< What to do; empty: left out.
  };
  InputError(Location where, const Problem& problem);
  [[nodiscard]] const Location& where() const { return where_; }

 private:
  Location where_;
};

/// A file could not be written; what was there before is untouched.
class OutputError : public Error {
 public:
  explicit OutputError(const std::string& message) : Error(ExitStatus::output_failed, message) {}
};

/// The archive is damaged, locked, lost, of a newer program or none at all. It was left as it is.
class ArchiveError : public Error {
 public:
  explicit ArchiveError(const std::string& message) : Error(ExitStatus::archive_failed, message) {}
};

/// A figure could not be drawn. what() is the code with its values; wording::words() has the
/// sentence.
class FigureError : public Error {
 public:
  explicit FigureError(Statement statement);
  [[nodiscard]] const Statement& statement() const { return statement_; }

 private:
  Statement statement_;
};

/// What an error states: the statement of a Refusal or of a FigureError, and of every other its
/// what(), word for word.
Statement stated_by(const std::exception& error);

/// Of a path in a message: as long as the system takes one.
inline constexpr std::size_t longest_path = 4096;

/// Text from a file or command line, safe to print on a terminal: control characters as \x1b,
/// cut to `limit` bytes with an ellipsis.
std::string printable(const std::string& text, std::size_t limit = 80);

}  // namespace tribolog
