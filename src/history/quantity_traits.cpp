#include "history/quantity_traits.h"

#include <array>
#include <utility>

namespace tribolog::history {

QuantityTraits traits_of(const std::string& name) {
  static const std::array<std::pair<const char*, QuantityTraits>, 11> known{{
      {"cog_angle", {false, true, false, true}},
      {"gravity_torque", {false, true, false, false}},
      {"surrogate_mass", {false, true, false, false}},
      {"coulomb_torque", {true, false, false, false}},
      {"stribeck_speed", {true, false, false, false}},
      {"viscous_coefficient", {true, false, false, false}},
      {"viscous_curve", {true, false, false, false}},
      {"break_away_torque", {true, false, true, false}},
      {"bristle_stiffness", {false, false, true, false}},
      {"bristle_damping", {true, false, true, false}},
      {"inertia", {false, true, true, false}},
  }};
  for (const auto& [key, traits] : known) {
    if (name == key) return traits;
  }
  return {};
}

}  // namespace tribolog::history
