#include "joint/effects.h"

namespace tribolog::joint {

std::string Effect::stated_key() const { return std::string(key) + "_" + std::string(unit); }

const std::vector<Effect>& effects() {
  using namespace effect;
  static const std::vector<Effect> all{gravity_left,
                                       offset,
                                       offset_drift,
                                       gain_drift,
                                       torque_nonlinear,
                                       gain_of_speed,
                                       gain_of_runs,
                                       tool,
                                       lag,
                                       others_gravity,
                                       others_inertia,
                                       asymmetry,
                                       load,
                                       position,
                                       motor_turn,
                                       torque_over_turn,
                                       hoses,
                                       angle_scale,
                                       peak_drift,
                                       homing,
                                       harmonics,
                                       smooth_over_angle,
                                       drift,
                                       law_misfit,
                                       law_at_its_ends,
                                       contact_misfit,
                                       friction_of_session,
                                       tare,
                                       friction_of_recording};
  return all;
}

const std::vector<Effect>& statable_effects() {
  static const std::vector<Effect> all = [] {
    std::vector<Effect> statable;
    for (const Effect& one : effects()) {
      if (!one.unit.empty()) statable.push_back(one);
    }
    return statable;
  }();
  return all;
}

double EffectSizes::of(const Effect& effect) const {
  const auto found = stated_.find(effect.key);
  return found == stated_.end() ? effect.typical : found->second;
}

}  // namespace tribolog::joint
