// The robot's drawings in a report: with what was identified, and nothing else.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "figures/hand_made_calibration.h"
#include "ingest/manifest/robot_file.h"
#include "paper/scenes/scene_figures.h"
#include "render/figure/scene.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::identified_scenes_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

robot::RobotDescription paper_robot() {
  return ingest::manifest::read_robot(TRIBOLOG_SOURCE_DIR "/examples/paper/am100ib.toml");
}

robot::RobotDescription planar_arm() {
  return ingest::manifest::read_robot(TRIBOLOG_SOURCE_DIR "/tests/data/planar_arm.toml");
}

std::vector<int> numbers(const std::vector<figures::ReportFigure>& figures) {
  std::vector<int> all;
  for (const figures::ReportFigure& one : figures) all.push_back(one.paper_number.value_or(0));
  return all;
}

void expect_part(const std::string& whole, const std::string& part) {
  EXPECT_NE(whole.find(part), std::string::npos) << part << " in " << whole;
}

void expect_no_part(const std::string& whole, const std::string& part) {
  EXPECT_EQ(whole.find(part), std::string::npos) << part << " in " << whole;
}

std::string words_of(const figures::ReportFigure& figure) {
  return figure.title + figure.caption + figure.how_to_read + figure.alt;
}

void expect_drawn(const std::vector<figures::ReportFigure>& figures) {
  std::vector<render::figure::Figure> plain;
  for (const figures::ReportFigure& one : figures) plain.push_back(one.figure);
  for (const auto& drawn :
       render::workers::FigureRenderer(1, render::workers::Prepared::charts_and_scenes)
           .draw(plain)) {
    EXPECT_EQ(wording::words(drawn.error), "") << drawn.id;
    EXPECT_TRUE(drawn.warnings.empty()) << drawn.id << ": " << wording::words(drawn.warnings[0]);
  }
}

class IdentifiedScenes : public ::testing::Test {
 protected:
  void set_q_peak(double degrees, double half_degrees) {
    calibration_.q_peak_rad =
        statistics::symmetric_estimate(degrees * degree, half_degrees * degree);
  }
  void set_mass(double kg, double half_kg) {
    calibration_.masses.masses.resize(1);
    calibration_.masses.masses[0].estimator = method::hysteresis::Estimator::midline;
    calibration_.masses.masses[0].mass_kg = statistics::symmetric_estimate(kg, half_kg);
    calibration_.selection.recommended = method::hysteresis::Estimator::midline;
  }

  joint::Dataset dataset_ = test::hand_made_dataset();
  calibration::Calibration calibration_ = test::hand_made_calibration(dataset_);
};

TEST_F(IdentifiedScenes, ShowWhatWasFoundAndNotWhatTheFileStates) {
  set_q_peak(-21, 0.25);
  set_mass(64.25, 0.5);
  calibration_.manifest.surrogate_distance_m = 0.6;
  const auto figures = paper::scenes::scene_figures(paper_robot(), calibration_);
  ASSERT_EQ(numbers(figures), (std::vector<int>{9, 10, 12}));
  const figures::ReportFigure& model = figures[1];
  expect_part(model.caption, "surrogate mass 64.25 ± 0.50 kg at 600 mm from the axis of joint 3");
  expect_part(model.caption, "21.00° ± 0.25° above the link's own line");
  expect_part(model.caption, "identified");
  const figures::ReportFigure& range = figures[2];
  expect_part(range.caption, "its mass centre is level at −21.00° ± 0.25°");
  for (const figures::ReportFigure& one : figures) {
    EXPECT_EQ(one.stage, "cog_rough");
    for (const char* stated : {"98.96", "79.17", "400 mm", "22.23"}) {
      expect_no_part(words_of(one), stated);
    }
  }
  // One ball only, at the surrogate's distance: nobody knows where the links' own mass is.
  const render::figure::Scene& scene = *model.figure.scene;
  ASSERT_EQ(scene.balls.size(), 1U);
  EXPECT_EQ(scene.balls[0].label, "m_{3}^{REPL} = 64.25 ± 0.50 kg");
  const Eigen::Vector3d joint = paper_robot().under_test.place_m();
  const render::figure::Point3 centre{joint.x(), joint.y(), joint.z()};
  EXPECT_NEAR(render::figure::length(scene.balls[0].centre - centre), 0.6, 1e-12);
  // Its distance, and the length of the upper arm, which is in the description.
  ASSERT_EQ(scene.dimensions.size(), 2U);
  EXPECT_EQ(scene.dimensions[0].label, "r_{3}^{REPL} = 600 mm");
  EXPECT_EQ(scene.dimensions[1].label, "l_{2} = 600 mm");
  expect_drawn(figures);
}

// The angle between the arm's pictured pose and the level, whatever the file says of the test.
TEST_F(IdentifiedScenes, DrawTheRangeOfTheSweepsSamples) {
  set_q_peak(-21, 0.25);
  const auto sweeps = dataset_.with_role(joint::Role::rough_sweep);
  const auto [least, most] =
      std::minmax_element(sweeps.at(0)->q_rad.begin(), sweeps.at(0)->q_rad.end());
  const double lowest = *least;
  const double highest = *most;
  const auto range = paper::scenes::scene_figures(paper_robot(), calibration_).at(2);
  const render::figure::SceneSector& sector = range.figure.scene->sectors.at(0);
  EXPECT_NEAR(sector.from_rad, lowest, 1e-9);
  EXPECT_NEAR(sector.to_rad, highest, 1e-9);
  // Without a rough sweep that of the precise one, in which the ends are apart by a part of a
  // degree.
  calibration_.curves.rough = {};
  const auto narrow = paper::scenes::scene_figures(paper_robot(), calibration_).at(2);
  EXPECT_LT(narrow.figure.scene->sectors.at(0).to_rad, highest - 0.1);
}

