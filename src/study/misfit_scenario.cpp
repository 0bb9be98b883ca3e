#include "study/misfit_scenario.h"

#include <memory>

namespace tribolog::study {

using simulate::Scenario;

const LuGreParameters& lugre_of(const Scenario& s) {
  return dynamic_cast<const friction::LuGreFriction&>(*s.presliding).parameters();
}

void set_lugre(Scenario& s, const LuGreParameters& p) {
  s.presliding = std::make_shared<friction::LuGreFriction>(p);
}

double motor_gravity(const Scenario& s) { return s.load.amplitude_Nm() / s.gear_ratio; }

}  // namespace tribolog::study
