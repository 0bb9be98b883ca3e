#include "paper/checks/papers_joint.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/requirements.h"
#include "identify/identify.h"
#include "simulate/simulate_joint.h"

namespace tribolog::paper::checks {
namespace {

std::vector<method::hysteresis::LoopPoint> plain_loop_points(const simulate::Scenario& whole,
                                                             double q_peak_rad) {
  simulate::Scenario plain = whole;
  plain.rough_sweep.reset();
  plain.precise_sweep.reset();
  plain.constant_speed.reset();
  plain.motor_inertia_kgm2 = 0;
  plain.arm_inertia_kgm2 = 0;
  friction::LuGreFriction::Parameters p = bristles_of(whole).parameters();
  p.coulomb_Nm = p.static_Nm;
  plain.presliding = std::make_shared<friction::LuGreFriction>(p);
  const std::vector<joint::Recording> recordings = simulate::simulate_joint(plain);
  return method::hysteresis::identify_hysteresis(
             {&recordings.at(0)}, {}, {}, whole.gear_ratio,
             statistics::symmetric_estimate(q_peak_rad, 0, {"interval.known"}))
      .result.points;
}

}  // namespace

const friction::LuGreFriction& bristles_of(const simulate::Scenario& scenario) {
  const auto* lugre = dynamic_cast<const friction::LuGreFriction*>(scenario.presliding.get());
  if (lugre == nullptr) throw std::invalid_argument("the paper's joint has LuGre's friction");
  return *lugre;
}

const friction::WaiboerFriction& sliding_of(const simulate::Scenario& scenario) {
  const auto* waiboer = dynamic_cast<const friction::WaiboerFriction*>(scenario.sliding.get());
  if (waiboer == nullptr) throw std::invalid_argument("the paper's joint slides by eq. (6), (7)");
  return *waiboer;
}

DrawnLaws drawn_laws() {
  return {charts::stribeck_at_joint_scale(), charts::linear_zone_at_joint_scale(), {}};
}

PapersJoint::PapersJoint(const simulate::Scenario& given, robot::RobotDescription description,
                         DrawnLaws drawn)
    : scenario(given),
      robot(std::move(description)),
      dataset(simulate::simulated_dataset(given)),
      calibration(identify::identify(dataset)),
      plain_points(plain_loop_points(given, given.load.q_peak_rad())),
      laws(std::move(drawn)),
      presliding(charts::loops_of_figure_5(laws.contact)) {}

double PapersJoint::true_mass_kg() const {
  const joint::GravityLoad& load = scenario.load;
  return load.mass_kg() * load.distance_m() / scenario.surrogate_distance_m;
}

double PapersJoint::true_gravity_Nm() const {
  return scenario.load.amplitude_Nm() / scenario.gear_ratio;
}

double PapersJoint::oscillation_speed_rad_s(double t_s) const {
  const simulate::OscillationExperiment& e = present(scenario.oscillation);
  const double omega = 2 * std::numbers::pi * e.frequency_Hz;
  return scenario.gear_ratio * e.amplitude_rad * omega * std::cos(omega * t_s);
}

double PapersJoint::oscillation_acceleration_rad_s2(double t_s) const {
  const simulate::OscillationExperiment& e = present(scenario.oscillation);
  const double omega = 2 * std::numbers::pi * e.frequency_Hz;
  return -scenario.gear_ratio * e.amplitude_rad * omega * omega * std::sin(omega * t_s);
}

const joint::Recording& PapersJoint::recording(joint::Role role) const {
  const auto all = dataset.with_role(role);
  if (all.empty()) throw std::invalid_argument("the paper's scenario lacks an experiment");
  return *all.front();
}

const method::hysteresis::LoopPoint& PapersJoint::point(method::hysteresis::Estimator name) const {
  const auto& points = calibration.hysteresis.points;
  const auto found =
      std::find_if(points.begin(), points.end(),
                   [name](const method::hysteresis::LoopPoint& p) { return p.name == name; });
  if (found == points.end()) throw std::runtime_error("the paper's loop has lost a point");
  return *found;
}

}  // namespace tribolog::paper::checks
