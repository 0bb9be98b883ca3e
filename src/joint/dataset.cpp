#include "joint/dataset.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "joint/degrees.h"

namespace tribolog::joint {

const std::vector<LimitedQuantity>& limited_quantities() {
  static const std::vector<LimitedQuantity> all{
      {"q_peak_deg", Quantity::cog_angle, "°", degrees_per_rad, 0},
      {"q_peak_rad", Quantity::cog_angle, "rad", 1, 0},
      {"gravity_motor_Nm", Quantity::gravity_torque, "N·m", 1, 0},
      {"gravity_joint_Nm", Quantity::gravity_torque, "N·m", 1, 1, true},
      {"surrogate_mass_kg", Quantity::surrogate_mass, "kg", 1, 0},
      {"break_away_motor_Nm", Quantity::break_away_torque, "N·m", 1, 0},
      {"break_away_joint_Nm", Quantity::break_away_torque, "N·m", 1, 1, true},
      {"coulomb_motor_Nm", Quantity::coulomb_torque, "N·m", 1, 0},
      {"coulomb_joint_Nm", Quantity::coulomb_torque, "N·m", 1, 1, true},
      {"stribeck_speed_motor_rad_s", Quantity::stribeck_speed, "rad/s", 1, 0},
      {"stribeck_speed_joint_rad_s", Quantity::stribeck_speed, "rad/s", 1, -1, true},
      {"viscous_motor_Nms_rad", Quantity::viscous_coefficient, "N·m·s/rad", 1, 0},
      {"viscous_joint_Nms_rad", Quantity::viscous_coefficient, "N·m·s/rad", 1, 2, true},
      {"bristle_stiffness_motor_Nm_rad", Quantity::bristle_stiffness, "N·m/rad", 1, 0},
      {"bristle_stiffness_joint_Nm_rad", Quantity::bristle_stiffness, "N·m/rad", 1, 2, true},
      {"bristle_damping_motor_Nms_rad", Quantity::bristle_damping, "N·m·s/rad", 1, 0},
      {"bristle_damping_joint_Nms_rad", Quantity::bristle_damping, "N·m·s/rad", 1, 2, true},
      {"inertia_motor_kgm2", Quantity::inertia, "kg·m²", 1, 0},
      {"inertia_joint_kgm2", Quantity::inertia, "kg·m²", 1, 2, true},
  };
  return all;
}

const LimitedQuantity* find_limited_quantity(const std::string& key) {
  const auto& all = limited_quantities();
  const auto it =
      std::find_if(all.begin(), all.end(), [&](const LimitedQuantity& q) { return q.key == key; });
  return it == all.end() ? nullptr : &*it;
}

std::vector<const Recording*> Dataset::with_role(Role role) const {
  std::vector<const Recording*> found;
  for (const Recording& recording : recordings) {
    if (recording.role == role) found.push_back(&recording);
  }
  return found;
}

std::vector<SharedConversion> shared_conversions(const std::vector<InputFile>& inputs) {
  std::vector<SharedConversion> all;
  std::vector<std::set<std::string_view>> files;  // of each
  std::set<std::string_view> logs;
  for (const InputFile& input : inputs) {
    if (!input.conversions.empty()) logs.insert(input.name);
    for (const ColumnConversion& conversion : input.conversions) {
      const auto known = std::find_if(all.begin(), all.end(), [&](const SharedConversion& s) {
        return s.conversion == conversion;
      });
      const auto place = static_cast<std::size_t>(known - all.begin());
      if (known == all.end()) {
        all.push_back({conversion, {}, false});
        files.emplace_back();
      }
      if (files[place].insert(input.name).second) all[place].files.push_back(input.name);
    }
  }
  for (SharedConversion& shared : all) shared.is_of_all = shared.files.size() == logs.size();
  std::stable_sort(all.begin(), all.end(),
                   [](const SharedConversion& a, const SharedConversion& b) {
                     return a.conversion.signal < b.conversion.signal;
                   });
  return all;
}

}  // namespace tribolog::joint
