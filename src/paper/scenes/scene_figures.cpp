#include "paper/scenes/scene_figures.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "paper/scenes/arm_drawing.h"
#include "paper/scenes/scene_words.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::paper::scenes {
namespace {

using wording::tr;
using wording::tr_count;

constexpr double parallel = 0.999;  // cosine between axes: 2.6 degrees

/// Six joints, the first upright and the next two level and parallel: then these two bring the
/// wrist as far out as it goes.
bool is_articulated(const robot::SerialArm& arm) {
  if (arm.size() != 6) return false;
  const auto axis = [&](std::size_t i) { return arm.joints()[i].axis; };
  return std::abs(axis(0).z()) > parallel && std::abs(axis(1).z()) < 1 - parallel &&
         std::abs(axis(1).dot(axis(2))) > parallel;
}

/// Farthest that the centre of the wrist, the last joint but one, gets from the first axis while
/// the second and third joint turn through their ranges; 0 for an arm of another kind.
double wrist_reach_m(const robot::RobotDescription& robot) {
  const robot::SerialArm& arm = robot.under_test.arm();
  if (!is_articulated(arm)) return 0.0;
  constexpr int steps = 60;
  const auto share_of = [&](std::size_t joint, int i) {
    const robot::ArmJoint& one = arm.joints()[joint];
    return one.lowest_rad + (one.highest_rad - one.lowest_rad) * i / steps;
  };
  std::vector<double> angles = robot.portrait_rad;
  double reach = 0;
  for (int i = 0; i <= steps; ++i) {
    for (int k = 0; k <= steps; ++k) {
      angles[1] = share_of(1, i);
      angles[2] = share_of(2, k);
      const robot::ArmPose pose = arm.pose(angles);
      const Eigen::Vector3d from =
          pose.frames[arm.size() - 2].translation() - pose.frames.front().translation();
      const Eigen::Vector3d axis = arm.axis(pose, 0);
      reach = std::max(reach, (from - from.dot(axis) * axis).norm());
    }
  }
  return reach;
}

/// "The wrist reaches 1.4 m from the axis of joint 1.", or nothing for an arm of another kind.
std::string reach_sentence(const robot::RobotDescription& robot) {
  const double reach = wrist_reach_m(robot);
  if (!(reach > 0)) return {};
  return tr("The wrist reaches {reach_m:.1f} m from the axis of joint {joint}.",
            {{"reach_m", reach}, {"joint", robot.under_test.arm().joints().front().name}});
}

/// Where its axis points and how far it turns.
std::string axis_words(const robot::ArmJoint& joint) {
  const std::string lowest = degrees_text(joint.lowest_rad, 0);
  const std::string highest = degrees_text(joint.highest_rad, 0);
  if (std::abs(joint.axis.z()) > parallel) {
    return tr("joint {joint} upright, {lowest_angle} to {highest_angle}",
              {{"joint", joint.name}, {"lowest_angle", lowest}, {"highest_angle", highest}});
  }
  if (std::abs(joint.axis.x()) > parallel) {
    return tr("joint {joint} along x, {lowest_angle} to {highest_angle}",
              {{"joint", joint.name}, {"lowest_angle", lowest}, {"highest_angle", highest}});
  }
  if (std::abs(joint.axis.y()) > parallel) {
    return tr("joint {joint} along y, {lowest_angle} to {highest_angle}",
              {{"joint", joint.name}, {"lowest_angle", lowest}, {"highest_angle", highest}});
  }
  return tr("joint {joint} oblique, {lowest_angle} to {highest_angle}",
            {{"joint", joint.name}, {"lowest_angle", lowest}, {"highest_angle", highest}});
}

std::string tested_sentence(const robot::SerialArm& arm, std::size_t tested) {
  return tr_count(
      static_cast<std::int64_t>(arm.size()),
      "{robot} with its joint; joint {joint} is tested and moves the links in the "
      "warm colour.",
      "{robot} with its {joints} joints; joint {joint} is tested and moves the links "
      "in the warm colour.",
      {{"robot", arm.name()}, {"joints", arm.size()}, {"joint", arm.joints()[tested].name}});
}

}  // namespace

