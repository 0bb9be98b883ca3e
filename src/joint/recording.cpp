#include "joint/recording.h"

namespace tribolog::joint {

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
    case Role::break_away:
      return "break_away";
    case Role::friction_points:
      return "friction_points";
  }
  return "unknown";
}

}  // namespace tribolog::joint
