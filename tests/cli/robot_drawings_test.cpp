// An arm of the user's own, described beside the logs, through the real command line.

#include <cstddef>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::robot_drawings_test {
namespace {

std::string planar_arm() {
  return read_text(std::string(TRIBOLOG_SOURCE_DIR) + "/tests/data/planar_arm.toml");
}

std::string described_manifest(const std::string& joint = "shoulder") {
  return replaced(replaced(small_manifest(), "name = \"test robot\"\n",
                           "name = \"test robot\"\ndescription = \"arm.toml\"\n"),
                  "name = \"J1\"", std::string("name = \"") + joint + "\"");
}

TEST(RobotDrawings, AreInTheReportOfAnOwnArm) {
  const SmallDataset dataset(described_manifest());
  dataset.scratch().write("arm.toml", planar_arm());
  const ProgramRun run = dataset.run("report", "report.html");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err.find("note:"), std::string::npos) << run.err;
  const std::string report = read_text(dataset.file("report.html"));
  for (const char* part : {"id=\"fig-10-phenomenological-model\"", "id=\"fig-12-range-of-motion\"",
                           "joint shoulder moves from"}) {
    EXPECT_NE(report.find(part), std::string::npos) << part;
  }
  const std::string numbers = read_text(dataset.file("report.calibration.json"));
  EXPECT_NE(numbers.find("\"role\": \"robot\""), std::string::npos);
}

TEST(RobotDrawings, AreNamedFilesOfTheFiguresCommand) {
  const SmallDataset dataset(described_manifest());
  dataset.scratch().write("arm.toml", planar_arm());
  EXPECT_EQ(dataset.run("figures", "figures").status, 0);
  for (const char* name :
       {"fig-09-robot", "fig-10-phenomenological-model", "fig-12-range-of-motion"}) {
    EXPECT_TRUE(std::filesystem::exists(dataset.file(std::string("figures/") + name + ".png")))
        << name;
  }
}

TEST(RobotDrawings, AsVectorsAreLinesOverAPicture) {
  const SmallDataset dataset(described_manifest());
  dataset.scratch().write("arm.toml", planar_arm());
  ASSERT_EQ(dataset.run("figures --truth-runs 0 --format svg,pdf", "figures").status, 0);
  const std::string svg = read_text(dataset.file("figures/fig-10-phenomenological-model.svg"));
  const std::size_t image = svg.find("<image ");
  ASSERT_NE(image, std::string::npos);
  EXPECT_NE(svg.find("<path ", image), std::string::npos);
  EXPECT_NE(svg.find("<text ", image), std::string::npos);
  const std::string pdf = read_text(dataset.file("figures/fig-10-phenomenological-model.pdf"));
  EXPECT_NE(pdf.find("/Subtype /Image"), std::string::npos);
}

TEST(RobotDrawings, WithoutAGraphicsStackAreNamedAndChartsAreWritten) {
  const SmallDataset dataset(described_manifest());
  dataset.scratch().write("arm.toml", planar_arm());
  const ProgramRun run = run_shell("TRIBOLOG_TEST_CRASH_FIGURE=warm-up " + program +
                                   "figures --truth-runs 0 '" + dataset.file("dataset.toml") +
                                   "' -o '" + dataset.file("figures") + "' --format svg");
  EXPECT_EQ(run.status, 5) << run.err;
  EXPECT_NE(run.err.find("fig-09-robot: the drawing process was lost"), std::string::npos)
      << run.err;
  EXPECT_TRUE(std::filesystem::exists(dataset.file("figures/fig-13-rough-torque.svg")));
  EXPECT_FALSE(std::filesystem::exists(dataset.file("figures/fig-09-robot.svg")));
}

TEST(RobotDrawings, OfAnotherJointAreNoted) {
  const SmallDataset dataset(described_manifest("J1"));
  dataset.scratch().write("arm.toml", planar_arm());
  const ProgramRun run = dataset.run("report --no-figures", "report.html");
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string note =
      "arm.toml describes the test of joint 'shoulder', the manifest is for joint 'J1'";
  EXPECT_NE(run.err.find("note: " + note), std::string::npos) << run.err;
  EXPECT_NE(read_text(dataset.file("report.html")).find("describes the test of joint"),
            std::string::npos);
}

TEST(RobotDrawings, BadDescriptionIsRefusedInOneLine) {
  const SmallDataset dataset(described_manifest());
  EXPECT_EQ(dataset.run("report", "report.html").status, 3) << "no such file";
  dataset.scratch().write("arm.toml",
                          replaced(planar_arm(), "axis = [1, 0, 0]", "axis = [0, 0, 1]"));
  const ProgramRun run = dataset.run("--quiet report", "report.html");
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_NE(run.err.find("arm.toml:33:9: key 'under_test.joint': the axis of joint 'shoulder' is "
                         "tilted by 90° in this pose; it must be horizontal"),
            std::string::npos)
      << run.err;
  EXPECT_FALSE(std::filesystem::exists(dataset.file("report.html")));
}

TEST(RobotDrawings, TheDescriptionIsNeverOverwritten) {
  const SmallDataset dataset(described_manifest());
  dataset.scratch().write("arm.toml", planar_arm());
  EXPECT_EQ(dataset.run("report", "arm.toml").status, 2);
  EXPECT_EQ(dataset.run("identify", "arm.toml").status, 2);
  EXPECT_EQ(read_text(dataset.file("arm.toml")), planar_arm());
}

TEST(RobotDrawings, HostileNamesStayText) {
  const SmallDataset dataset(described_manifest());
  dataset.scratch().write("arm.toml",
                          replaced(planar_arm(), "name = \"Planar arm\"",
                                   R"(name = "</h3><script>alert(1)</script>\u001b[31m_{<b>}")"));
  const ProgramRun run = dataset.run("report", "report.html");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err.find('\x1b'), std::string::npos) << run.err;
  EXPECT_EQ(read_text(dataset.file("report.html")).find("<script>alert"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::test::robot_drawings_test
