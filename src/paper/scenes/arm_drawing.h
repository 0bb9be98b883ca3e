#pragma once
// An arm in a pose as solid parts of a scene.

#include "render/figure/scene.h"
#include "robot/joint_under_test.h"
#include "robot/serial_arm.h"

namespace tribolog::paper::scenes {

namespace paint {
inline constexpr render::figure::Colour standing{196, 203,
                                                 210};  ///< Links that the test does not move.
inline constexpr render::figure::Colour driven{228, 186, 104};   ///< Links that it does.
inline constexpr render::figure::Colour housing{138, 146, 155};  ///< Of joints.
inline constexpr render::figure::Colour axis{0, 90, 150};
inline constexpr render::figure::Colour tested_axis{190, 70, 0};
inline constexpr render::figure::Colour angle{0, 90, 150};  ///< Of the tested joint.
inline constexpr render::figure::Colour mass{30, 30, 30};
inline constexpr render::figure::Colour mass_angle{0, 120,
                                                   85};  ///< From the link's line to the mass.
inline constexpr render::figure::Colour level{90, 90, 90};
}  // namespace paint

/// Lines closer than this are one but for rounding.
inline constexpr double same_line_rad = 1e-6;

struct ArmLook {
  std::size_t first{0};         ///< The first link that is drawn.
  std::size_t driven_from{99};  ///< The first in the colour of driven links.
  std::uint8_t strength{255};   ///< Alpha of every colour: less for a pose that is not the present.
  double slimness{1.0};         ///< Factor of all radii.
};

/// Adds links and housings, from the base or from link `first` on.
void add_arm(render::figure::Scene& scene, const robot::SerialArm& arm, const robot::ArmPose& pose,
             const ArmLook& look);

/// Adds the axis of a joint as an arrow that comes out of its housing on the side of positive turns
/// by `ahead_m`, and on the other by `behind_m`. Where the link runs along the axis and would hide
/// it, the arrow stands behind the link before, `ahead_m + behind_m` long, and points at the joint.
void add_axis(render::figure::Scene& scene, const robot::SerialArm& arm, const robot::ArmPose& pose,
              std::size_t joint, double ahead_m, double behind_m, const std::string& label,
              render::figure::Colour colour);

/// How far the arrow of an axis must come out of its housing not to be hidden behind it; at least
/// `wanted_m`.
double clear_ahead_m(const render::figure::SceneCamera& camera, const robot::SerialArm& arm,
                     const robot::ArmPose& pose, std::size_t joint, double wanted_m);

/// Adds a post from the base's origin to the first joint, where its housing does not stand there.
void add_post(render::figure::Scene& scene, const robot::SerialArm& arm, const robot::ArmPose& pose,
              const ArmLook& look);

/// Direction of view onto the plane in which the tested joint turns, its positive turns
/// counter-clockwise: so much along the level, so much against the axis, so much upwards.
render::figure::Point3 view_of_test(const robot::JointUnderTest& test, double level, double ahead,
                                    double up);

/// Adds an angle with its label on the arc. That of a narrow angle stands beyond the arc, which a
/// text would hide; an angle too narrow for an arc has its label alone.
void add_angle(render::figure::Scene& scene, render::figure::SceneSector angle);

/// The base's frame, right-handed, at a point on the floor.
void add_base_frame(render::figure::Scene& scene, const Eigen::Vector3d& at_m, double length_m);

}  // namespace tribolog::paper::scenes
