#include "paper/scenes/scene_figures.h"

#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "ingest/manifest/robot_file.h"
#include "render/figure/scene.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::scene_figures_test {
namespace {

robot::RobotDescription example() {
  return ingest::manifest::read_robot(TRIBOLOG_SOURCE_DIR "/examples/paper/am100ib.toml");
}

void expect_part(const std::string& whole, const std::string& part) {
  EXPECT_NE(whole.find(part), std::string::npos) << whole;
}

const render::figure::SceneArrow& arrow(const figures::ReportFigure& figure,
                                        std::string_view label) {
  for (const render::figure::SceneArrow& one : figure.figure.scene->arrows) {
    if (one.label == label) return one;
  }
  throw std::runtime_error("no arrow " + std::string(label));
}

TEST(SceneFigures, AreDrawnWithoutErrorOrWarning) {
  const auto figures = paper::scenes::scene_figures(example());
  ASSERT_EQ(figures.size(), 3U);
  std::vector<render::figure::Figure> plain;
  for (const figures::ReportFigure& one : figures) plain.push_back(one.figure);
  const auto drawn = render::workers::FigureRenderer(1).draw(plain);
  const auto again = render::workers::FigureRenderer(2).draw(plain);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_EQ(wording::words(drawn[i].error), "") << drawn[i].id;
    EXPECT_TRUE(drawn[i].warnings.empty())
        << drawn[i].id << ": " << wording::words(drawn[i].warnings[0]);
    EXPECT_EQ(drawn[i].png, again[i].png) << drawn[i].id;
  }
}

TEST(SceneFigures, SayTheirNumbers) {
  const auto figures = paper::scenes::scene_figures(example());
  EXPECT_EQ(figures[0].paper_number, 9);
  EXPECT_EQ(figures[1].paper_number, 10);
  EXPECT_EQ(figures[2].paper_number, 12);
  for (const figures::ReportFigure& one : figures) {
    EXPECT_EQ(one.figure.id, one.id);
    EXPECT_FALSE(one.how_to_read.empty());
    expect_part(one.caption, "Dimensions are approximate.");
  }
  EXPECT_EQ(figures[1].id, "fig-10-phenomenological-model");
  expect_part(figures[1].alt, "mass 98.96 kg at 400 mm");
  expect_part(figures[1].alt, "surrogate mass 79.17 kg at 500 mm");
  expect_part(figures[2].alt, "joint 3 moves from −80° to 60°, 140° in all");
  expect_part(figures[2].alt, "level at −22.23187°");
}

TEST(SceneFigures, PointAxesTheRightWay) {
  for (const figures::ReportFigure& one : paper::scenes::scene_figures(example())) {
    const auto direction = [&](const char* label) {
      return render::figure::unit(arrow(one, label).to - arrow(one, label).from);
    };
    const auto z = render::figure::cross(direction("x"), direction("y"));
    EXPECT_NEAR(render::figure::length(z - direction("z")), 0.0, 1e-12) << one.id;
  }
  const auto figure = paper::scenes::robot_figure(example());
  std::set<std::string> axes;
  for (const auto& one : figure.figure.scene->arrows) axes.insert(one.label);
  for (const char* name : {"q_{1}", "q_{2}", "q_{3}", "q_{4}", "q_{5}", "q_{6}"}) {
    EXPECT_EQ(axes.count(name), 1U) << name;
  }
  const auto third = arrow(figure, "q_{3}");
  EXPECT_LT(third.to.y, third.from.y) << "a positive turn raises the forearm";
}

