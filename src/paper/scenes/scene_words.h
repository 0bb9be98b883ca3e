#pragma once
// What the drawings of the robot say: the numbers of a test, and points, angles and sentences.

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "calibration/calibration.h"
#include "render/figure/scene.h"
#include "robot/joint_under_test.h"
#include "statistics/estimate.h"

namespace tribolog::paper::scenes {

// The numbers of a test that the drawings show: stated in a robot's description, or identified.

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

inline render::figure::Point3 point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// "−22.23°", to so many places.
std::string degrees_text(double rad, int places);
/// Places with which the ends of a range are told apart.
int places_for(const robot::AngleRange& range);
/// "400 mm"
std::string millimetres_text(double metres);
/// "79.17 kg"
std::string kilogram_text(double kg);
/// A text from a file as one in a picture: without the braces of markup and without control
/// characters, cut to so many bytes.
std::string drawn_text(const std::string& text, std::size_t limit);
/// The name of a joint as an index: up to three letters or digits as they are, "3" or "J3"; others
/// in brackets.
std::string index_text(const std::string& joint_name);
/// "Dimensions are approximate." or nothing.
std::string dimensions_note(const robot::RobotDescription& robot);
/// One after the other; those that say nothing are left out.
std::string sentences(std::initializer_list<std::string> all);

}  // namespace tribolog::paper::scenes
