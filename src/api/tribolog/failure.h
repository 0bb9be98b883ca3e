#pragma once
// Why a call failed, classified by what the caller can do about it.

#include <stdexcept>
#include <string>

#include "tribolog/export.h"

namespace tribolog {

/// The only exception that this library throws. what() is one line in English, safe to print on a
/// terminal. For an input file it has the form `file:line:column: what, found ..., expected ...;
/// hint: ...`, as far as each part is known.
class TRIBOLOG_EXPORT Failure : public std::runtime_error {
 public:
  enum class Kind {
    usage,            ///< The caller asked for something impossible: an option, a language.
    input_refused,    ///< A file or text that was read cannot be used.
    output_failed,    ///< A file could not be written; what was there before is untouched.
    figure_failed,    ///< Figures cannot be drawn; numbers are not affected.
    archive_failed,   ///< An archive is damaged, locked or from a newer program.
    missing_library,  ///< A distribution library or one of our modules; the message names the
                      ///< package.
    out_of_memory,
    internal,  ///< A bug in the library, to be reported with the input.
  };

  /// @param file the input file; empty: none.
  /// @param line from 1; 0: unknown.
  /// @param column from 1; 0: unknown.
  Failure(Kind kind, const std::string& message, const std::string& file = "", long line = 0,
          long column = 0);
  Failure(const Failure&) noexcept = default;
  Failure& operator=(const Failure&) noexcept = default;
  ~Failure() override;

  [[nodiscard]] Kind kind() const noexcept { return kind_; }
  /// The program's exit status for it: 2 usage, 3 input, 4 output, 5 figure, 6 archive, else 70.
  [[nodiscard]] int exit_status() const noexcept;
  /// The input file at fault, as named by the caller or the manifest; empty: none.
  [[nodiscard]] const char* file() const noexcept { return file_.what(); }
  [[nodiscard]] long line() const noexcept { return line_; }
  [[nodiscard]] long column() const noexcept { return column_; }

 private:
  Kind kind_;
  std::runtime_error file_;  // because its text is copied without throwing
  long line_;
  long column_;
};

}  // namespace tribolog
