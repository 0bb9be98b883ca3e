#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "paper/scenes/arm_drawing.h"
#include "paper/scenes/scene_figures.h"
#include "paper/scenes/scene_words.h"

namespace tribolog {
namespace {

using namespace scenes;

constexpr render::Colour mass_colour{30, 30, 30};
constexpr render::Colour surrogate_colour{180, 50, 0};
constexpr render::Colour angle_colour{0, 90, 150};
constexpr render::Colour mass_angle_colour{0, 120, 85};

/// A joint angle at which q, q_c and their sum are apart: a part of the way up.
double shown_angle(const JointUnderTest& test) {
  const auto& setting = test.setting();
  const double wanted = 20 * std::numbers::pi / 180;
  return std::clamp(wanted, setting.lowest_rad, setting.highest_rad);
}

void add_angles(render::Scene& scene, const JointUnderTest& test, double q, const std::string& n) {
  const Eigen::Vector3d centre = test.place_m();
  const double q_c = -test.load().q_peak_rad();
  const double far = test.setting().surrogate_distance_m;
  render::SceneSector angle;
  angle.centre = point(centre);
  angle.normal = point(test.axis());
  angle.zero = point(test.level());
  angle.label = "q_{" + n + "} = " + degrees_text(q, 0);
  angle.radius_m = 1.62 * far;
  angle.from_rad = 0;
  angle.to_rad = q;
  angle.colour = angle_colour;
  scene.sectors.push_back(angle);
  angle.label = "q_{" + n + "}^{c} = " + degrees_text(q_c, 2);
  angle.radius_m = 1.3 * far;
  angle.from_rad = q;
  angle.to_rad = q + q_c;
  angle.colour = mass_angle_colour;
  scene.sectors.push_back(angle);

  const auto ray = [&](double at, double reach, render::LineStyle style, render::Colour colour) {
    render::SceneLine line;
    const Eigen::Vector3d way = Eigen::AngleAxisd(at, test.axis()) * test.level();
    line.points = {point(centre), point(centre + reach * way)};
    line.style = style;
    line.colour = colour;
    line.width_px = 2.2;
    scene.lines.push_back(line);
  };
  ray(0, 1.75 * far, render::LineStyle::dash, {90, 90, 90});
  ray(q, 1.75 * far, render::LineStyle::dash_dot, angle_colour);
  ray(q + q_c, 1.42 * far, render::LineStyle::solid, mass_angle_colour);
}

void add_distances(render::Scene& scene, const JointUnderTest& test, double q,
                   const std::string& n) {
  const Eigen::Vector3d across = test.axis().cross(test.towards_mass(q));
  const double size = reach_m(test.arm());
  const auto distance = [&](const Eigen::Vector3d& to, double away, const std::string& label,
                            render::Colour colour) {
    render::SceneDimension one;
    one.from = point(test.place_m());
    one.to = point(to);
    one.shift = point(away * across);
    one.label = label;
    one.colour = colour;
    scene.dimensions.push_back(one);
  };
  distance(test.mass_centre_m(q), -0.235 * size,
           "r_{" + n + "} = " + millimetres_text(test.load().distance_m()), mass_colour);
  distance(test.surrogate_centre_m(q), 0.205 * size,
           "r_{" + n + "}^{REPL} = " + millimetres_text(test.setting().surrogate_distance_m),
           surrogate_colour);
}

void add_masses(render::Scene& scene, const JointUnderTest& test, double q, const std::string& n) {
  const auto mass = [&](const Eigen::Vector3d& at, const std::string& label,
                        render::Colour colour) {
    render::SceneBall ball;
    ball.centre = point(at);
    ball.radius_m = 0.0144 * reach_m(test.arm());
    ball.label = label;
    ball.colour = colour;
    ball.inside = true;
    scene.balls.push_back(ball);
  };
  mass(test.mass_centre_m(q), "m_{" + n + "} = " + kilogram_text(test.load().mass_kg()),
       mass_colour);
  mass(test.surrogate_centre_m(q),
       "m_{" + n + "}^{REPL} = " + kilogram_text(test.surrogate_mass_kg()), surrogate_colour);
}

}  // namespace

ReportFigure mass_model_figure(const RobotDescription& robot) {
  const JointUnderTest& test = robot.under_test;
  const SerialArm& arm = test.arm();
  const std::size_t tested = test.setting().joint;
  const std::string n = index_text(arm.joints()[tested].name);
  const double q = shown_angle(test);
  const double q_c = -test.load().q_peak_rad();
  const ArmPose pose = test.pose(q);
  const double size = reach_m(arm);

  render::Scene scene;
  scene.camera.towards = {-0.40, 0.92, -0.22};
  scene.camera.margin = 0.04;
  render::SceneGround ground;
  ground.half_size_m = 0.2 * size;
  ground.spacing_m = 0.1 * size;
  scene.ground = ground;
  ArmLook look;
  look.driven_from = tested;
  look.strength = 170;
  look.slimness = 0.72;
  add_arm(scene, arm, pose, look);
  for (std::size_t i = 0; i <= tested; ++i) {
    add_axis(scene, arm, pose, i,
             clear_ahead_m(scene.camera, arm, pose, i, (i == 0 ? 0.2 : 0.072) * size),
             i == 0 ? 0.0 : 0.04 * size, "q_{" + index_text(arm.joints()[i].name) + "}",
             i == tested ? paint::tested_axis : paint::axis);
  }
  scene.arrows.back().label = "axis of joint " + arm.joints()[tested].name;
  add_angles(scene, test, q, n);
  add_distances(scene, test, q, n);
  add_masses(scene, test, q, n);

  const Eigen::Vector3d level = test.level();
  const Eigen::Vector3d hang = test.place_m() + 1.7 * test.setting().surrogate_distance_m * level;
  render::SceneArrow gravity;
  gravity.from = point(hang - Eigen::Vector3d(0, 0, 0.145 * size));
  gravity.to = point(hang - Eigen::Vector3d(0, 0, 0.30 * size));
  gravity.radius_m = 0.0067 * size;
  gravity.colour = {120, 30, 110};
  gravity.label = fmt::format("g = {:.2f} m/s²", test.load().gravity_m_s2());
  scene.arrows.push_back(gravity);
  add_base_frame(scene, {0.215 * size, -0.155 * size, 0}, 0.082 * size);

  ReportFigure out;
  out.number = 10;
  out.id = "fig-10-phenomenological-model";
  out.title = "Phenomenological model: driven mass and surrogate mass";
  const std::string numbers = fmt::format(
      "mass {} at {} from the axis of joint {}, surrogate mass {} at {}, both {} above the link's "
      "own line",
      kilogram_text(test.load().mass_kg()), millimetres_text(test.load().distance_m()),
      arm.joints()[tested].name, kilogram_text(test.surrogate_mass_kg()),
      millimetres_text(test.setting().surrogate_distance_m), degrees_text(q_c, 2));
  out.caption = fmt::format(
      "What joint {} drives, as one mass at one distance: {}. m r is the same, so that both ask "
      "the "
      "same torque at every angle.{}",
      arm.joints()[tested].name, numbers, dimensions_note(robot));
  out.how_to_read = fmt::format(
      "q counts from the level (dashed) to the link's own line (dash-dotted), the mass centre's "
      "angle from there on. Gravity torque is m g r times the cosine of their sum, and largest "
      "where the sum is zero. Only m r shows in a log: r of the mass ({}) is not measured.",
      millimetres_text(test.load().distance_m()));
  out.alt = fmt::format("Model of {} with joint {} at {}: {}; gravity {:.2f} m/s² downwards.",
                        arm.name(), arm.joints()[tested].name, degrees_text(q, 0), numbers,
                        test.load().gravity_m_s2());
  out.stage = "surrogate_masses";
  out.figure.height_px = 1300;
  out.figure.scene = std::move(scene);
  return out;
}

}  // namespace tribolog
