#include "simulate/scenario.h"

#include "friction/catalogue.h"

namespace tribolog {

const FrictionModel& Scenario::sliding_model() const {
  if (sliding) return *sliding;
  return *presliding;
}

std::shared_ptr<const StaticFriction> Scenario::known_curve() const {
  if (sliding) return sliding;
  if (dynamic_friction_model(presliding->name()).traits.remembers_rest) return nullptr;
  return std::make_shared<SteadyFriction>(presliding);
}

}  // namespace tribolog
