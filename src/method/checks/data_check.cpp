#include "method/checks/data_check.h"

#include <algorithm>

#include "base/enum_text.h"

namespace tribolog::method::checks {

std::string to_string(CheckState state) { return own_name(state); }

std::string to_string(CheckName name) { return own_name(name); }

const DataCheck* DataChecksResult::find(CheckName name) const {
  const auto it = std::find_if(checks.begin(), checks.end(),
                               [&](const DataCheck& check) { return check.name == name; });
  return it == checks.end() ? nullptr : &*it;
}

bool DataChecksResult::fails(CheckName name) const {
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
