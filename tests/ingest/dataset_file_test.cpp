#include "ingest/dataset/dataset_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/encodings.h"
#include "base/error.h"
#include "base/temporary_directory.h"
#include "robot/joint_under_test.h"
#include "wording/words.h"

namespace tribolog::dataset_file_test {
namespace {

using test::TemporaryDirectory;

std::string log(int rows) {
  std::string csv = "t,q,tau\n";
  for (int i = 0; i < rows; ++i) csv += fmt::format("{},{},{}\n", i / 100.0, 0.1, i);
  return csv;
}

std::string manifest(const std::string& recordings) {
  return "schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n[joint]\nname = \"J\"\n"
         "gear_ratio = 100\n[effort]\nkind = \"joint_torque\"\nside = \"joint\"\n[columns]\n"
         "time = {name = \"t\", unit = \"s\"}\nangle = {name = \"q\", unit = \"rad\"}\n"
         "effort = {name = \"tau\", unit = \"Nm\"}\n" +
         recordings;
}

std::string recording(const std::string& role, const std::string& file,
                      const std::string& more = "") {
  return fmt::format("[[recording]]\nrole = \"{}\"\nfile = \"{}\"\n{}", role, file, more);
}

TEST(ReadDataset, FindsLogsBesideTheManifest) {
  const test::TemporaryDirectory directory;
  std::filesystem::create_directory(directory.path("logs"));
  const std::string csv = log(50);
  (void)directory.file("logs/a.csv", csv);
  const std::string text = manifest(recording("oscillation", "logs/a.csv", "note = \"warm\"\n") +
                                    recording("rough_sweep", "logs/a.csv", "from_s = 0.1\n"));
  const joint::Dataset d = ingest::dataset::read_dataset(directory.file("dataset.toml", text));
  ASSERT_EQ(d.recordings.size(), 2U);
  EXPECT_EQ(d.recordings[0].torque_Nm[50 - 1], 0.49) << "joint torque / 100";
  EXPECT_EQ(d.with_role(joint::Role::rough_sweep).size(), 1U);
  EXPECT_EQ(wording::words(d.notes), (std::vector<std::string>{"a.csv: warm"}));
  ASSERT_EQ(d.inputs.size(), 3U);
  EXPECT_EQ(d.inputs[0].name, "dataset.toml");
  EXPECT_EQ(d.inputs[0].role, "manifest");
  EXPECT_EQ(d.inputs[0].sha256, sha256_hex(text));
  EXPECT_EQ(d.inputs[0].bytes, text.size());
  EXPECT_EQ(d.inputs[1].name, "logs/a.csv");
  EXPECT_EQ(d.inputs[1].sha256, sha256_hex(csv));
  EXPECT_EQ(d.inputs[1].rows_read, 50U);
  EXPECT_EQ(d.inputs[1].rows_used, 50U);
  EXPECT_EQ(d.inputs[2].role, "rough_sweep");
  EXPECT_EQ(d.inputs[2].rows_used, 40U);
  EXPECT_EQ(d.inputs[2].skipped.at(0).count, 10U);
}

/// Semicolons, decimal commas, no header, ISO times of local clocks.
TEST(ReadDataset, ReadsALogThatTheManifestHasToExplain) {
  const test::TemporaryDirectory directory;
  std::string csv;
  for (int i = 0; i < 50; ++i) {
    csv += fmt::format("2026-03-01 08:15:{:02d},{:02d};0,1;{},5\n", i / 10, 10 * (i % 10), i);
  }
  (void)directory.file("a.csv", csv);
  const joint::Dataset d = ingest::dataset::read_dataset(directory.file(
      "d.toml",
      "schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n[joint]\nname = \"J\"\n"
      "gear_ratio = 1\n[effort]\nkind = \"joint_torque\"\nside = \"joint\"\n[log]\n"
      "decimal_comma = true\ndelimiter = \"semicolon\"\n[columns]\n"
      "time = {name = \"#1\", unit = \"iso8601\"}\nangle = {name = \"#2\", unit = \"rad\"}\n"
      "effort = {name = \"#3\", unit = \"Nm\"}\n" +
          recording("oscillation", "a.csv", "from_s = 1\n")));
  const joint::Recording& r = d.recordings.at(0);
  ASSERT_EQ(r.size(), 40U);
  EXPECT_NEAR(r.t_s[0], 1, 1e-12);
  EXPECT_NEAR(r.t_s[39] - r.t_s[0], 3.9, 1e-12);
  EXPECT_EQ(r.torque_Nm[0], 10.5);
  ASSERT_GE(d.notes.size(), 4U);
  EXPECT_NE(wording::words(d.notes[3]).find("counts from 1970"), std::string::npos)
      << wording::words(d.notes[3]);
}

TEST(ReadDataset, SaysWhichLogIsNotThere) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("d.toml", manifest(recording("oscillation", "no.csv")));
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::dataset::read_dataset(path); }),
            directory.path("no.csv") + ": cannot open: No such file or directory");
  EXPECT_EQ(test::refusal_of<InputError>(
                [&] { return ingest::dataset::read_dataset(directory.path("no.toml")); }),
            directory.path("no.toml") + ": cannot open: No such file or directory");
}

