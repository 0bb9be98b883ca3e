// The reconstructed joint's parameters and experiments as the method gives them, against the
// scenario that is simulated.

#include <algorithm>
#include <cmath>

#include "base/present.h"
#include "joint/degrees.h"
#include "paper/checks/golden_numbers.h"
#include "paper/drawings/printed_paper.h"

namespace tribolog::paper {
namespace {

class Given {
 public:
  /// Half the last digit may be rounding.
  void add(const char* what, double given, int places, double ours, const char* unit) {
    out.push_back(reconstructed_value(what, given, places, ours, 0.5 * std::pow(10.0, -places),
                                      unit, "half the last digit given"));
  }
  Checks out;
};

void add_joint(const Scenario& s, Given& given) {
  const LuGreFriction::Parameters& p = bristles_of(s).parameters();
  given.add("Scenario: σ₀", 465.42, 2, p.bristle_stiffness_Nm_rad, "N·m/rad");
  given.add("Scenario: σ₁", 0.77080, 5, p.bristle_damping_Nms_rad, "N·m·s/rad");
  given.add("Scenario: σ₂", 0.001, 3, p.viscous_Nms_rad, "N·m·s/rad");
  given.add("Scenario: T_c", 0.60, 2, p.coulomb_Nm, "N·m");
  given.add("Scenario: ω_s of the bristles", 5, 0, p.stribeck_speed_rad_s, "rad/s");
  given.add("Scenario: J of motor and gear", 1e-4, 4, s.motor_inertia_kgm2, "kg·m²");
  given.add("Scenario: m", 98.96, 2, s.load.mass_kg(), "kg");
  given.add("Scenario: r", 0.4, 1, s.load.distance_m(), "m");
  const OscillationExperiment& e = present(s.oscillation);
  given.add("Scenario: swing of the motor, n a", 0.01, 2, s.gear_ratio * e.amplitude_rad, "rad");
  given.add("Scenario: f", 1, 0, e.frequency_Hz, "Hz");
}

void add_sliding(const Scenario& s, Given& given) {
  const WaiboerFriction::Parameters& p = sliding_of(s).parameters();
  given.add("Scenario: T_a of eq. (6)", 0.8844, 4, p.asperity_torque_Nm, "N·m");
  given.add("Scenario: ω_s of eq. (6)", 5, 0, p.stribeck_speed_rad_s, "rad/s");
  given.add("Scenario: δ_a", 0.7, 1, p.stribeck_power, "");
  given.add("Scenario: c_v, the viscous part at 1 rad/s", 0.12, 2, p.viscous_coefficient, "N·m");
  given.add("Scenario: δ_v", 0.6, 1, p.viscous_power, "");
  given.add("Scenario: c of eq. (7)", printed::smoothing_s_rad, 0, p.smoothing_s_rad, "s/rad");
}

void add_experiments(const Scenario& s, Given& given) {
  const SweepExperiment& sweep = present(s.rough_sweep);
  given.add("Scenario: rough sweep from", -80, 0, sweep.from_rad * degrees_per_rad, "°");
  given.add("Scenario: rough sweep to", 60, 0, sweep.to_rad * degrees_per_rad, "°");
  given.add("Scenario: speed of the rough sweep", 2, 0, sweep.speed_rad_s * degrees_per_rad, "°/s");
  const ConstantSpeedExperiment& runs = present(s.constant_speed);
  const auto& speeds = runs.motor_speeds_rad_s;
  const auto [slowest, fastest] = std::minmax_element(speeds.begin(), speeds.end());
  given.add("Scenario: number of constant speeds, in both directions", 20, 0,
            runs.both_directions ? static_cast<double>(speeds.size()) : NAN, "");
  given.add("Scenario: slowest of them", 1, 0, *slowest, "rad/s");
  given.add("Scenario: fastest of them", 300, 0, *fastest, "rad/s");
}

}  // namespace

Checks golden_parameters(const PapersJoint& joint) {
  Given given;
  add_joint(joint.scenario, given);
  add_sliding(joint.scenario, given);
  add_experiments(joint.scenario, given);
  return given.out;
}

}  // namespace tribolog::paper
