#include "study/misfit_truths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "friction/lugre.h"
#include "study/misfit_scenario.h"

namespace tribolog::study {
namespace {

using joint::Quantity;
using joint::Role;
using simulate::FrictionChange;
using simulate::IdealRecording;
using simulate::Scenario;
using Truths = std::map<Quantity, double>;

constexpr double no_truth = std::numeric_limits<double>::quiet_NaN();

double fastest_of(const joint::Recording& r) {
  double fastest = 0;
  for (const double speed : r.dq_rad_s) fastest = std::max(fastest, std::abs(speed));
  return fastest;
}

/// Session time of all recordings but the ramps, which come at its end.
double session_s(const std::vector<IdealRecording>& ideal) {
  double whole_s = 0;
  for (const IdealRecording& one : ideal) {
    if (one.recording.role != Role::break_away) whole_s += one.recording.t_s.back();
  }
  return whole_s;
}

/// Mean over what moves in the recordings of a role, in both directions alike; no change where
/// there are none.
FrictionChange mean_change(const Scenario& s, const std::vector<IdealRecording>& ideal, Role role) {
  constexpr double moving = 0.3;  // of a recording's largest speed
  const double whole_s = session_s(ideal);
  double start_s = 0;
  double samples = 0;
  FrictionChange sum{0, 0};
  for (const auto& [r, rate] : ideal) {
    const double least = r.role == role ? moving * fastest_of(r) : 0;
    for (std::size_t i = 0; r.role == role && i < r.size(); ++i) {
      if (std::abs(r.dq_rad_s[i]) < least) continue;
      const double share = std::min(1.0, (start_s + r.t_s[i]) / whole_s);
      for (const double direction : {1.0, -1.0}) {
        const FrictionChange one = friction_change(s, r.q_rad[i], direction, share, role);
        sum.factor += one.factor;
        sum.of_load_Nm += one.of_load_Nm;
        ++samples;
      }
    }
    start_s += r.t_s.back();
  }
  if (samples == 0) return {};
  return {sum.factor / samples, sum.of_load_Nm / samples};
}

/// Of the load alone: gravity, and what follows from it.
Truths truths_of_load(const Scenario& s) {
  double q_peak = s.load.q_peak_rad();
  if (s.noise.effects.mirrored_angle) q_peak = -q_peak;
  // With the torque mirrored too the joint is one whose peak lies where the trough was.
  if (s.noise.effects.mirrored_angle && s.noise.effects.mirrored_torque) q_peak += std::numbers::pi;
  const double left = 1 - s.effects.gravity_left_out;
  const double mass_kg = s.load.amplitude_Nm() / (s.load.gravity_m_s2() * s.surrogate_distance_m);
  if (left == 0) {
    return {{Quantity::cog_angle, no_truth},
            {Quantity::gravity_torque, no_truth},
            {Quantity::surrogate_mass, no_truth}};
  }
  return {{Quantity::cog_angle, q_peak},
          {Quantity::gravity_torque, left * motor_gravity(s)},
          {Quantity::surrogate_mass, left * mass_kg}};
}

/// Of sliding and of breaking away, at the mean load, place and time of the runs.
Truths truths_of_sliding(const LuGreParameters& p, const Scenario& s,
                         const std::vector<IdealRecording>& ideal) {
  const FrictionChange runs = mean_change(s, ideal, Role::constant_speed);
  return {{Quantity::coulomb_torque, runs.factor * p.coulomb_Nm + runs.of_load_Nm},
          {Quantity::viscous_coefficient, runs.factor * p.viscous_Nms_rad},
          {Quantity::break_away_torque, runs.factor * p.static_Nm + runs.of_load_Nm}};
}

/// Of the contact before it slides, with which friction of the load builds up. What a gear loses
/// jumps from side to side, and bends no bristle.
Truths truths_of_bristle(const LuGreParameters& p, Scenario s,
                         const std::vector<IdealRecording>& ideal) {
  s.effects.gear_loss = 0;
  const FrictionChange loops = mean_change(s, ideal, Role::oscillation);
  const double factor = loops.factor + loops.of_load_Nm / p.static_Nm;
  return {{Quantity::bristle_stiffness, factor * p.bristle_stiffness_Nm_rad},
          {Quantity::bristle_damping, factor * p.bristle_damping_Nms_rad}};
}

}  // namespace

Truths truths_of(const Scenario& undisturbed, const Scenario& laid,
                 const std::vector<IdealRecording>& ideal) {
  const LuGreParameters& p = lugre_of(undisturbed);
  Scenario over_a_turn = laid;
  over_a_turn.effects.friction_by_motor_angle = 0;
  Truths t = truths_of_load(laid);
  t.merge(truths_of_sliding(p, over_a_turn, ideal));
  t.merge(truths_of_bristle(p, over_a_turn, ideal));
  const double n = laid.gear_ratio;
  t[Quantity::inertia] = laid.motor_inertia_kgm2 + laid.arm_inertia_kgm2 / (n * n);
  t[Quantity::stribeck_speed] = p.stribeck_speed_rad_s;
  if (const auto* now = dynamic_cast<const friction::LuGreFriction*>(laid.presliding.get())) {
    t[Quantity::stribeck_speed] = now->parameters().stribeck_speed_rad_s;
  }
  // Of a slope that goes on growing the definition's is none; of one that grows little it is the
  // secant's.
  constexpr double little = 0.15;
  if (std::abs(laid.effects.viscous_exponent - 1) >= little) {
    t[Quantity::viscous_coefficient] = no_truth;
  }
  if (laid.presliding->name() != "lugre") t[Quantity::bristle_damping] = no_truth;
  return t;
}

}  // namespace tribolog::study
