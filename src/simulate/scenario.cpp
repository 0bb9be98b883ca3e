#include "simulate/scenario.h"

#include <numbers>

#include "friction/catalogue.h"

namespace tribolog::simulate {

std::vector<OscillationExperiment> spread_over_motor_turn(const OscillationExperiment& oscillation,
                                                          std::size_t positions,
                                                          double gear_ratio) {
  const double apart_rad = 2 * std::numbers::pi / gear_ratio / static_cast<double>(positions);
  std::vector<OscillationExperiment> all(positions, oscillation);
  // The first at the centre, the others to its right and left in turn.
  for (std::size_t k = 1; k < positions; ++k) {
    const std::size_t away = (k + 1) / 2;
    const double places = static_cast<double>(away) * (k % 2 == 1 ? 1 : -1);
    all[k].centre_rad += places * apart_rad;
  }
  return all;
}

const friction::FrictionModel& Scenario::sliding_model() const {
  if (sliding) return *sliding;
  return *presliding;
}

std::shared_ptr<const friction::StaticFriction> Scenario::known_curve() const {
  if (log.keeps_friction_secret) return nullptr;
  if (sliding) return sliding;
  if (friction::dynamic_friction_model(presliding->name()).traits.remembers_rest) return nullptr;
  return std::make_shared<friction::SteadyFriction>(presliding);
}

}  // namespace tribolog::simulate
