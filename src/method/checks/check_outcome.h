#pragma once
// Internal to the checks: how a check arrives at its number and its state.

#include <cstddef>
#include <string>

#include "base/statement.h"
#include "method/checks/data_check.h"

namespace tribolog::method::checks {

/// A check that does not apply, with the reason.
DataCheck not_applicable(CheckName name, Statement why);

/// Takes the number of one recording (or of a role) as the check's if it is the largest so far.
/// @return whether it was taken.
bool take_if_worst(DataCheck& check, double measured, const std::string& recording);

/// The check in the state passed, for all recordings.
DataCheck passed_by_all(DataCheck check, Statement found);

/// Passed up to the check's at_most, fails beyond; at_most and the check's number must be set.
CheckState passed_or_fails(const DataCheck& check);

/// Passed up to the check's at_most, a warning up to `most`, fails beyond.
CheckState passed_or_warns_up_to(double most, const DataCheck& check);

/// Counts the recordings that are as a check requires.
class RecordingCounts {
 public:
  void add(bool is_as_wanted, const std::string& recording);
  [[nodiscard]] std::size_t all() const { return all_; }
  [[nodiscard]] std::size_t others() const { return others_; }
  /// The share [%] of those as required becomes the check's number, and the first other one its
  /// recording.
  void take_share(DataCheck& check) const;

 private:
  std::size_t all_{};
  std::size_t others_{};
  std::string first_other_;
};

}  // namespace tribolog::method::checks
