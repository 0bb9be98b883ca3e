#pragma once
// Internal to the verdict: rules on what load, angle, direction and time within the session do to
// the quantities.

#include <vector>

#include "verdict/rules.h"

namespace tribolog::verdict {

std::vector<Rule> session_rules();

}  // namespace tribolog::verdict
