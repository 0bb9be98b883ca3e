#pragma once
// Internal to the verdict: what load, angle, direction and time of the session do to quantities.

#include <vector>

#include "verdict/rules.h"

namespace tribolog::verdict {

std::vector<Rule> session_rules();

}  // namespace tribolog::verdict
