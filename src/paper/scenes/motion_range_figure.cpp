#include <algorithm>
#include <cmath>
#include <numbers>

#include "paper/scenes/arm_drawing.h"
#include "paper/scenes/scene_figures.h"
#include "paper/scenes/scene_words.h"
#include "wording/tr.h"

namespace tribolog::paper::scenes {
namespace {

using wording::tr;

constexpr render::figure::Colour peak_colour{180, 50, 0};

/// What the parts of the picture are drawn from.
struct TestMotion {
  const robot::JointUnderTest& test;
  const TestNumbers& numbers;
  robot::AngleRange range;
  statistics::Estimate q_peak_rad;
  std::string n;   ///< Index of the tested joint.
  double q_rad;    ///< The angle that it is shown at: q_peak, or the end of the range nearest it.
  double reach_m;  ///< Farthest point of the driven links from the tested axis.
  double size_m;   ///< Of the arm.

  [[nodiscard]] bool reaches_peak() const { return q_rad == q_peak_rad.value; }
  /// Where the link's own line points at a joint angle, from the level.
  [[nodiscard]] double line_rad(double q) const { return test.line_above_level_rad() + q; }
};

double driven_reach_m(const robot::JointUnderTest& test) {
  const robot::ArmPose pose = test.pose(0);
  double reach = (pose.tool_m - test.place_m()).norm();
  for (std::size_t i = test.setting().joint; i < pose.frames.size(); ++i) {
    reach = std::max(reach, (pose.frames[i].translation() - test.place_m()).norm());
  }
  return std::max(reach, test.joint().shape.drum_radius_m);
}

void add_arms(render::figure::Scene& scene, const TestMotion& motion) {
  const robot::JointUnderTest& test = motion.test;
  for (const double end : {motion.range.lowest_rad, motion.range.highest_rad}) {
    ArmLook ghost;
    ghost.first = ghost.driven_from = test.setting().joint;
    ghost.strength = 70;
    add_arm(scene, test.arm(), test.pose(end), ghost);
  }
  ArmLook look;
  look.driven_from = test.setting().joint;
  look.strength = 190;
  const robot::ArmPose pose = test.pose(motion.q_rad);
  add_arm(scene, test.arm(), pose, look);
  add_post(scene, test.arm(), pose, look);
}

render::figure::SceneSector sector_at(const robot::JointUnderTest& test) {
  render::figure::SceneSector sector;
  sector.centre = point(test.place_m());
  sector.normal = point(test.axis());
  sector.zero = point(test.level());
  return sector;
}

void add_sectors(render::figure::Scene& scene, const TestMotion& motion) {
  render::figure::SceneSector range = sector_at(motion.test);
  range.radius_m = 1.28 * motion.reach_m;
  range.from_rad = motion.line_rad(motion.range.lowest_rad);
  range.to_rad = motion.line_rad(motion.range.highest_rad);
  range.filled = true;
  range.fill.alpha = 45;
  range.colour = paint::angle;
  range.ends = render::figure::ArcEnds::arrow_at_both;
  scene.sectors.push_back(range);
  const statistics::Estimate angle = mass_angle_rad(motion.test, motion.q_peak_rad);
  render::figure::SceneSector q_c = sector_at(motion.test);
  q_c.radius_m = 1.1 * motion.reach_m;
  q_c.from_rad = motion.line_rad(motion.q_rad);
  q_c.to_rad = q_c.from_rad + angle.value;
  q_c.colour = paint::mass_angle;
  q_c.label = "q_{" + motion.n + "}^{c} = " + angle_text(motion.numbers, angle);
  add_angle(scene, q_c);
}

void add_rays(render::figure::Scene& scene, const TestMotion& motion) {
  const auto ray = [&](double above_level, render::figure::LineStyle style,
                       render::figure::Colour colour, const std::string& end_text) {
    const Eigen::Vector3d end =
        motion.test.place_m() + 1.36 * motion.reach_m * motion.test.above_level(above_level);
    render::figure::SceneLine line;
    line.points = {point(motion.test.place_m()), point(end)};
    line.style = style;
    line.colour = colour;
    scene.lines.push_back(line);
    scene.texts.push_back({end_text, point(end), colour});
  };
  const std::string q = "q_{" + motion.n;
  const int places = places_for(motion.range);
  const robot::AngleRange& range = motion.range;
  ray(motion.line_rad(range.lowest_rad), render::figure::LineStyle::dash, paint::angle,
      q + ",min} = " + degrees_text(range.lowest_rad, places));
  ray(motion.line_rad(range.highest_rad), render::figure::LineStyle::dash, paint::angle,
      q + ",max} = " + degrees_text(range.highest_rad, places));
  if (motion.reaches_peak()) {
    ray(motion.line_rad(motion.q_rad), render::figure::LineStyle::dash_dot, peak_colour,
        "q_{peak} = " + angle_text(motion.numbers, motion.q_peak_rad));
  }
  const double zero = motion.line_rad(0);
  const bool from_level = std::abs(zero) < same_line_rad;
  ray(0, render::figure::LineStyle::dash, paint::level,
      from_level ? tr("level, {joint_angle} = 0", {{"joint_angle", q + "}"}}) : tr("level"));
  if (!from_level) ray(zero, render::figure::LineStyle::dot, paint::angle, q + "} = 0");
}

/// The mass centre with its weight; the surrogate mass where only that is known.
void add_mass(render::figure::Scene& scene, const TestMotion& motion) {
  const auto& known = motion.numbers.mass;
  const double distance_m = known ? known->distance_m : motion.numbers.surrogate_distance_m;
  const Eigen::Vector3d centre =
      motion.test.place_m() +
      distance_m * motion.test.towards_mass(motion.q_rad, motion.q_peak_rad.value);
  render::figure::SceneBall mass;
  mass.centre = point(centre);
  mass.radius_m = 0.0154 * motion.size_m;
  mass.colour = paint::mass;
  mass.inside = true;
  mass.label = known ? tr("mass centre") : tr("surrogate mass");
  scene.balls.push_back(mass);
  render::figure::SceneArrow weight;
  weight.from = mass.centre;
  weight.to = point(centre - Eigen::Vector3d(0, 0, 0.185 * motion.size_m));
  weight.radius_m = 0.006 * motion.size_m;
  weight.colour = {120, 30, 110};
  weight.label = "m_{" + motion.n + (known ? "} g" : "}^{REPL} g");
  scene.arrows.push_back(weight);
}

render::figure::Scene draw(const TestMotion& motion) {
  const double size = motion.size_m;
  const robot::JointUnderTest& test = motion.test;
  render::figure::Scene scene;
  scene.camera.towards = view_of_test(test, -0.12, 0.98, -0.16);
  scene.camera.margin = 0.05;
  render::figure::SceneGround ground;
  ground.half_size_m = 0.2 * size;
  ground.spacing_m = 0.1 * size;
  scene.ground = ground;
  add_arms(scene, motion);
  add_sectors(scene, motion);
  add_rays(scene, motion);
  add_mass(scene, motion);
  add_base_frame(scene, -0.155 * size * test.level() + 0.155 * size * test.axis(), 0.077 * size);
  return scene;
}

/// The range and the peak, as texts.
struct MotionTexts {
  std::string lowest;
  std::string highest;
  std::string span;
  std::string peak;
};

MotionTexts texts_of(const TestMotion& motion) {
  const robot::AngleRange& range = motion.range;
  const int places = places_for(range);
  return {degrees_text(range.lowest_rad, places), degrees_text(range.highest_rad, places),
          degrees_text(range.highest_rad - range.lowest_rad, places),
          angle_text(motion.numbers, motion.q_peak_rad)};
}

std::string motion_sentence(const TestMotion& motion) {
  const auto [lowest, highest, span, peak] = texts_of(motion);
  const std::string& joint = motion.test.joint().name;
  return motion.reaches_peak()
             ? tr("In the test joint {joint} moves from {lowest_angle} to {highest_angle}, {span} "
                  "in all; its mass centre is level at {peak_angle}: there gravity torque is "
                  "largest.",
                  {{"joint", joint},
                   {"lowest_angle", lowest},
                   {"highest_angle", highest},
                   {"span", span},
                   {"peak_angle", peak}})
             : tr("In the test joint {joint} moves from {lowest_angle} to {highest_angle}, {span} "
                  "in all; that does not bring its mass centre level, which would be at "
                  "{peak_angle}: there gravity torque is largest.",
                  {{"joint", joint},
                   {"lowest_angle", lowest},
                   {"highest_angle", highest},
                   {"span", span},
                   {"peak_angle", peak}});
}

std::string side_view_in_words(const TestMotion& motion) {
  const auto [lowest, highest, span, peak] = texts_of(motion);
  const std::string& robot = motion.test.arm().name();
  const std::string& joint = motion.test.joint().name;
  return motion.reaches_peak()
             ? tr("Side view of {robot}: joint {joint} moves from {lowest_angle} to "
                  "{highest_angle}, {span} in all; its mass centre is level at {peak_angle}.",
                  {{"robot", robot},
                   {"joint", joint},
                   {"lowest_angle", lowest},
                   {"highest_angle", highest},
                   {"span", span},
                   {"peak_angle", peak}})
             : tr("Side view of {robot}: joint {joint} moves from {lowest_angle} to "
                  "{highest_angle}, {span} in all; that does not bring its mass centre level, "
                  "which would be at {peak_angle}.",
                  {{"robot", robot},
                   {"joint", joint},
                   {"lowest_angle", lowest},
                   {"highest_angle", highest},
                   {"span", span},
                   {"peak_angle", peak}});
}

}  // namespace

std::optional<figures::ReportFigure> motion_range_figure(const robot::RobotDescription& robot,
                                                         const TestNumbers& numbers) {
  if (!numbers.q_peak_rad || !numbers.range) return std::nullopt;
  const robot::AngleRange range = *numbers.range;
  const double span = range.highest_rad - range.lowest_rad;
  if (!(span > 0 && span <= 2 * std::numbers::pi)) return std::nullopt;
  const robot::JointUnderTest& test = robot.under_test;
  const TestMotion motion{
      test,
      numbers,
      range,
      *numbers.q_peak_rad,
      index_text(test.joint().name),
      std::clamp(numbers.q_peak_rad->value, range.lowest_rad, range.highest_rad),
      driven_reach_m(test),
      test.arm().length_m()};

  figures::ReportFigure out;
  out.paper_number = 12;
  out.id = "fig-12-range-of-motion";
  out.title = tr("Range of motion and angular position of the mass centre");
  const std::string origin =
      numbers.identified ? tr("The angle is identified; an interval is one of 95 %.") : "";
  out.caption = sentences({motion_sentence(motion), origin, dimensions_note(robot)});
  out.how_to_read =
      tr("The sector is what the joint swept, with its ends drawn pale. The mass centre keeps its "
         "angle q_c to the link's own line, so the joint must be at q_peak to bring it level. A "
         "sweep that does not pass through that angle cannot find it.");
  out.alt = side_view_in_words(motion);
  out.stage = "cog_rough";
  out.figure.height_px = 1300;
  out.figure.scene = draw(motion);
  return out;
}

}  // namespace tribolog::paper::scenes
