// What is written: whole or not at all, the same bytes for the same input.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/small_dataset.h"

namespace tribolog::test::outputs_test {
namespace {

std::string at_epoch(const std::string& command) {
  return "SOURCE_DATE_EPOCH=1700000000 " + command;
}

TEST(Outputs, SameInputSameBytes) {
  const SmallDataset dataset;
  const auto make = [&](const std::string& environment) {
    const ProgramRun run =
        run_shell("cd '" + dataset.scratch().path() + "' && " + environment + " " +
                  at_epoch(program + "report dataset.toml -o report.html"));
    EXPECT_EQ(run.status, 0) << run.err;
    return read_text(dataset.file("report.html")) +
           read_text(dataset.file("report.calibration.json"));
  };
  const std::string first = make("");
  EXPECT_GT(first.size(), 50'000U);
  EXPECT_EQ(first, make(""));
  EXPECT_EQ(first, make("LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo"));
}

TEST(Outputs, ADirectoryInTheWayIsStatus4) {
  const SmallDataset dataset;
  std::filesystem::create_directory(dataset.file("report.html"));
  const ProgramRun run = dataset.run("report", "report.html");
  EXPECT_EQ(run.status, 4) << run.err;
}

TEST(Outputs, AMissingDirectoryIsStatus4BeforeAnyWork) {
  const SmallDataset dataset;
  const ProgramRun run = dataset.run("report", "nowhere/report.html");
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_EQ(run.err.find("hysteresis"), std::string::npos) << run.err;
}

TEST(Outputs, AnInputIsNeverOverwritten) {
  const SmallDataset dataset;
  EXPECT_EQ(dataset.run("identify", "dataset.toml").status, 2);
  EXPECT_EQ(dataset.run("identify", "log.csv").status, 2);
  EXPECT_EQ(read_text(dataset.file("log.csv")), small_log());
}

TEST(Outputs, AFullDiskLeavesTheOldReport) {
  if (geteuid() != 0) GTEST_SKIP() << "mounting a small file system needs root";
  const SmallDataset dataset;
  const std::string disk = dataset.file("disk");
  std::filesystem::create_directory(disk);
  if (run_shell("mount -t tmpfs -o size=64k none '" + disk + "'").status != 0) {
    GTEST_SKIP() << "no file system can be mounted here";
  }
  dataset.scratch().write("disk/report.html", "last year's report");
  const ProgramRun run = dataset.run("report", "disk/report.html");
  const std::string kept = read_text(disk + "/report.html");
  const ProgramRun rest = run_shell("ls -A '" + disk + "'");
  EXPECT_EQ(run_shell("umount '" + disk + "'").status, 0);
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_EQ(kept, "last year's report");
  EXPECT_EQ(rest.out.find(".tmp-"), std::string::npos) << rest.out;
}

TEST(Outputs, ADiskWithRoomForTheNumbersAloneLeavesBothOldFiles) {
  if (geteuid() != 0) GTEST_SKIP() << "mounting a small file system needs root";
  const SmallDataset dataset;
  const std::string disk = dataset.file("disk");
  std::filesystem::create_directory(disk);
  if (run_shell("mount -t tmpfs -o size=120k none '" + disk + "'").status != 0) {
    GTEST_SKIP() << "no file system can be mounted here";
  }
  dataset.scratch().write("disk/report.html", "last year's report");
  dataset.scratch().write("disk/report.calibration.json", "last year's numbers");
  const ProgramRun numbers = dataset.run("identify --truth-runs 0", "disk/numbers.json");
  std::filesystem::remove(disk + "/numbers.json");
  const ProgramRun run = dataset.run("report --truth-runs 0", "disk/report.html");
  const std::string page = read_text(disk + "/report.html");
  const std::string kept = read_text(disk + "/report.calibration.json");
  EXPECT_EQ(run_shell("umount '" + disk + "'").status, 0);
  EXPECT_EQ(numbers.status, 0) << "the numbers alone fit: " << numbers.err;
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_EQ(page, "last year's report");
  EXPECT_EQ(kept, "last year's numbers");
}

TEST(Outputs, AreDifferentFiles) {
  const SmallDataset dataset;
  dataset.scratch().write("page.html", "old");
  std::filesystem::create_symlink("page.html", dataset.file("link"));
  std::filesystem::create_hard_link(dataset.file("page.html"), dataset.file("hard"));
  const auto report = [&](const std::string& page, const std::string& numbers) {
    return run_shell("cd '" + dataset.scratch().path() + "' && " + program +
                     "report dataset.toml -o " + page + " --calibration " + numbers);
  };
  for (const char* name : {"page.html", "./page.html", "link", "hard"}) {
    EXPECT_EQ(report("page.html", name).status, 2) << name;
  }
  EXPECT_EQ(report("new.html", "new.html").status, 2);
  EXPECT_EQ(report("new.html", "./new.html").status, 2);
  EXPECT_EQ(read_text(dataset.file("page.html")), "old");
  EXPECT_FALSE(std::filesystem::exists(dataset.file("new.html")));
}

TEST(Outputs, AReadOnlyDiskLeavesTheOldReport) {
  if (geteuid() != 0) GTEST_SKIP() << "mounting a small file system needs root";
  const SmallDataset dataset;
  const std::string disk = dataset.file("disk");
  std::filesystem::create_directory(disk);
  if (run_shell("mount -t tmpfs -o size=1m none '" + disk + "'").status != 0) {
    GTEST_SKIP() << "no file system can be mounted here";
  }
  dataset.scratch().write("disk/report.html", "last year's report");
  EXPECT_EQ(run_shell("mount -o remount,ro '" + disk + "'").status, 0);
  const ProgramRun run = dataset.run("report", "disk/report.html");
  const std::string kept = read_text(disk + "/report.html");
  EXPECT_EQ(run_shell("umount '" + disk + "'").status, 0);
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_EQ(kept, "last year's report");
}

TEST(Outputs, WithoutAGraphicsStackTheNumbersAreKept) {
  // A libGL ahead of OSMesa would draw white pictures; it must be noticed.
  const SmallDataset dataset;
  const std::string gl =
      run_shell("ldconfig -p | sed -n 's/.*libGL\\.so\\.1 .* => //p' | head -1").out;
  if (gl.empty()) GTEST_SKIP() << "no libGL to put in the way";
  const ProgramRun version = run_shell(program + "--version");
  if (version.out.find("OSMesa") == std::string::npos)
    GTEST_SKIP() << "drawing is not through OSMesa";
  const ProgramRun run =
      run_shell("ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=" + gl.substr(0, gl.find('\n')) +
                " " + program + "report '" + dataset.file("dataset.toml") + "' -o '" +
                dataset.file("report.html") + "'");
  EXPECT_EQ(run.status, 5) << run.err;
  EXPECT_TRUE(std::filesystem::exists(dataset.file("report.calibration.json")));
  const std::string report = read_text(dataset.file("report.html"));
  EXPECT_NE(report.find("missing"), std::string::npos);
}

TEST(Outputs, WithoutAFontTheNumbersAreKept) {
  const SmallDataset dataset;
  const ProgramRun run =
      run_shell("TRIBOLOG_FONT_DIR=/nowhere " + program + "report '" +
                dataset.file("dataset.toml") + "' -o '" + dataset.file("report.html") + "'");
  EXPECT_EQ(run.status, 5) << run.err;
  EXPECT_NE(run.err.find("fonts-dejavu-core"), std::string::npos) << run.err;
  EXPECT_TRUE(std::filesystem::exists(dataset.file("report.calibration.json")));
}

TEST(Outputs, NoFiguresIsAsked) {
  const SmallDataset dataset;
  const ProgramRun run = dataset.run("report --no-figures", "report.html");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(read_text(dataset.file("report.html")).find("data:image/png"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::test::outputs_test
