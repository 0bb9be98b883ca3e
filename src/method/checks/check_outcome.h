#pragma once
// Internal to the checks: how a check comes to its number and to its end.

#include <cstddef>
#include <string>

#include "base/statement.h"
#include "method/checks/data_check.h"

namespace tribolog::method::checks {

/// A check that does not apply, with the reason.
DataCheck not_applicable(CheckName name, Statement why);

/// Takes the number of one recording (or of a role) for the check's if it is the largest so far.
/// @return whether it was taken.
bool take_if_worst(DataCheck& check, double measured, const std::string& recording);

/// The check, passed by all recordings.
DataCheck passed_by_all(DataCheck check, Statement found);

/// Passed up to at_most of the check, which must be set as its number must; fails beyond.
CheckState passed_or_fails(const DataCheck& check);

/// Passed up to at_most of the check, a warning up to `most`, fails beyond.
CheckState passed_or_warns_up_to(double most, const DataCheck& check);

/// How many of the recordings are as a check wants them.
class RecordingsAsWanted {
 public:
  void add(bool is_as_wanted, const std::string& recording);
  [[nodiscard]] std::size_t all() const { return all_; }
  [[nodiscard]] std::size_t others() const { return others_; }
  /// Their share [%] becomes the number of the check, and the first other one its recording.
  void take_share(DataCheck& check) const;

 private:
  std::size_t all_{};
  std::size_t others_{};
  std::string first_other_;
};

}  // namespace tribolog::method::checks
