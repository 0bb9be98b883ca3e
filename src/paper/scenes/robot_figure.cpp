#include <cmath>

#include <fmt/format.h>

#include "paper/scenes/arm_drawing.h"
#include "paper/scenes/scene_figures.h"
#include "paper/scenes/scene_words.h"

#include "figures/number_text.h"

namespace tribolog {
namespace {

/// Farthest that the last joint's centre can be from the first axis, with the chain stretched from
/// the second joint on.
double wrist_reach_m(const SerialArm& arm) {
  double reach = 0;
  if (arm.size() > 1) {
    reach = std::hypot(arm.joints()[1].offset_m.x(), arm.joints()[1].offset_m.y());
  }
  // Joints 4 to 6 of such an arm turn about points of one straight line.
  Eigen::Vector3d forearm = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < arm.size() && i < 5; ++i) {
    if (i == 2) {
      reach += arm.joints()[i].offset_m.norm();
    } else {
      forearm += arm.joints()[i].offset_m;
    }
  }
  return reach + forearm.norm();
}

std::string turns_about(const Eigen::Vector3d& axis) {
  if (std::abs(axis.z()) > 0.9) return "upright";
  return std::abs(axis.x()) > 0.9 ? "along the link" : "level";
}

}  // namespace

ReportFigure robot_figure(const RobotDescription& robot) {
  using namespace scenes;
  const SerialArm& arm = robot.under_test.arm();
  const std::size_t tested = robot.under_test.setting().joint;
  const ArmPose pose = arm.pose(robot.portrait_rad);
  const double size = reach_m(arm);

  render::Scene scene;
  scene.camera.towards = {-0.62, 0.95, -0.40};
  scene.camera.opening_deg = 22;
  scene.camera.margin = 0.03;
  render::SceneGround ground;
  ground.half_size_m = 0.6;
  ground.centre = {0.1, 0, 0};
  scene.ground = ground;
  ArmLook look;
  look.driven_from = tested;
  add_arm(scene, arm, pose, look);
  std::vector<std::string> axes;
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const ArmJoint& joint = arm.joints()[i];
    const double ahead = (i == 0 ? 0.26 : 0.09) * size;
    add_axis(scene, arm, pose, i, clear_ahead_m(scene.camera, arm, pose, i, ahead),
             i == 0 ? 0.0 : 0.03 * size, "q_{" + joint.name + "}",
             i == tested ? paint::tested_axis : paint::axis);
    axes.push_back(fmt::format("joint {} {}, {} to {}", joint.name, turns_about(joint.axis),
                               degrees_text(joint.lowest_rad, 0),
                               degrees_text(joint.highest_rad, 0)));
  }
  add_base_frame(scene, {-0.3, -0.4, 0}, 0.09 * size);

  ReportFigure out;
  out.number = 9;
  out.id = "fig-09-robot";
  out.title = "The robot, " + arm.name();
  out.caption = fmt::format(
      "{} with its {} joints; joint {} is tested and moves the links in the warm colour. The wrist "
      "reaches {:.1f} m from the first axis.{}",
      arm.name(), arm.size(), arm.joints()[tested].name, wrist_reach_m(arm),
      dimensions_note(robot));
  out.how_to_read =
      "Each arrow is the axis of a joint: seen against its direction, a positive angle turns the "
      "links behind it counter-clockwise. Links that the tested joint does not move stand grey.";
  out.alt = fmt::format("Three-dimensional drawing of {}, axes at angle 0 of every joint: {}.",
                        arm.name(), figures::listed(axes));
  out.stage = "cog_sweep";
  out.figure.height_px = 1200;
  out.figure.scene = std::move(scene);
  return out;
}

}  // namespace tribolog
