#pragma once
// A joint with everything known that a plan needs: what is stated, and for the rest usual numbers,
// each of which the plan names as an assumption.
//
// Where nothing is stated, torques scale with the torque limit, and the shape of friction is that
// of the paper's joint (method.md, section 4): coulomb and viscous friction as shares of the
// break-away torque, the Stribeck velocity 5 rad/s at the motor, the bristles' deflection at
// break-away 1.9 mrad there.

#include <string>
#include <vector>

#include "base/statement.h"
#include "joint/joint_facts.h"
#include "simulate/scenario.h"

namespace tribolog::plan {

/// One number that the plan rests on.
struct Assumption {
  Statement what;    ///< "Break-away torque"
  double value{};    ///< In the unit.
  std::string unit;  ///< "N·m"; empty: a pure number.
  Statement source;  ///< "stated", "identified", or why it is usual: a few words.
  bool is_known{};   ///< Stated or identified.
};

struct AssumedJoint {
  joint::JointFacts facts;
  bool peak_is_known{};  ///< Else `q_peak_rad` is a guess that only simulations use.
  double q_peak_rad{};
  double gravity_Nm{};    ///< Motor side.
  double inertia_kgm2{};  ///< At the motor shaft.
  double static_Nm{};     ///< Motor side, as all friction.
  double coulomb_Nm{};
  double stribeck_speed_rad_s{};
  double viscous_coefficient{};  ///< c_v of eq. (6), with power 0.6.
  double bristle_stiffness_Nm_rad{};
  double sample_rate_Hz{};
  double set_point_rate_Hz{};
  simulate::Noise noise;
  std::vector<Assumption> assumptions;  ///< All of them, those stated too.

  /// Largest motor torque that friction takes up to this motor speed, without inertia [N·m].
  [[nodiscard]] double friction_Nm(double motor_speed_rad_s) const;
  /// Deflection of the bristles at which the joint breaks away, motor side [rad].
  [[nodiscard]] double breakaway_deflection_rad() const {
    return static_Nm / bristle_stiffness_Nm_rad;
  }
};

/// @throw std::invalid_argument as check_joint_facts().
AssumedJoint assume_joint(const joint::JointFacts& facts);

/// The joint as something to simulate: friction by LuGre and eq. (6), gravity, noise; no
/// experiments.
simulate::Scenario assumed_scenario(const AssumedJoint& joint);

}  // namespace tribolog::plan