TEST(ReadDataset, TakesRunningTwiceForTheSame) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log(50));
  const std::string path = directory.file("d.toml", manifest(recording("oscillation", "a.csv")));
  EXPECT_EQ(ingest::dataset::read_dataset(path).recordings[0].torque_Nm,
            ingest::dataset::read_dataset(path).recordings[0].torque_Nm);
}

std::string arm(const std::string& joint) {
  return fmt::format(
      "schema = \"tribolog-robot-1\"\nname = \"A\"\ndimensions = \"exact\"\n"
      "flange_m = [0.5, 0, 0]\n[[joints]]\nname = \"{}\"\naxis = [0, -1, 0]\n"
      "offset_m = [0, 0, 1]\nlowest_deg = -90\nhighest_deg = 90\n[under_test]\njoint = \"{}\"\n",
      joint, joint);
}

std::string manifest_with_arm(const std::string& file) {
  std::string text = manifest(recording("oscillation", "a.csv"));
  const std::string name = "name = \"R\"\n";
  return text.insert(text.find(name) + name.size(), "description = \"" + file + "\"\n");
}

TEST(ReadDataset, ReadsTheRobotsDescriptionAndKeepsItsFingerprint) {
  const test::TemporaryDirectory directory;
  std::filesystem::create_directory(directory.path("arms"));
  (void)directory.file("arms/a.toml", arm("J"));
  (void)directory.file("a.csv", log(50));
  const joint::Dataset d =
      ingest::dataset::read_dataset(directory.file("d.toml", manifest_with_arm("arms/a.toml")));
  ASSERT_NE(d.robot, nullptr);
  EXPECT_EQ(d.robot->under_test.joint().name, "J");
  ASSERT_EQ(d.inputs.size(), 3U);
  EXPECT_EQ(d.inputs[1].name, "arms/a.toml");
  EXPECT_EQ(d.inputs[1].role, "robot");
  EXPECT_EQ(d.inputs[1].bytes, arm("J").size());
  EXPECT_EQ(d.inputs[1].sha256, sha256_hex(arm("J")));
  EXPECT_TRUE(d.notes.empty());
  (void)directory.file("plain.toml", manifest(recording("oscillation", "a.csv")));
  EXPECT_EQ(ingest::dataset::read_dataset(directory.path("plain.toml")).robot, nullptr);
}

TEST(ReadDataset, RefusesADescriptionThatIsMissingOrWrong) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log(50));
  const std::string path = directory.file("d.toml", manifest_with_arm("arm.toml"));
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::dataset::read_dataset(path); }),
            directory.path("arm.toml") + ": cannot open: No such file or directory");
  std::string tilted = arm("J");
  tilted.replace(tilted.find("[0, -1, 0]"), 10, "[0, 0, 1]");
  (void)directory.file("arm.toml", tilted);
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::dataset::read_dataset(path); }),
            directory.path("arm.toml") +
                ":12:9: key 'under_test.joint': the axis of joint 'J' is tilted by 90° in this "
                "pose; it must be horizontal");
}

TEST(ReadDataset, NotesADescriptionOfAnotherJoint) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log(50));
  (void)directory.file("arm.toml", arm("3"));
  const joint::Dataset d =
      ingest::dataset::read_dataset(directory.file("d.toml", manifest_with_arm("arm.toml")));
  EXPECT_EQ(wording::words(d.notes),
            (std::vector<std::string>{"arm.toml describes the test of joint '3', the manifest is "
                                      "for joint 'J': the drawings of the robot show the former"}));
}

TEST(ReadDataset, NotesAnglesBeyondTheDescribedRange) {
  const test::TemporaryDirectory directory;
  std::string far = log(50);
  far.replace(far.find("0.1,7\n"), 3, "1.7");
  (void)directory.file("a.csv", far);
  (void)directory.file("arm.toml", arm("J"));
  const joint::Dataset d =
      ingest::dataset::read_dataset(directory.file("d.toml", manifest_with_arm("arm.toml")));
  EXPECT_EQ(wording::words(d.notes),
            (std::vector<std::string>{
                "the logs reach 97.4°, outside the range of motion of joint 'J' in "
                "arm.toml, −90° to 90°: do both count the angle from the same zero and "
                "with the same sign?"}));
}

}  // namespace
}  // namespace tribolog::dataset_file_test
