#pragma once
// What users complain about in other programs that read logs, as a numbered list: each case with
// its input, its exit status, and word for word what the program says.

#include <functional>
#include <string>
#include <vector>

#include "support/run_program.h"

namespace tribolog::test {

/// Of an accepted log, held against those of the log without any peculiarity.
enum class Numbers {
  any,    ///< Other samples: nothing to hold against.
  close,  ///< Angle and mass to a millionth.
  same,   ///< Every number of the calibration, to the last bit.
};

struct InputCase {
  std::string id;    ///< "19a": its number in the list, and which of several.
  std::string name;  ///< In a word or a few.
  std::string log;
  std::string manifest;
  int status{};
  /// Refused: the whole of the error. Accepted: the notes, one a line. "..." at the end stands for
  /// words of a library.
  std::string says;
  Numbers numbers{Numbers::any};
  std::string left_out{};     ///< "20: repeated time stamp"; rows that did not become samples.
  std::string finds{};        ///< A line of the outcome, from its first word on.
  std::string environment{};  ///< "LC_ALL=de_DE.UTF-8"
  /// Makes what is no plain file, beside dataset.toml and log.csv.
  std::function<void(const ScratchDirectory&)> prepare{};
};

/// A log that is refused with status 3.
InputCase refused(const std::string& id, const std::string& name, const std::string& log,
                  const std::string& says);
/// A log that is accepted and gives the numbers of the clean one.
InputCase accepted(const std::string& id, const std::string& name, const std::string& log,
                   const std::string& notes = "");
/// Another manifest of the same.
InputCase with_manifest(InputCase one, const std::string& manifest);

// The list, by what is wrong.
std::vector<InputCase> file_cases();      ///< 1 to 10, 40, 42, 43: what a file is.
std::vector<InputCase> dialect_cases();   ///< 11 to 26: how rows and columns are written.
std::vector<InputCase> number_cases();    ///< 14, 15, 27 to 29, 39: what stands in a field.
std::vector<InputCase> time_cases();      ///< 30 to 34: the clock.
std::vector<InputCase> content_cases();   ///< 35 to 38: what was measured.
std::vector<InputCase> manifest_cases();  ///< 46 to 48: the manifest and its names.

/// 41, 44, 45 and parts of 40, 43 and 46 are tests of their own.
inline const std::vector<int> cases_elsewhere{41, 44, 45};

}  // namespace tribolog::test
