#include "simulate/simulated_dataset.h"

#include <utility>

#include "simulate/simulate_joint.h"

namespace tribolog {

Dataset simulated_dataset(const Scenario& scenario, std::vector<Recording> recordings) {
  Dataset dataset;
  Manifest& manifest = dataset.manifest;
  manifest.robot = scenario.robot;
  manifest.serial = scenario.serial;
  manifest.joint = scenario.joint;
  manifest.note = "simulated: " + scenario.name;
  manifest.drive = Drive(scenario.gear_ratio, EffortKind::motor_torque, Side::motor);
  manifest.surrogate_distance_m = scenario.surrogate_distance_m;
  manifest.gravity_m_s2 = scenario.load.gravity_m_s2();
  manifest.reference = scenario.known_curve();
  dataset.recordings = std::move(recordings);
  return dataset;
}

Dataset simulated_dataset(const Scenario& scenario) {
  return simulated_dataset(scenario, simulate_joint(scenario));
}

}  // namespace tribolog
