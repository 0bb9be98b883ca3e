#include "paper/checks/papers_joint.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/requirements.h"
#include "identify/identify.h"
#include "paper/charts/joint_scale.h"
#include "simulate/simulate_joint.h"

namespace tribolog::paper {
namespace {

std::vector<LoopPoint> plain_loop_points(const Scenario& whole, double q_peak_rad) {
  Scenario plain = whole;
  plain.rough_sweep.reset();
  plain.precise_sweep.reset();
  plain.constant_speed.reset();
  plain.motor_inertia_kgm2 = 0;
  plain.arm_inertia_kgm2 = 0;
  LuGreFriction::Parameters p = bristles_of(whole).parameters();
  p.coulomb_Nm = p.static_Nm;
  plain.presliding = std::make_shared<LuGreFriction>(p);
  const std::vector<Recording> recordings = simulate_joint(plain);
  return identify_hysteresis({&recordings.at(0)}, {}, whole.gear_ratio,
                             symmetric_estimate(q_peak_rad, 0, "known"))
      .points;
}

}  // namespace

const LuGreFriction& bristles_of(const Scenario& scenario) {
  const auto* lugre = dynamic_cast<const LuGreFriction*>(scenario.presliding.get());
  if (lugre == nullptr) throw std::invalid_argument("the paper's joint has LuGre's friction");
  return *lugre;
}

const WaiboerFriction& sliding_of(const Scenario& scenario) {
  const auto* waiboer = dynamic_cast<const WaiboerFriction*>(scenario.sliding.get());
  if (waiboer == nullptr) throw std::invalid_argument("the paper's joint slides by eq. (6), (7)");
  return *waiboer;
}

PapersJoint::PapersJoint(const Scenario& given, RobotDescription description)
    : scenario(given),
      robot(std::move(description)),
      dataset(simulated_dataset(given)),
      calibration(identify(dataset)),
      plain_points(plain_loop_points(given, given.load.q_peak_rad())),
      discontinuous(stribeck_at_joint_scale()),
      continuous(linear_zone_at_joint_scale()),
      loops(presliding_loops({})) {}

double PapersJoint::true_mass_kg() const {
  const GravityLoad& load = scenario.load;
  return load.mass_kg() * load.distance_m() / scenario.surrogate_distance_m;
}

double PapersJoint::true_gravity_Nm() const {
  return scenario.load.amplitude_Nm() / scenario.gear_ratio;
}

double PapersJoint::oscillation_speed_rad_s(double t_s) const {
  const OscillationExperiment& e = present(scenario.oscillation);
  const double omega = 2 * std::numbers::pi * e.frequency_Hz;
  return scenario.gear_ratio * e.amplitude_rad * omega * std::cos(omega * t_s);
}

double PapersJoint::oscillation_acceleration_rad_s2(double t_s) const {
  const OscillationExperiment& e = present(scenario.oscillation);
  const double omega = 2 * std::numbers::pi * e.frequency_Hz;
  return -scenario.gear_ratio * e.amplitude_rad * omega * omega * std::sin(omega * t_s);
}

const Recording& PapersJoint::recording(Role role) const {
  const auto all = dataset.with_role(role);
  if (all.empty()) throw std::invalid_argument("the paper's scenario lacks an experiment");
  return *all.front();
}

const LoopPoint& PapersJoint::point(char name) const {
  const auto& points = calibration.hysteresis.points;
  const auto found = std::find_if(points.begin(), points.end(),
                                  [name](const LoopPoint& p) { return p.name == name; });
  if (found == points.end()) throw std::runtime_error("the paper's loop has lost a point");
  return *found;
}

}  // namespace tribolog::paper
