#pragma once
// What a call cannot do, sorted by what its caller does about it.

#include <stdexcept>
#include <string>

#include "tribolog/export.h"

namespace tribolog {

/// The one exception that this library throws. what() is one line in English, safe to print on a
/// terminal. Of an input file it has the form `file:line:column: what, found ..., expected ...;
/// hint: ...`, as far as each is known.
class TRIBOLOG_EXPORT Failure : public std::runtime_error {
 public:
  enum class Kind {
    usage,            ///< What the caller asks for is impossible: an option, a language.
    input_refused,    ///< A file, or a text, that was read.
    output_failed,    ///< A file that was to be written; what was there before is untouched.
    figure_failed,    ///< Figures cannot be drawn; numbers are not concerned.
    archive_failed,   ///< An archive is damaged, locked or of a newer program.
    missing_library,  ///< Of the distribution, or a module of ours; the message names the package.
    out_of_memory,
    internal,  ///< A fault of the library, to be reported with the input.
  };

  /// @param file of the input; empty: of none.
  /// @param line from 1; 0: not known.
  /// @param column from 1; 0: not known.
  Failure(Kind kind, const std::string& message, const std::string& file = "", long line = 0,
          long column = 0);
  Failure(const Failure&) noexcept = default;
  Failure& operator=(const Failure&) noexcept = default;
  ~Failure() override;

  [[nodiscard]] Kind kind() const noexcept { return kind_; }
  /// The program's exit status for it: 2 usage, 3 input, 4 output, 5 figure, 6 archive, else 70.
  [[nodiscard]] int exit_status() const noexcept;
  /// The input file that is at fault, as the caller or its manifest named it; empty: none is.
  [[nodiscard]] const char* file() const noexcept { return file_.what(); }
  [[nodiscard]] long line() const noexcept { return line_; }
  [[nodiscard]] long column() const noexcept { return column_; }

 private:
  Kind kind_;
  std::runtime_error file_;  // whose text is copied without a throw
  long line_;
  long column_;
};

}  // namespace tribolog
