// A whole robot on one page: each joint by its own calibration, whatever became of the others.

#include "report/robot_page.h"

#include <gtest/gtest.h>

#include "report/document_checks.h"
#include "report/run_python.h"
#include "report/sample_calibration.h"

namespace tribolog::test::robot_page_test {
namespace {

struct Robot {
  calibration::Calibration good = complete_calibration();
  calibration::Calibration poor = sweep_only();
  std::vector<report::RobotJoint> joints{{"J1", &good, "", {}, "J1.html"},
                                         {"J2", &poor, "", {}, "J 2.html"},
                                         {"J3", nullptr, "j3.csv: cannot be opened", {}, ""}};

  [[nodiscard]] std::string page() const { return report::robot_page(joints, sample_provenance()); }
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
  EXPECT_EQ(page.find("<script"), std::string::npos);
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
