#pragma once
// Internal to the studies of misfit: joints by the numbers that tell one from another.

#include <string>
#include <vector>

#include "simulate/scenario.h"
#include "study/misfit_scenario.h"

namespace tribolog::study {

struct JointSketch {
  double gear_ratio;
  double motor_inertia_kgm2;
  double mass_kg;
  double distance_m;
  double q_peak_deg;
  LuGreParameters friction;
  double rate_Hz;
  double white_Nm;
  double torque_step_Nm;
  double encoder_counts;
  double fastest_rad_s;  ///< Motor side.
};

struct NamedSketch {
  std::string key;  ///< Stable: "geared_arm".
  JointSketch sketch;
};

/// Those of misfit_joints().
std::vector<NamedSketch> joint_sketches();

/// The joint with a rough sweep, oscillations, runs and ramps that fit it.
simulate::Scenario sketched(const JointSketch& sketch);

}  // namespace tribolog::study
