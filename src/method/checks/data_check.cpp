#include "method/checks/data_check.h"

#include <algorithm>

namespace tribolog::method::checks {

std::string to_string(CheckState state) {
  switch (state) {
    case CheckState::passed:
      return "passed";
    case CheckState::warns:
      return "warns";
    case CheckState::fails:
      return "fails";
    case CheckState::not_applicable:
      return "not_applicable";
  }
  return "unknown";
}

const DataCheck* DataChecksResult::find(const std::string& name) const {
  const auto it = std::find_if(checks.begin(), checks.end(),
                               [&](const DataCheck& check) { return check.name == name; });
  return it == checks.end() ? nullptr : &*it;
}

bool DataChecksResult::fails(const std::string& name) const {
  const DataCheck* check = find(name);
  return check != nullptr && check->state == CheckState::fails;
}

std::vector<const DataCheck*> DataChecksResult::in_state(CheckState state) const {
  std::vector<const DataCheck*> found;
  for (const DataCheck& check : checks) {
    if (check.state == state) found.push_back(&check);
  }
  return found;
}

}  // namespace tribolog::method::checks
