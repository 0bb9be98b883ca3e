#pragma once
// The numbers of a test that the drawings show: stated in a robot's description, or identified.

#include <optional>
#include <string>

#include "calibration/calibration.h"
#include "robot/joint_under_test.h"
#include "statistics/estimate.h"

namespace tribolog::paper::scenes {

/// What the tested joint drives as a point; a log shows only the product of both.
struct DrivenMass {
  double mass_kg{};
  double distance_m{};
};

/// Each number where it is known. Stated numbers have intervals of no width.
struct TestNumbers {
  bool identified{false};
  std::optional<robot::AngleRange> range;  ///< Of the joint's motion.
  std::optional<statistics::Estimate> q_peak_rad;
  std::optional<DrivenMass> mass;
  std::optional<statistics::Estimate> surrogate_mass_kg;
  double surrogate_distance_m{0.5};
  double gravity_m_s2{9.81};
};

/// What the description states.
TestNumbers stated_numbers(const robot::RobotDescription& robot);

/// What a calibration found: q_peak, the recommended surrogate mass at the manifest's distance, and
/// the range of the rough sweep's samples (of the precise one, where that is all). Nothing that is
/// not finite.
TestNumbers identified_numbers(const calibration::Calibration& calibration);

/// The angle from the link's own line up to the mass centre, q_c, from -180° to 180°. It is -q_peak
/// where the joint's angle counts from the level, as in the paper.
statistics::Estimate mass_angle_rad(const robot::JointUnderTest& test,
                                    const statistics::Estimate& q_peak_rad);

/// "−22.23187°" as stated; "−22.232° ± 0.011°" as identified.
std::string angle_text(const TestNumbers& numbers, const statistics::Estimate& angle_rad);
/// Without its sign: "22.232° ± 0.011°".
std::string size_text(const TestNumbers& numbers, const statistics::Estimate& angle_rad);
/// "79.17 kg" as stated; "79.168 ± 0.044 kg" as identified.
std::string mass_text(const TestNumbers& numbers, const statistics::Estimate& mass_kg);

}  // namespace tribolog::paper::scenes
