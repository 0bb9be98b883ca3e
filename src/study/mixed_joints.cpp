#include "study/mixed_joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "statistics/random_stream.h"
#include "study/joint_sketch.h"

namespace tribolog::study {
namespace {

using simulate::Scenario;
using statistics::RandomStream;

/// About 1.
double log_normal(RandomStream& random, double sd) { return std::exp(sd * random.normal()); }

JointSketch varied(JointSketch j, RandomStream& random) {
  const double gear = log_normal(random, 0.2);
  if (j.gear_ratio > 1) j.gear_ratio *= gear;  // a direct drive has none
  j.mass_kg *= log_normal(random, 0.3);
  j.distance_m *= log_normal(random, 0.15);
  j.q_peak_deg = 360 * random.uniform() - 180;
  const double level = log_normal(random, 0.3);
  LuGreParameters& p = j.friction;
  p.bristle_stiffness_Nm_rad *= level;
  p.bristle_damping_Nms_rad *= level;
  p.coulomb_Nm *= level;
  p.static_Nm *= level;
  p.viscous_Nms_rad *= level * log_normal(random, 0.3);
  p.stribeck_speed_rad_s *= log_normal(random, 0.3);
  const double noise = log_normal(random, 0.3);
  j.white_Nm *= noise;
  j.torque_step_Nm *= noise;
  j.encoder_counts = std::round(j.encoder_counts * log_normal(random, 0.5));
  return j;
}

double fastest_run_of(const Scenario& s) { return s.constant_speed->motor_speeds_rad_s.back(); }

/// Usual sizes, each times a normal number of its own.
class Sizes {
 public:
  Sizes(RandomStream& random, double size) : random_(&random), size_(size) {}
  double of(double usual) { return size_ * usual * random_->normal(); }
  /// Of what has one sign on all joints.
  double more_of(double usual) { return std::abs(of(usual)); }

 private:
  RandomStream* random_;
  double size_;
};

void lay_on_friction(Scenario& s, Sizes& sizes, RandomStream& random) {
  simulate::JointEffects& e = s.effects;
  e.direction_asymmetry = sizes.of(0.02);
  e.load_friction = sizes.more_of(0.015);
  e.warm_up = sizes.more_of(0.05);
  e.friction_by_angle = sizes.of(0.03);
  e.friction_by_motor_angle = sizes.of(0.02);
  e.phase_of_motor_angle_rad = 2 * std::numbers::pi * random.uniform();
  e.viscous_exponent = 1 + sizes.of(0.05);
  e.bent_viscous_Nms_rad = lugre_of(s).viscous_Nms_rad;
  e.bent_viscous_rad_s = fastest_run_of(s);
}

void lay_beside_gravity(Scenario& s, Sizes& sizes) {
  simulate::JointEffects& e = s.effects;
  const double gravity_Nm = motor_gravity(s);
  const double reach_rad = std::abs(s.rough_sweep->from_rad - s.load.q_peak_rad());
  e.torque_offset_Nm = sizes.of(0.005) * gravity_Nm;
  e.offset_drift_Nm = sizes.of(0.002) * gravity_Nm;
  e.spring_Nm_rad = sizes.of(0.001) * gravity_Nm / reach_rad;
  e.twice_the_angle_Nm = sizes.of(0.0005) * gravity_Nm;
}

void lay_on_log(Scenario& s, Sizes& sizes) {
  simulate::LogEffects& e = s.noise.effects;
  const double largest_Nm =
      motor_gravity(s) + std::abs(s.presliding->steady_torque_Nm(fastest_run_of(s)));
  e.torque_delay_s = sizes.of(0.001);
  e.saturation_per_Nm2 = sizes.more_of(0.005) / (largest_Nm * largest_Nm);
  e.coloured_Nm = sizes.more_of(0.5) * s.noise.torque_white_Nm;
  e.coloured_time_s = 0.1;
  e.scale_of_runs = 1 + sizes.of(0.002);
}

}  // namespace

MixedJoint mixed_joint(std::uint64_t seed, std::size_t number, double size) {
  constexpr std::uint64_t behind_those_of_noise = std::uint64_t{1} << 34U;
  RandomStream random(seed, behind_those_of_noise + number);
  const std::vector<NamedSketch> sketches = joint_sketches();
  const NamedSketch& about = sketches[number % sketches.size()];
  MixedJoint joint;
  joint.undisturbed = sketched(varied(about.sketch, random));
  joint.laid = joint.undisturbed;
  Sizes sizes(random, size);
  lay_on_friction(joint.laid, sizes, random);
  lay_beside_gravity(joint.laid, sizes);
  lay_on_log(joint.laid, sizes);
  return joint;
}

}  // namespace tribolog::study
