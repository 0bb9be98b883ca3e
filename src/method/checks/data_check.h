#pragma once
// Checks on the recordings before any fit: what can be wrong with a log, each with its number and
// its limit.
//
// A check that fails lowers the verdict of the quantities it touches (verdict/judge.cpp
// says which). One that warns is told, and lowers nothing.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"

namespace tribolog::method::checks {

enum class CheckState { passed, warns, fails, not_applicable };

std::string to_string(CheckState state);

struct DataCheck {
  std::string name;                ///< Stable key: "speed_scale".
  std::string recording;           ///< The one the number is of, a role, or "all"; empty: none.
  Statement measure;               ///< What was measured.
  std::optional<double> measured;  ///< In `unit`; absent where not applicable.
  std::optional<double> at_least;  ///< Limits of what passes, in `unit`.
  std::optional<double> at_most;
  std::string unit;  ///< "1" for a pure number.
  CheckState state{CheckState::not_applicable};
  Statement found;          ///< One clause on what was found, or why the check does not apply.
  Statement consequence;    ///< What that does to the results; empty if it passed.
  Statement experiment;     ///< What to record instead; empty if it passed.
  bool is_of_whole_role{};  ///< `recording` is a role: the number is of all its recordings.
};

struct DataChecksResult {
  std::vector<DataCheck> checks;  ///< In the order of the report.

  [[nodiscard]] const DataCheck* find(const std::string& name) const;
  [[nodiscard]] bool fails(const std::string& name) const;
  /// Those in this state, in order.
  [[nodiscard]] std::vector<const DataCheck*> in_state(CheckState state) const;
};

}  // namespace tribolog::method::checks
