#include "paper/scenes/arm_drawing.h"

#include <algorithm>
#include <cmath>

#include "paper/scenes/scene_words.h"

namespace tribolog::paper::scenes {
namespace {

// Shares of the arm's length, so that a larger arm gives the same picture.
constexpr double axis_radius = 0.0046;
constexpr double tip_gap = 0.01;
constexpr double frame_radius = 0.04;  // of the length of the frame's axes
// Shares of the radius of the first joint's housing.
constexpr double hidden_share = 0.05;
constexpr double post_share = 0.7;
constexpr double narrow_rad = 0.26;     // 15 degrees: the arc is hardly longer than its head
constexpr double narrowest_rad = 0.02;  // 1 degree: less than the width of the lines
constexpr double beyond_arc = 1.07;     // of the arc's radius

render::figure::Colour faded(render::figure::Colour colour, std::uint8_t strength) {
  colour.alpha = strength;
  return colour;
}

/// The link's corners in the base's frame: its joint, its bends, and the next joint or the flange.
std::vector<Eigen::Vector3d> corners(const robot::SerialArm& arm, const robot::ArmPose& pose,
                                     std::size_t i) {
  std::vector<Eigen::Vector3d> out{pose.frames[i].translation()};
  for (const Eigen::Vector3d& bend : arm.joints()[i].link_bends_m) {
    out.push_back(pose.frames[i] * bend);
  }
  out.push_back(i + 1 < arm.size() ? Eigen::Vector3d(pose.frames[i + 1].translation())
                                   : pose.tool_m);
  return out;
}

void add_link(render::figure::Scene& scene, const robot::SerialArm& arm, const robot::ArmPose& pose,
              std::size_t i, const ArmLook& look, render::figure::Colour colour) {
  const robot::LinkShape& shape = arm.joints()[i].shape;
  const auto points = corners(arm, pose, i);
  const auto pieces = static_cast<double>(points.size() - 1);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto radius_at = [&](std::size_t corner) {
      const double share = static_cast<double>(corner) / pieces;
      return look.slimness * (shape.radius_m + share * (shape.end_radius_m - shape.radius_m));
    };
    render::figure::SceneBody body;
    body.from = point(points[k]);
    body.to = point(points[k + 1]);
    body.from_radius_m = radius_at(k);
    body.to_radius_m = radius_at(k + 1);
    body.thickness_m = look.slimness * shape.bar_thickness_m;
    body.normal = point(arm.axis(pose, i));
    body.colour = colour;
    scene.bodies.push_back(body);
  }
}

bool runs_along_axis(const robot::SerialArm& arm, const robot::ArmPose& pose, std::size_t joint) {
  if (joint == 0 || joint + 1 >= arm.size()) return false;
  const Eigen::Vector3d link =
      pose.frames[joint + 1].translation() - pose.frames[joint].translation();
  return link.norm() > 0 && link.normalized().dot(arm.axis(pose, joint)) > 0.9;
}

/// How far the link before reaches behind the joint, along its axis.
double clear_behind_m(const robot::SerialArm& arm, const robot::ArmPose& pose, std::size_t joint) {
  const Eigen::Vector3d axis = arm.axis(pose, joint);
  double reach = arm.joints()[joint].shape.drum_length_m / 2;
  for (const Eigen::Vector3d& corner : corners(arm, pose, joint - 1)) {
    const double behind = (pose.frames[joint].translation() - corner).dot(axis);
    reach = std::max(reach, behind + arm.joints()[joint - 1].shape.radius_m);
  }
  return reach;
}

}  // namespace

void add_arm(render::figure::Scene& scene, const robot::SerialArm& arm, const robot::ArmPose& pose,
             const ArmLook& look) {
  for (std::size_t i = look.first; i < arm.size(); ++i) {
    const render::figure::Colour base = i >= look.driven_from ? paint::driven : paint::standing;
    add_link(scene, arm, pose, i, look, faded(base, look.strength));
    const robot::LinkShape& shape = arm.joints()[i].shape;
    render::figure::SceneDrum drum;
    drum.centre = point(pose.frames[i].translation());
    drum.axis = point(arm.axis(pose, i));
    drum.radius_m = look.slimness * shape.drum_radius_m;
    drum.length_m = look.slimness * shape.drum_length_m;
    drum.colour = faded(paint::housing, look.strength);
    scene.drums.push_back(drum);
  }
}