TEST(SceneFigures, PutTheMassesAndGravityWhereTheyBelong) {
  const robot::RobotDescription robot = example();
  const auto figures = paper::scenes::scene_figures(robot);
  const auto& model = figures.at(1);
  const auto& balls = model.figure.scene->balls;
  ASSERT_EQ(balls.size(), 2U);
  const Eigen::Vector3d joint = robot.under_test.place_m();
  const render::figure::Point3 centre{joint.x(), joint.y(), joint.z()};
  EXPECT_NEAR(render::figure::length(balls[0].centre - centre), 0.4, 1e-12);
  EXPECT_NEAR(render::figure::length(balls[1].centre - centre), 0.5, 1e-12);
  const auto& gravity = arrow(model, "g = 9.81 m/s²");
  EXPECT_LT(gravity.to.z, gravity.from.z);
  EXPECT_EQ(gravity.to.x, gravity.from.x);

  const auto& range = figures.at(2);
  const auto& mass = range.figure.scene->balls.at(0);
  EXPECT_NEAR(mass.centre.z, centre.z, 1e-12) << "level at q_peak";
  const auto& sector = range.figure.scene->sectors.at(0);
  EXPECT_NEAR(sector.to_rad - sector.from_rad, 140 * std::numbers::pi / 180, 1e-12);
}

/// The same robot with every length twice as long.
robot::RobotDescription doubled(const robot::RobotDescription& robot) {
  std::vector<robot::ArmJoint> joints = robot.under_test.arm().joints();
  for (robot::ArmJoint& one : joints) {
    one.offset_m *= 2;
    for (Eigen::Vector3d& bend : one.link_bends_m) bend *= 2;
    for (double* size : {&one.shape.radius_m, &one.shape.end_radius_m, &one.shape.bar_thickness_m,
                         &one.shape.drum_radius_m, &one.shape.drum_length_m}) {
      *size *= 2;
    }
  }
  robot::SerialArm arm("large", joints, 2 * robot.under_test.arm().tool_m());
  const joint::GravityLoad load = robot.load.value();
  return {robot::JointUnderTest(std::move(arm), robot.under_test.setting()),
          robot.portrait_rad,
          true,
          robot.range,
          joint::GravityLoad(load.mass_kg(), 2 * load.distance_m(), load.q_peak_rad()),
          2 * robot.surrogate_distance_m};
}

TEST(SceneFigures, LeaveOutWhatTheDescriptionDoesNotState) {
  robot::RobotDescription robot = example();
  robot.range.reset();
  auto figures = paper::scenes::scene_figures(robot);
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[1].paper_number, 10);
  robot = example();
  robot.load.reset();
  figures = paper::scenes::scene_figures(robot);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].paper_number, 9);
}

TEST(SceneFigures, GrowWithTheRobot) {
  const auto small = paper::scenes::scene_figures(example());
  const auto large = paper::scenes::scene_figures(doubled(example()));
  const auto expect_doubled = [](render::figure::Point3 a, render::figure::Point3 b) {
    EXPECT_NEAR(render::figure::length(b - 2.0 * a), 0.0, 1e-12);
  };
  for (std::size_t i = 0; i < small.size(); ++i) {
    const render::figure::Scene& a = *small[i].figure.scene;
    const render::figure::Scene& b = *large[i].figure.scene;
    ASSERT_EQ(a.arrows.size(), b.arrows.size());
    for (std::size_t k = 0; k < a.arrows.size(); ++k) {
      expect_doubled(a.arrows[k].from, b.arrows[k].from);
      expect_doubled(a.arrows[k].to, b.arrows[k].to);
      EXPECT_NEAR(b.arrows[k].radius_m, 2 * a.arrows[k].radius_m, 1e-12);
    }
    for (std::size_t k = 0; k < a.bodies.size(); ++k) {
      expect_doubled(a.bodies[k].from, b.bodies[k].from);
    }
    for (std::size_t k = 0; k < a.balls.size(); ++k) {
      expect_doubled(a.balls[k].centre, b.balls[k].centre);
      EXPECT_NEAR(b.balls[k].radius_m, 2 * a.balls[k].radius_m, 1e-12);
    }
    for (std::size_t k = 0; k < a.dimensions.size(); ++k) {
      expect_doubled(a.dimensions[k].shift, b.dimensions[k].shift);
    }
  }
}

}  // namespace
}  // namespace tribolog::scene_figures_test
