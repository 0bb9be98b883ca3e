#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "paper/scenes/arm_drawing.h"
#include "paper/scenes/scene_figures.h"
#include "paper/scenes/scene_words.h"

namespace tribolog {
namespace {

using namespace scenes;

constexpr render::Colour range_colour{0, 90, 150};
constexpr render::Colour mass_colour{30, 30, 30};
constexpr render::Colour mass_angle_colour{0, 120, 85};
constexpr render::Colour peak_colour{180, 50, 0};

/// Farthest point of the driven links from the tested axis.
double driven_reach_m(const JointUnderTest& test) {
  const ArmPose pose = test.pose(0.5 * (test.setting().lowest_rad + test.setting().highest_rad));
  double reach = (pose.tool_m - test.place_m()).norm();
  for (std::size_t i = test.setting().joint; i < pose.frames.size(); ++i) {
    reach = std::max(reach, (pose.frames[i].translation() - test.place_m()).norm());
  }
  return reach;
}

render::SceneSector sector_at(const JointUnderTest& test) {
  render::SceneSector sector;
  sector.centre = point(test.place_m());
  sector.normal = point(test.axis());
  sector.zero = point(test.level());
  return sector;
}

void add_ray(render::Scene& scene, const JointUnderTest& test, double angle, double reach,
             render::LineStyle style, render::Colour colour, const std::string& end_text) {
  const Eigen::Vector3d way = Eigen::AngleAxisd(angle, test.axis()) * test.level();
  render::SceneLine line;
  line.points = {point(test.place_m()), point(test.place_m() + reach * way)};
  line.style = style;
  line.colour = colour;
  scene.lines.push_back(line);
  if (!end_text.empty()) scene.texts.push_back({end_text, line.points.back(), colour});
}

}  // namespace

ReportFigure motion_range_figure(const RobotDescription& robot) {
  const JointUnderTest& test = robot.under_test;
  const SerialArm& arm = test.arm();
  const auto& setting = test.setting();
  const std::string n = index_text(arm.joints()[setting.joint].name);
  const double q_peak = test.load().q_peak_rad();
  const bool reaches_peak = q_peak >= setting.lowest_rad && q_peak <= setting.highest_rad;
  const double q = std::clamp(q_peak, setting.lowest_rad, setting.highest_rad);
  const double reach = driven_reach_m(test);
  const double size = reach_m(arm);

  render::Scene scene;
  scene.camera.towards = {-0.12, 0.98, -0.16};
  scene.camera.margin = 0.05;
  render::SceneGround ground;
  ground.half_size_m = 0.2 * size;
  ground.spacing_m = 0.1 * size;
  scene.ground = ground;
  for (const double end : {setting.lowest_rad, setting.highest_rad}) {
    ArmLook ghost;
    ghost.first = ghost.driven_from = setting.joint;
    ghost.strength = 70;
    add_arm(scene, arm, test.pose(end), ghost);
  }
  ArmLook look;
  look.driven_from = setting.joint;
  look.strength = 190;
  add_arm(scene, arm, test.pose(q), look);

  render::SceneSector range = sector_at(test);
  range.radius_m = 1.28 * reach;
  range.from_rad = setting.lowest_rad;
  range.to_rad = setting.highest_rad;
  range.filled = true;
  range.fill.alpha = 45;
  range.colour = range_colour;
  range.ends = render::ArcEnds::arrow_at_both;
  scene.sectors.push_back(range);
  render::SceneSector q_c = sector_at(test);
  q_c.radius_m = 1.1 * reach;
  q_c.from_rad = q;
  q_c.to_rad = q - q_peak;
  q_c.colour = mass_angle_colour;
  q_c.label = "q_{" + n + "}^{c} = " + degrees_text(-q_peak, 5);
  scene.sectors.push_back(q_c);

  const double beyond = 1.36 * reach;
  add_ray(scene, test, setting.lowest_rad, beyond, render::LineStyle::dash, range_colour,
          "q_{" + n + ",min} = " + degrees_text(setting.lowest_rad, 0));
  add_ray(scene, test, setting.highest_rad, beyond, render::LineStyle::dash, range_colour,
          "q_{" + n + ",max} = " + degrees_text(setting.highest_rad, 0));
  add_ray(scene, test, q, beyond, render::LineStyle::dash_dot, peak_colour,
          "q_{peak} = " + degrees_text(q_peak, 5));
  add_ray(scene, test, 0, beyond, render::LineStyle::dash, {90, 90, 90},
          "level, q_{" + n + "} = 0");

  render::SceneBall mass;
  mass.centre = point(test.mass_centre_m(q));
  mass.radius_m = 0.0154 * size;
  mass.colour = mass_colour;
  mass.inside = true;
  mass.label = "mass centre";
  scene.balls.push_back(mass);
  render::SceneArrow weight;
  weight.from = mass.centre;
  weight.to = point(test.mass_centre_m(q) - Eigen::Vector3d(0, 0, 0.185 * size));
  weight.radius_m = 0.006 * size;
  weight.colour = {120, 30, 110};
  weight.label = "m_{" + n + "} g";
  scene.arrows.push_back(weight);
  add_base_frame(scene, {-0.155 * size, -0.155 * size, 0}, 0.077 * size);

  ReportFigure out;
  out.number = 12;
  out.id = "fig-12-range-of-motion";
  out.title = "Range of motion and angular position of the mass centre";
  const double span = setting.highest_rad - setting.lowest_rad;
  const std::string numbers =
      fmt::format("joint {} moves from {} to {}, {} in all; its mass centre is {} at {}",
                  arm.joints()[setting.joint].name, degrees_text(setting.lowest_rad, 0),
                  degrees_text(setting.highest_rad, 0), degrees_text(span, 0),
                  reaches_peak ? "level" : "nearest to the level", degrees_text(q, 5));
  out.caption = fmt::format("In the test {}: there gravity torque is largest.{}", numbers,
                            dimensions_note(robot));
  out.how_to_read =
      "The sector is what the joint can sweep, its ends drawn pale. The mass centre lies above the "
      "link's own line by its constant angle, so the joint must stand that much below the level to "
      "bring it level. A sweep that does not pass through that angle cannot find it.";
  out.alt = fmt::format("Side view of {}: {}.", arm.name(), numbers);
  out.stage = "cog_sweep";
  out.figure.height_px = 1300;
  out.figure.scene = std::move(scene);
  return out;
}

}  // namespace tribolog
