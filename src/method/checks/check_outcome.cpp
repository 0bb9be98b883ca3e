#include "method/checks/check_outcome.h"

#include <cstddef>
#include <utility>

#include "base/requirements.h"

namespace tribolog::method::checks {

DataCheck not_applicable(CheckName name, Statement why) {
  DataCheck check;
  check.name = name;
  check.found = std::move(why);
  return check;
}

bool take_if_worst(DataCheck& check, double measured, const std::string& recording) {
  if (check.measured && measured <= *check.measured) return false;
  check.measured = measured;
  check.recording = recording;
  return true;
}

DataCheck passed_by_all(DataCheck check, Statement found) {
  check.state = CheckState::passed;
  check.recording = "all";
  check.found = std::move(found);
  return check;
}

CheckState passed_or_fails(const DataCheck& check) {
  return passed_or_warns_up_to(present(check.at_most), check);
}

CheckState passed_or_warns_up_to(double most, const DataCheck& check) {
  const double measured = present(check.measured);
  if (measured <= present(check.at_most)) return CheckState::passed;
  return measured <= most ? CheckState::warns : CheckState::fails;
}

void RecordingCounts::add(bool is_as_wanted, const std::string& recording) {
  ++all_;
  if (is_as_wanted) return;
  if (++others_ == 1) first_other_ = recording;
}

void RecordingCounts::take_share(DataCheck& check) const {
  check.measured = 100.0 * static_cast<double>(all_ - others_) / static_cast<double>(all_);
  check.recording = others_ == 0 ? "all" : first_other_;
}

}  // namespace tribolog::method::checks