TEST_F(IdentifiedScenes, LeaveOutTheFigureWhoseNumbersAreMissing) {
  const robot::RobotDescription robot = paper_robot();
  EXPECT_EQ(numbers(paper::scenes::scene_figures(robot, calibration::Calibration{})),
            (std::vector<int>{9}));
  calibration::Calibration some = calibration_;
  some.selection.recommended.reset();
  EXPECT_EQ(numbers(paper::scenes::scene_figures(robot, some)), (std::vector<int>{9, 12}));
  some = calibration_;
  some.q_peak_rad.reset();
  EXPECT_EQ(numbers(paper::scenes::scene_figures(robot, some)), (std::vector<int>{9}));
  some = calibration_;
  some.curves.rough = some.curves.precise = {};
  EXPECT_EQ(numbers(paper::scenes::scene_figures(robot, some)), (std::vector<int>{9, 10}));
  some = calibration_;
  some.q_peak_rad->high = std::numeric_limits<double>::infinity();
  EXPECT_EQ(numbers(paper::scenes::scene_figures(robot, some)), (std::vector<int>{9}));
}

TEST_F(IdentifiedScenes, SayWhereTheSweepDidNotReachThePeak) {
  set_q_peak(130, 2);
  const auto range = paper::scenes::scene_figures(paper_robot(), calibration_).at(2);
  expect_part(range.caption,
              "does not bring its mass centre level, which would be at 130.0° ± 2.0°");
  expect_drawn({range});
}

// Upright at 0, so that the level is at -90° and the mass centre 5° below the link's line.
TEST_F(IdentifiedScenes, CountAsTheLogOfAnotherArmCounts) {
  set_q_peak(-85, 0.2);
  set_mass(12, 0.1);
  joint::Recording sweep;
  sweep.role = joint::Role::rough_sweep;
  sweep.q_rad = {-150 * degree, 20 * degree};
  calibration_.curves.rough.lowest_rad = sweep.q_rad.front();
  calibration_.curves.rough.highest_rad = sweep.q_rad.back();
  const robot::RobotDescription robot = planar_arm();
  const auto figures = paper::scenes::scene_figures(robot, calibration_);
  ASSERT_EQ(numbers(figures), (std::vector<int>{9, 10, 12}));
  expect_part(figures[1].caption, "5.00° ± 0.20° below the link's own line");
  expect_part(figures[2].caption, "joint shoulder moves from −150° to 20°, 170° in all");
  for (const figures::ReportFigure& one : figures) expect_no_part(one.caption, "approximate");
  // The sector's ends are where the arm is drawn at the ends of the sweep.
  const render::figure::SceneSector& sector = figures[2].figure.scene->sectors.at(0);
  for (const double q : sweep.q_rad) {
    const double above = sector.from_rad + (q - sweep.q_rad[0]);
    const Eigen::Vector3d flange = robot.under_test.pose(q).tool_m - robot.under_test.place_m();
    EXPECT_LT((flange.normalized() - robot.under_test.above_level(above)).norm(), 1e-9);
  }
  expect_drawn(figures);
  for (const double q_peak : {-90.0, -90.3, -88.0}) {
    set_q_peak(q_peak, 0.05);  // along the link's line, as where the links are symmetric
    expect_drawn(paper::scenes::scene_figures(robot, calibration_));
  }
}

TEST_F(IdentifiedScenes, StandAmongTheFiguresInTheOrderOfTheirNumbers) {
  std::vector<figures::ReportFigure> charts(3);
  charts[0].paper_number = 11;
  charts[1].paper_number = 13;
  charts[2].paper_number = 14;
  const robot::RobotDescription robot = paper_robot();
  EXPECT_EQ(numbers(paper::scenes::with_scene_figures(charts, &robot, calibration_)),
            (std::vector<int>{9, 10, 11, 12, 13, 14}));
  EXPECT_EQ(numbers(paper::scenes::with_scene_figures({}, &robot, calibration_)),
            (std::vector<int>{9, 10, 12}));
  EXPECT_EQ(numbers(paper::scenes::with_scene_figures(charts, nullptr, calibration_)),
            (std::vector<int>{11, 13, 14}));
}

TEST_F(IdentifiedScenes, DrawHostileNamesAsText) {
  const robot::RobotDescription plain = planar_arm();
  std::vector<robot::ArmJoint> joints = plain.under_test.arm().joints();
  joints[0].name = "}^{x}_{\x1b[31m\n<script>alert(1)</script>";
  joints[1].name = std::string(5000, '{');
  const robot::SerialArm arm("_{<b>}\xff\u202e" + std::string(5000, 'W'), joints,
                             plain.under_test.arm().tool_m());
  const robot::RobotDescription robot{
      robot::JointUnderTest(arm, plain.under_test.setting()), plain.portrait_rad, false, {}, {}};
  const auto figures = paper::scenes::scene_figures(robot, calibration_);
  ASSERT_EQ(figures.size(), 3U);
  std::vector<render::figure::Figure> pictures;
  for (const figures::ReportFigure& one : figures) {
    pictures.push_back(one.figure);
    expect_no_part(one.figure.title, "_{");
    for (const render::figure::SceneArrow& arrow : one.figure.scene->arrows) {
      EXPECT_LT(arrow.label.size(), 80U);
      expect_no_part(arrow.label, "\x1b");
      expect_no_part(arrow.label, "}^{x}");
    }
  }
  for (const auto& drawn : render::workers::FigureRenderer(1).draw(pictures)) {
    EXPECT_EQ(wording::words(drawn.error), "") << drawn.id;
  }
}

}  // namespace
}  // namespace tribolog::identified_scenes_test
