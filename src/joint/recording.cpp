#include "joint/recording.h"

namespace tribolog {

std::string to_string(Role role) {
  switch (role) {
    case Role::rough_sweep:
      return "rough_sweep";
    case Role::precise_sweep:
      return "precise_sweep";
    case Role::oscillation:
      return "oscillation";
    case Role::constant_speed:
      return "constant_speed";
  }
  return "unknown";
}

}  // namespace tribolog