void add_axis(render::figure::Scene& scene, const robot::SerialArm& arm, const robot::ArmPose& pose,
              std::size_t joint, double ahead_m, double behind_m, const std::string& label,
              render::figure::Colour colour) {
  const Eigen::Vector3d centre = pose.frames[joint].translation();
  const Eigen::Vector3d axis = arm.axis(pose, joint);
  const double half = arm.joints()[joint].shape.drum_length_m / 2;
  render::figure::SceneArrow arrow;
  arrow.label = label;
  arrow.from = point(centre - (half + behind_m) * axis);
  arrow.to = point(centre + (half + ahead_m) * axis);
  if (runs_along_axis(arm, pose, joint)) {
    const double tip = clear_behind_m(arm, pose, joint) + tip_gap * arm.length_m();
    arrow.from = point(centre - (tip + ahead_m + behind_m) * axis);
    arrow.to = point(centre - tip * axis);
  }
  arrow.radius_m = axis_radius * arm.length_m();
  arrow.colour = colour;
  scene.arrows.push_back(arrow);
}

double clear_ahead_m(const render::figure::SceneCamera& camera, const robot::SerialArm& arm,
                     const robot::ArmPose& pose, std::size_t joint, double wanted_m) {
  const Eigen::Vector3d view =
      Eigen::Vector3d(camera.towards.x, camera.towards.y, camera.towards.z).normalized();
  const Eigen::Vector3d axis = arm.axis(pose, joint);
  const double away = axis.dot(view);
  if (away <= 0) return wanted_m;
  const robot::LinkShape& shape = arm.joints()[joint].shape;
  const double seen = (axis - away * view).norm();
  const double needed = 2.2 * shape.drum_radius_m / std::max(0.2, seen) - shape.drum_length_m / 2;
  return std::max(wanted_m, needed);
}

void add_post(render::figure::Scene& scene, const robot::SerialArm& arm, const robot::ArmPose& pose,
              const ArmLook& look) {
  const double radius_m = look.slimness * arm.joints().front().shape.drum_radius_m;
  const double length_m = look.slimness * arm.joints().front().shape.drum_length_m;
  const Eigen::Vector3d top = pose.frames.front().translation();
  const Eigen::Vector3d axis = arm.axis(pose, 0);
  const double height = top.norm();
  const double along = std::abs(top.dot(axis));
  const bool in_housing =
      height - along < hidden_share * radius_m && along <= length_m / 2 + hidden_share * radius_m;
  if (in_housing) return;
  render::figure::SceneDrum post;
  post.centre = point(0.5 * top);
  post.axis = point(top);
  post.radius_m = post_share * radius_m;
  post.length_m = height;
  post.colour = faded(paint::standing, look.strength);
  scene.drums.push_back(post);
}

render::figure::Point3 view_of_test(const robot::JointUnderTest& test, double level, double ahead,
                                    double up) {
  const Eigen::Vector3d view =
      level * test.level() - ahead * test.axis() + up * Eigen::Vector3d::UnitZ();
  return point(view);
}

void add_angle(render::figure::Scene& scene, render::figure::SceneSector angle) {
  const double span = std::abs(angle.to_rad - angle.from_rad);
  if (span < narrow_rad) {
    const Eigen::Vector3d normal(angle.normal.x, angle.normal.y, angle.normal.z);
    const Eigen::Vector3d zero(angle.zero.x, angle.zero.y, angle.zero.z);
    const Eigen::Vector3d middle =
        Eigen::AngleAxisd((angle.from_rad + angle.to_rad) / 2, normal) * zero;
    const Eigen::Vector3d centre(angle.centre.x, angle.centre.y, angle.centre.z);
    scene.texts.push_back(
        {angle.label, point(centre + beyond_arc * angle.radius_m * middle), angle.colour});
    angle.label.clear();
  }
  if (span >= narrowest_rad) scene.sectors.push_back(angle);
}

void add_base_frame(render::figure::Scene& scene, const Eigen::Vector3d& at_m, double length_m) {
  const char* names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    render::figure::SceneArrow arrow;
    arrow.label = names[i];
    arrow.from = point(at_m);
    arrow.to = point(at_m + length_m * Eigen::Vector3d::Unit(i));
    arrow.radius_m = frame_radius * length_m;
    arrow.colour = {60, 60, 60};
    scene.arrows.push_back(arrow);
  }
}

}  // namespace tribolog::paper::scenes
