#include "joint/recording.h"

#include "base/enum_text.h"

namespace tribolog::joint {

std::string to_string(Role role) { return own_name(role); }

}  // namespace tribolog::joint
