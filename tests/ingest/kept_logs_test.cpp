#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/dataset/log_reader.h"

namespace tribolog::kept_logs_test {
namespace {

using test::TemporaryDirectory;

std::string log_of(int torque) {
  std::string csv = "t,q,tau,i\n";
  for (int k = 0; k < 50; ++k) csv += std::to_string(k) + ",0," + std::to_string(torque) + ",7\n";
  return csv;
}

/// Three recordings of one log, the last of them with another column.
ingest::manifest::ManifestFile manifest() {
  std::string text = R"(schema = "tribolog-dataset-1"
[robot]
name = "R"
[joint]
name = "J"
gear_ratio = 100
[effort]
kind = "motor_torque"
side = "motor"
[columns]
time = {name = "t", unit = "s"}
angle = {name = "q", unit = "rad"}
effort = {name = "tau", unit = "Nm"}
)";
  for (const char* const more :
       {"to_s = 20", "from_s = 20", "columns = {effort = {name = \"i\", unit = \"Nm\"}}"}) {
    text += "[[recording]]\nrole = \"oscillation\"\nfile = \"a.csv\"\n" + std::string(more) + "\n";
  }
  return ingest::manifest::parse_manifest(text, "m.toml");
}

TEST(KeptLogs, ALogOfSeveralRecordingsIsReadOnce) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log_of(1));
  const ingest::manifest::ManifestFile file = manifest();
  ingest::dataset::KeptLogs logs(file, directory.path(""));
  std::vector<Statement> notes;
  const auto first = logs.read(file.recordings[0], {}, notes);
  (void)directory.file("a.csv", log_of(2));
  const auto second = logs.read(file.recordings[1], {}, notes);
  EXPECT_EQ(first, second) << "as it was when its fingerprint was taken";
  EXPECT_EQ(second->table.columns[2].values[0], 1);
  const auto third = logs.read(file.recordings[2], {}, notes);
  EXPECT_EQ(third->table.columns[2].values[0], 7) << "other columns";
}

TEST(KeptLogs, NothingIsKeptBeyondTheLastRecording) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log_of(1));
  ingest::manifest::ManifestFile file = manifest();
  file.recordings.pop_back();
  ingest::dataset::KeptLogs logs(file, directory.path(""));
  std::vector<Statement> notes;
  const std::weak_ptr<const ingest::dataset::ReadLog> first =
      logs.read(file.recordings[0], {}, notes);
  EXPECT_FALSE(first.expired());
  (void)logs.read(file.recordings[1], {}, notes);
  EXPECT_TRUE(first.expired());
}

/// Two recordings in one log, which "episode" tells apart; another joint moves beside.
std::string log_of_episodes(int torque) {
  std::string csv = "t,q,tau,other,episode\n";
  for (int k = 0; k < 60; ++k) {
    csv += std::to_string(k % 30) + ",0," + std::to_string(torque + k / 30) + "," +
           std::to_string(k) + ",0" + std::to_string(k / 30) + "\n";
  }
  return csv;
}

TEST(KeptLogs, RecordingsOfOneLogTakeTheirRows) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log_of_episodes(1));
  ingest::manifest::ManifestFile file = manifest();
  file.recordings.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    ingest::manifest::RecordingEntry& recording = file.recordings[k];
    recording.columns.rows = {"episode", "0" + std::to_string(k), {}};
  }
  ingest::dataset::KeptLogs logs(file, directory.path(""));
  std::vector<Statement> notes;
  const auto first = logs.read(file.recordings[0], {}, notes, {"other"});
  (void)directory.file("a.csv", log_of_episodes(7));
  const auto second = logs.read(file.recordings[1], {}, notes, {"other"});
  EXPECT_EQ(first->table.rows, 30U);
  EXPECT_EQ(first->table.columns.size(), 3U);
  EXPECT_EQ(first->table.columns[2].values[0], 1);
  EXPECT_EQ(second->table.columns[2].values[0], 2) << "read once, with the first";
  EXPECT_EQ(second->table.line_of(0), 32);
  EXPECT_EQ(second->table.other_rows, 0U) << "they are no other joint's";
  EXPECT_EQ(second->table.rows_of_others, 30U);
  EXPECT_EQ(second->others.at("other").values.size(), 30U);
  EXPECT_EQ(second->others.at("other").values[0], 30);
}

}  // namespace
}  // namespace tribolog::kept_logs_test
