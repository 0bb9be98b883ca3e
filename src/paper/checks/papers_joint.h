#pragma once
// What the checks of the paper are computed from: its joint simulated, identified, and varied.

#include <memory>
#include <vector>

#include "calibration/calibration.h"
#include "friction/catalogue.h"
#include "friction/lugre.h"
#include "friction/static_laws.h"
#include "joint/dataset.h"
#include "paper/charts/paper_charts.h"
#include "robot/joint_under_test.h"
#include "simulate/scenario.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

// The friction models that the paper's scenario must have. @throw std::invalid_argument if not.
const friction::LuGreFriction& bristles_of(const simulate::Scenario& scenario);
const friction::WaiboerFriction& sliding_of(const simulate::Scenario& scenario);

/// What the paper draws without its joint: figures 1, 2 and 5.
struct DrawnLaws {
  friction::StribeckFriction discontinuous;     ///< Eq. (1) at the joint's size, and
  friction::ThresholdSpeedFriction continuous;  ///< eq. (2).
  friction::ContactParameters contact;          ///< Table 1, as meant.
};
DrawnLaws drawn_laws();

struct PapersJoint {
  simulate::Scenario scenario;  ///< The paper's joint without noise.
  robot::RobotDescription robot;
  joint::Dataset dataset;                ///< Simulated from the scenario.
  calibration::Calibration calibration;  ///< Identified from the dataset, which it refers to.
  /// The loop's six points of the same joint without inertia and without Stribeck effect.
  std::vector<method::hysteresis::LoopPoint> plain_points;
  DrawnLaws laws;
  charts::PreslidingLoops presliding;  ///< Figure 5.

  PapersJoint(const simulate::Scenario& scenario, robot::RobotDescription robot,
              DrawnLaws laws = drawn_laws());
  PapersJoint(const PapersJoint&) = delete;
  PapersJoint& operator=(const PapersJoint&) = delete;

  /// What an identification should find: surrogate mass at the scenario's distance [kg], and
  /// gravity's amplitude at the motor, G/n [N·m].
  [[nodiscard]] double true_mass_kg() const;
  [[nodiscard]] double true_gravity_Nm() const;
  /// Motor speed and acceleration of the ideal source during the oscillation [rad/s, rad/s²].
  [[nodiscard]] double oscillation_speed_rad_s(double t_s) const;
  [[nodiscard]] double oscillation_acceleration_rad_s2(double t_s) const;
  /// The recording of a role; the first if there are several.
  [[nodiscard]] const joint::Recording& recording(joint::Role role) const;
  /// A point of the start-up stroke, as table 2 has it.
  [[nodiscard]] const method::hysteresis::LoopPoint& point(
      method::hysteresis::Estimator name) const;
};

}  // namespace tribolog::paper::checks
