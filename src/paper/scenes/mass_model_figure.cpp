#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "paper/scenes/arm_drawing.h"
#include "paper/scenes/scene_figures.h"
#include "paper/scenes/scene_words.h"
#include "wording/tr.h"

namespace tribolog::paper::scenes {
namespace {

using wording::tr;

constexpr render::figure::Colour surrogate_colour{180, 50, 0};
constexpr double shown_above_level_rad = 20 * joint::rad_per_degree;

/// What the parts of the picture are drawn from.
struct Model {
  const robot::JointUnderTest& test;
  const TestNumbers& numbers;
  std::string n;                 ///< Index of the tested joint.
  double q_rad;                  ///< The angle that it is shown at.
  double line_rad;               ///< From the level to the link's line.
  statistics::Estimate q_c_rad;  ///< From there to the mass centre.
  double size_m;                 ///< Of the arm.

  [[nodiscard]] double far_m() const { return numbers.surrogate_distance_m; }
  [[nodiscard]] Eigen::Vector3d towards_mass() const {
    return test.towards_mass(q_rad, present(numbers.q_peak_rad).value);
  }
  [[nodiscard]] Eigen::Vector3d mass_centre_m(double distance_m) const {
    return test.place_m() + distance_m * towards_mass();
  }
};

/// A joint angle at which the level, the link's line and the mass centre are apart: a part of the
/// way up, as far as the joint goes.
double shown_angle(const robot::JointUnderTest& test, const TestNumbers& numbers) {
  const robot::ArmJoint& joint = test.joint();
  const robot::AngleRange range =
      numbers.range.value_or(robot::AngleRange{joint.lowest_rad, joint.highest_rad});
  return std::clamp(shown_above_level_rad - test.line_above_level_rad(), range.lowest_rad,
                    range.highest_rad);
}

void add_angles(render::figure::Scene& scene, const Model& model) {
  const auto sector = [&](const std::string& label, double radius_m, double from, double to,
                          render::figure::Colour colour) {
    render::figure::SceneSector one;
    one.centre = point(model.test.place_m());
    one.normal = point(model.test.axis());
    one.zero = point(model.test.level());
    one.label = label;
    one.radius_m = radius_m;
    one.from_rad = from;
    one.to_rad = to;
    one.colour = colour;
    add_angle(scene, one);
  };
  const double far = model.far_m();
  const double line = model.line_rad;
  sector("q_{" + model.n + "} = " + degrees_text(model.q_rad, 0), 1.62 * far, line - model.q_rad,
         line, paint::angle);
  const double q_c = model.q_c_rad.value;
  const std::string q_c_text =
      model.numbers.identified ? angle_text(model.numbers, model.q_c_rad) : degrees_text(q_c, 2);
  sector("q_{" + model.n + "}^{c} = " + q_c_text, 1.3 * far, line, line + q_c, paint::mass_angle);

  const auto ray = [&](double at, double reach, render::figure::LineStyle style,
                       render::figure::Colour colour, const std::string& end_text) {
    render::figure::SceneLine one;
    const Eigen::Vector3d end = model.test.place_m() + reach * model.test.above_level(at);
    one.points = {point(model.test.place_m()), point(end)};
    one.style = style;
    one.colour = colour;
    one.width_px = 2.2;
    scene.lines.push_back(one);
    if (!end_text.empty()) scene.texts.push_back({end_text, point(end), colour});
  };
  const double zero = line - model.q_rad;
  const bool from_level = std::abs(zero) < same_line_rad;
  ray(0, 1.75 * far, render::figure::LineStyle::dash, paint::level, from_level ? "" : tr("level"));
  if (!from_level) {
    ray(zero, 1.75 * far, render::figure::LineStyle::dot, paint::angle, "q_{" + model.n + "} = 0");
  }
  ray(line, 1.75 * far, render::figure::LineStyle::dash_dot, paint::angle, "");
  ray(line + q_c, 1.42 * far, render::figure::LineStyle::solid, paint::mass_angle, "");
}

void add_distances(render::figure::Scene& scene, const Model& model) {
  const Eigen::Vector3d across = model.test.axis().cross(model.towards_mass());
  const auto distance = [&](double metres, double away, const std::string& symbol,
                            render::figure::Colour colour) {
    render::figure::SceneDimension one;
    one.from = point(model.test.place_m());
    one.to = point(model.mass_centre_m(metres));
    one.shift = point(away * model.size_m * across);
    one.label = symbol + " = " + millimetres_text(metres);
    one.colour = colour;
    scene.dimensions.push_back(one);
  };
  if (const auto& mass = model.numbers.mass) {
    distance(mass->distance_m, -0.235, "r_{" + model.n + "}", paint::mass);
  }
  distance(model.far_m(), 0.205, "r_{" + model.n + "}^{REPL}", surrogate_colour);
}

/// Lengths of the links below the tested joint, from joint to joint, where they are long enough for
/// an arrow and its number.
void add_link_lengths(render::figure::Scene& scene, const Model& model,
                      const robot::ArmPose& pose) {
  constexpr double shortest_share = 0.2;
  constexpr double away_share = -0.15;
  const robot::SerialArm& arm = model.test.arm();
  for (std::size_t i = 1; i <= model.test.setting().joint; ++i) {
    const Eigen::Vector3d from = pose.frames[i - 1].translation();
    const Eigen::Vector3d to = pose.frames[i].translation();
    const double length = (to - from).norm();
    if (length < shortest_share * model.size_m) continue;
    render::figure::SceneDimension one;
    one.from = point(from);
    one.to = point(to);
    one.shift = point(away_share * model.size_m * model.test.level());
    one.label = "l_{" + index_text(arm.joints()[i - 1].name) + "} = " + millimetres_text(length);
    one.colour = paint::axis;
    scene.dimensions.push_back(one);
  }
}

void add_masses(render::figure::Scene& scene, const Model& model) {
  const auto ball = [&](double distance_m, const std::string& label,
                        render::figure::Colour colour) {
    render::figure::SceneBall one;
    one.centre = point(model.mass_centre_m(distance_m));
    one.radius_m = 0.0144 * model.size_m;
    one.label = label;
    one.colour = colour;
    one.inside = true;
    scene.balls.push_back(one);
  };
  if (const auto& mass = model.numbers.mass) {
    ball(mass->distance_m, "m_{" + model.n + "} = " + kilogram_text(mass->mass_kg), paint::mass);
  }
  ball(model.far_m(),
       "m_{" + model.n +
           "}^{REPL} = " + mass_text(model.numbers, present(model.numbers.surrogate_mass_kg)),
       surrogate_colour);
}

void add_gravity(render::figure::Scene& scene, const Model& model) {
  const Eigen::Vector3d hang = model.test.place_m() + 1.7 * model.far_m() * model.test.level();
  render::figure::SceneArrow gravity;
  gravity.from = point(hang - Eigen::Vector3d(0, 0, 0.145 * model.size_m));
  gravity.to = point(hang - Eigen::Vector3d(0, 0, 0.30 * model.size_m));
  gravity.radius_m = 0.0067 * model.size_m;
  gravity.colour = {120, 30, 110};
  gravity.label = fmt::format("g = {:.2f} m/s²", model.numbers.gravity_m_s2);
  scene.arrows.push_back(gravity);
}

render::figure::Scene draw(const Model& model) {
  const robot::JointUnderTest& test = model.test;
  const robot::SerialArm& arm = test.arm();
  const std::size_t tested = test.setting().joint;
  const robot::ArmPose pose = test.pose(model.q_rad);
  const double size = model.size_m;

  render::figure::Scene scene;
  scene.camera.towards = view_of_test(test, -0.40, 0.92, -0.22);
  scene.camera.margin = 0.04;
  render::figure::SceneGround ground;
  ground.half_size_m = 0.2 * size;
  ground.spacing_m = 0.1 * size;
  scene.ground = ground;
  ArmLook look;
  look.driven_from = tested;
  look.strength = 170;
  look.slimness = 0.72;
  add_arm(scene, arm, pose, look);
  add_post(scene, arm, pose, look);
  for (std::size_t i = 0; i <= tested; ++i) {
    const bool first = i == 0 && i != tested;
    add_axis(scene, arm, pose, i,
             clear_ahead_m(scene.camera, arm, pose, i, (first ? 0.2 : 0.072) * size),
             first ? 0.0 : 0.04 * size, "q_{" + index_text(arm.joints()[i].name) + "}",
             i == tested ? paint::tested_axis : paint::axis);
  }
  scene.arrows.back().label =
      tr("axis of joint {joint}", {{"joint", drawn_text(test.joint().name, 24)}});
  add_angles(scene, model);
  add_distances(scene, model);
  add_link_lengths(scene, model, pose);
  add_masses(scene, model);
  add_gravity(scene, model);
  add_base_frame(scene, 0.215 * size * test.level() + 0.155 * size * test.axis(), 0.082 * size);
  return scene;
}

/// The masses in words: with what is known, and nothing of what is not.
std::string numbers_in_words(const Model& model) {
  const TestNumbers& numbers = model.numbers;
  const std::string surrogate = mass_text(numbers, present(numbers.surrogate_mass_kg));
  const std::string far = millimetres_text(model.far_m());
  const std::string angle = size_text(numbers, model.q_c_rad);
  const bool is_below = model.q_c_rad.value < 0;
  const std::string& joint = model.test.joint().name;
  if (!numbers.mass) {
    return is_below ? tr("surrogate mass {surrogate_mass} at {surrogate_distance} from the axis of "
                         "joint {joint}, {angle} below the link's own line",
                         {{"surrogate_mass", surrogate},
                          {"surrogate_distance", far},
                          {"joint", joint},
                          {"angle", angle}})
                    : tr("surrogate mass {surrogate_mass} at {surrogate_distance} from the axis of "
                         "joint {joint}, {angle} above the link's own line",
                         {{"surrogate_mass", surrogate},
                          {"surrogate_distance", far},
                          {"joint", joint},
                          {"angle", angle}});
  }
  const std::string mass = kilogram_text(numbers.mass->mass_kg);
  const std::string near = millimetres_text(numbers.mass->distance_m);
  return is_below ? tr("mass {mass} at {distance} from the axis of joint {joint}, surrogate mass "
                       "{surrogate_mass} at {surrogate_distance}, both {angle} below the link's "
                       "own line",
                       {{"mass", mass},
                        {"distance", near},
                        {"joint", joint},
                        {"surrogate_mass", surrogate},
                        {"surrogate_distance", far},
                        {"angle", angle}})
                  : tr("mass {mass} at {distance} from the axis of joint {joint}, surrogate mass "
                       "{surrogate_mass} at {surrogate_distance}, both {angle} above the link's "
                       "own line",
                       {{"mass", mass},
                        {"distance", near},
                        {"joint", joint},
                        {"surrogate_mass", surrogate},
                        {"surrogate_distance", far},
                        {"angle", angle}});
}

std::string caption_of(const Model& model, const std::string& words) {
  const std::string& joint = model.test.joint().name;
  if (!model.numbers.mass) {
    return tr("What joint {joint} drives, as one mass at a chosen distance: {masses}.",
              {{"joint", joint}, {"masses", words}});
  }
  return tr(
      "What joint {joint} drives, as one mass at one distance: {masses}. m r is the same, so both "
      "need the same torque at every angle.",
      {{"joint", joint}, {"masses", words}});
}

std::string how_to_read(const Model& model) {
  const std::string zero =
      std::abs(model.test.line_above_level_rad()) < same_line_rad
          ? tr("q counts from the level (dashed) line to the link's own line (dash-dotted), the "
               "mass centre's angle q_c from there on.")
          : tr("q counts from the dotted line to the link's own line (dash-dotted), the mass "
               "centre's angle q_c from there on.");
  const std::string torque =
      tr("Gravity torque is m g r times the cosine of the mass centre's angle above the "
         "horizontal, and is largest where it is level.");
  const auto& mass = model.numbers.mass;
  const std::string known =
      mass ? tr("A log shows only m r: the distance r of the mass ({distance}) is not measured.",
                {{"distance", millimetres_text(mass->distance_m)}})
           : tr("A log shows only m r: the mass of the links and its distance are not known, the "
                "surrogate mass needs the same torque at every angle.");
  return sentences({zero, torque, known});
}

}  // namespace

std::optional<figures::ReportFigure> mass_model_figure(const robot::RobotDescription& robot,
                                                       const TestNumbers& numbers) {
  if (!numbers.q_peak_rad || !numbers.surrogate_mass_kg) return std::nullopt;
  const robot::JointUnderTest& test = robot.under_test;
  const double q_rad = shown_angle(test, numbers);
  const Model model{test,
                    numbers,
                    index_text(test.joint().name),
                    q_rad,
                    test.line_above_level_rad() + q_rad,
                    mass_angle_rad(test, *numbers.q_peak_rad),
                    test.arm().length_m()};

  figures::ReportFigure out;
  out.paper_number = 10;
  out.id = "fig-10-phenomenological-model";
  out.title = numbers.mass ? tr("Phenomenological model: driven mass and surrogate mass")
                           : tr("Phenomenological model: the surrogate mass");
  const std::string words = numbers_in_words(model);
  const std::string origin =
      numbers.identified ? tr("Angle and mass are identified; an interval is one of 95 %.") : "";
  out.caption = sentences({caption_of(model, words), origin, dimensions_note(robot)});
  out.how_to_read = how_to_read(model);
  out.alt =
      tr("Model of {robot} with joint {joint} at {joint_angle}: {masses}; gravity "
         "{gravity_m_s2:.2f} m/s² downwards.",
         {{"robot", test.arm().name()},
          {"joint", test.joint().name},
          {"joint_angle", degrees_text(q_rad, 0)},
          {"masses", words},
          {"gravity_m_s2", numbers.gravity_m_s2}});
  out.stage = "cog_rough";
  out.figure.height_px = 1300;
  out.figure.scene = draw(model);
  return out;
}

}  // namespace tribolog::paper::scenes