figures::ReportFigure robot_figure(const robot::RobotDescription& robot) {
  const robot::SerialArm& arm = robot.under_test.arm();
  const std::size_t tested = robot.under_test.setting().joint;
  const robot::ArmPose pose = arm.pose(robot.portrait_rad);
  const double size = arm.length_m();

  render::figure::Scene scene;
  scene.camera.towards = {-0.62, 0.95, -0.40};
  scene.camera.opening_deg = 22;
  scene.camera.margin = 0.03;
  render::figure::SceneGround ground;
  ground.half_size_m = 0.3 * size;
  ground.spacing_m = 0.1 * size;
  ground.centre = {0.05 * size, 0, 0};
  scene.ground = ground;
  ArmLook look;
  look.driven_from = tested;
  add_arm(scene, arm, pose, look);
  add_post(scene, arm, pose, look);
  std::vector<std::string> axes;
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const robot::ArmJoint& joint = arm.joints()[i];
    const bool upright = std::abs(arm.axis(pose, i).z()) > parallel;
    const double ahead = (i == 0 && upright ? 0.26 : 0.09) * size;
    add_axis(scene, arm, pose, i, clear_ahead_m(scene.camera, arm, pose, i, ahead),
             i == 0 && upright ? 0.0 : 0.03 * size, "q_{" + index_text(joint.name) + "}",
             i == tested ? paint::tested_axis : paint::axis);
    axes.push_back(axis_words(joint));
  }
  add_base_frame(scene, {-0.15 * size, -0.2 * size, 0}, 0.09 * size);

  figures::ReportFigure out;
  out.paper_number = 9;
  out.id = "fig-09-robot";
  out.title = tr("The robot, {robot}", {{"robot", arm.name()}});
  out.caption =
      sentences({tested_sentence(arm, tested), reach_sentence(robot), dimensions_note(robot)});
  out.how_to_read = tr(
      "Each arrow is the axis of a joint: seen against its direction, a positive angle turns the "
      "links behind it counter-clockwise. Links that the tested joint does not move are grey.");
  out.alt = tr("Three-dimensional drawing of {robot}, its axes with every joint at 0: {axes}.",
               {{"robot", arm.name()}, {"axes", wording::listed(axes)}});
  out.stage = "cog_rough";
  out.figure.height_px = 1200;
  out.figure.scene = std::move(scene);
  return out;
}

// All of them.

namespace {

std::vector<figures::ReportFigure> drawn_with(const robot::RobotDescription& robot,
                                              const TestNumbers& numbers) {
  std::vector<figures::ReportFigure> figures{robot_figure(robot)};
  for (auto& one : {mass_model_figure(robot, numbers), motion_range_figure(robot, numbers)}) {
    if (one) figures.push_back(*one);
  }
  for (figures::ReportFigure& one : figures) {
    one.figure.id = one.id;
    one.figure.title = drawn_text(one.title, 90);
  }
  return figures;
}

}  // namespace

std::vector<figures::ReportFigure> scene_figures(const robot::RobotDescription& robot) {
  return drawn_with(robot, stated_numbers(robot));
}

std::vector<figures::ReportFigure> scene_figures(const robot::RobotDescription& robot,
                                                 const calibration::Calibration& calibration) {
  return drawn_with(robot, identified_numbers(calibration));
}

std::vector<figures::ReportFigure> with_scene_figures(std::vector<figures::ReportFigure> figures,
                                                      const robot::RobotDescription* robot,
                                                      const calibration::Calibration& calibration) {
  if (robot == nullptr) return figures;
  for (figures::ReportFigure& scene : scene_figures(*robot, calibration)) {
    const auto after = std::find_if(
        figures.begin(), figures.end(),
        [&](const figures::ReportFigure& one) { return one.paper_number > scene.paper_number; });
    figures.insert(after, std::move(scene));
  }
  return figures;
}

}  // namespace tribolog::paper::scenes
