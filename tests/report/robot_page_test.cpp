// A whole robot on one page: each joint by its own calibration, whatever became of the others.

#include "report/document/robot_page.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/document/robot_matrix.h"
#include "report/document/thumbnail.h"
#include "report/document_checks.h"
#include "report/engine/embedded_json.h"
#include "report/run_python.h"
#include "report/sample_calibration.h"

namespace tribolog::test::robot_page_test {
namespace {

struct Robot {
  calibration::Calibration good = complete_calibration();
  calibration::Calibration poor = sweep_only();
  std::vector<report::document::RobotJoint> joints{
      {"J1", &good, "", {}, "J1.html"},
      {"J2", &poor, "", {}, "J 2.html"},
      {"J3", nullptr, "j3.csv: cannot be opened", {}, ""}};

  [[nodiscard]] std::string page() const {
    return report::document::robot_page(joints, sample_provenance());
  }
};

TEST(RobotPage, HasEachJointsVerdictNumbersAndWay) {
  const std::string page = Robot().page();
  EXPECT_EQ(occurrences(page, "<article"), 3U);
  EXPECT_NE(page.find("<a href=\"J1.html\"><bdi>J1</bdi></a>"), std::string::npos);
  EXPECT_NE(page.find("href=\"J%202.html\""), std::string::npos) << "a name may hold anything";
  EXPECT_NE(page.find("<p class=\"refusal\"><bdi>j3.csv: cannot be opened</bdi></p>"),
            std::string::npos);
  EXPECT_EQ(page.find("J3.html"), std::string::npos);
  EXPECT_NE(page.find("Angle of the centre of gravity"), std::string::npos);
  EXPECT_NE(page.find("class=\"thumbnails\""), std::string::npos);
  // No script runs; what is embedded is the numbers.
  EXPECT_EQ(occurrences(page, "<script"), 1U);
  const report::engine::EmbeddedJson numbers = report::engine::embedded_json(page, "robot.html");
  EXPECT_EQ(numbers.element, "tribolog-robot");
  const auto joints = nlohmann::json::parse(numbers.json)["joints"];
  ASSERT_EQ(joints.size(), 3U);
  EXPECT_EQ(joints[1]["report"], "J 2.html");
  EXPECT_EQ(joints[2]["refusal"], "j3.csv: cannot be opened");
  EXPECT_FALSE(joints[2].contains("quantities"));
  EXPECT_FALSE(joints[0]["quantities"].empty());
}

TEST(RobotPage, QuantitiesByJointsHaveOneUnitARow) {
  Robot robot;
  const auto at = [&](std::vector<calibration::FrictionAtSpeed>& all, double low, double high) {
    for (const double speed : {low, high}) {
      all.push_back({speed, calibration::Verdict::usable, {0.5, 0.4, 0.6, {}}, {}});
    }
  };
  at(robot.good.judgement.friction_at_speed, 0.9, 12);
  at(robot.poor.judgement.friction_at_speed, 8, 40);
  const auto rows = report::document::robot_matrix(robot.joints);
  const auto row = [&](const std::string& words) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.words == words; });
    if (found == rows.end()) {
      std::string all;
      for (const auto& one : rows) all += "; " + one.words;
      throw std::logic_error("no row " + words + " among" + all);
    }
    return *found;
  };
  for (const auto& one : rows) {
    ASSERT_EQ(one.cells.size(), 3U) << one.words;
    EXPECT_EQ(one.cells[2].outcome, report::document::Outcome::absent) << "J3 was refused";
    EXPECT_EQ(one.cells[2].text, "") << one.words;
  }
  EXPECT_EQ(row("Gravity torque").unit, "N·m");
  EXPECT_EQ(row("Gravity torque").cells[0].text.find("N·m"), std::string::npos);
  EXPECT_NE(row("Gravity torque").cells[0].text.find(" ± "), std::string::npos);
  // Each joint at the speeds that it reaches.
  EXPECT_NE(row("Friction at 1\u00a0rad/s").cells[0].text, "");
  EXPECT_EQ(row("Friction at 1\u00a0rad/s").cells[1].text, "");
  EXPECT_NE(row("Friction at 10\u00a0rad/s").cells[0].text, "");
  EXPECT_NE(row("Friction at 10\u00a0rad/s").cells[1].text, "");
  EXPECT_EQ(row("Friction at 30\u00a0rad/s").cells[0].text, "");
}

TEST(RobotPage, TheWorstJointDecides) {
  Robot robot;
  EXPECT_NE(robot.page().find("<span class=\"word\">REFUSED</span>"), std::string::npos);
  EXPECT_NE(robot.page().find("Refused: J3."), std::string::npos);
  robot.joints.resize(1);
  robot.good.judgement.verdict = calibration::Verdict::usable;
  EXPECT_NE(robot.page().find("<span class=\"word\">USABLE</span>"), std::string::npos);
  EXPECT_NE(robot.page().find("1 of 1 joints is usable."), std::string::npos);
}

TEST(RobotPage, TheSmallCurveIsThatOfTheLikeliestLaw) {
  calibration::Calibration c = complete_calibration();
  ASSERT_FALSE(c.viscous.runs.empty());
  const auto before = report::document::curve_thumbnail(c);
  ASSERT_TRUE(before);
  double fastest = 0;
  for (const auto& run : c.viscous.runs) fastest = std::max(fastest, run.speed_rad_s);
  // A law that is level is drawn level: all its points have one height.
  c.model.law.level_Nm = c.viscous.find(c.selection.recommended)->friction_Nm.back();
  c.model.law.rise_Nm = 0;
  c.model.law.slowest_rad_s = 0.5 * fastest;
  c.model.law.fastest_rad_s = fastest;
  const auto after = report::document::curve_thumbnail(c);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->measured, before->measured);
  EXPECT_NE(after->fitted, before->fitted);
  std::set<std::string> heights;
  const std::string& path = after->fitted;
  const std::size_t end = path.find('M', 1);
  std::istringstream parts(path.substr(0, end));
  std::string across, down;
  while (parts >> across >> std::ws && std::getline(parts, down, 'L')) heights.insert(down);
  EXPECT_EQ(heights.size(), 1U) << path;
}

TEST(RobotPage, IsSoundHtml) { EXPECT_TRUE(run_python(checks, Robot().page())); }

TEST(RobotPage, NoTextOfStrangersBecomesMarkup) {
  Robot robot;
  const auto structure = run_python(skeleton, robot.page());
  ASSERT_TRUE(structure);
  robot.joints[0].name = robot.joints[2].name = robot.joints[2].refusal = hostile;
  robot.good.manifest.robot = robot.good.manifest.serial = hostile;
  EXPECT_EQ(run_python(skeleton, robot.page()), structure);
}

}  // namespace
}  // namespace tribolog::test::robot_page_test
