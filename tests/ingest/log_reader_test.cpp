// Logs of other formats as recordings, by the same manifest.

#include "ingest/dataset/log_reader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/encodings.h"
#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"
#include "support/cdr_writer.h"
#include "support/mcap_writer.h"

namespace tribolog::log_reader_test {
namespace {

using test::TemporaryDirectory;

ingest::log::LogTable table_of(const std::string& group, const std::vector<std::string>& names) {
  ingest::log::LogTable table;
  table.file = "run.mcap";
  table.group = group;
  table.rows = 2;
  for (const std::string& name : names) {
    ingest::log::LogColumn column;
    column.header = {name, name, ""};
    column.values = {static_cast<double>(table.columns.size()), 0};
    table.columns.push_back(std::move(column));
    table.header.push_back(name);
  }
  return table;
}

TEST(TakeColumns, CountsAClockFromItsFirstReadingAndNothingElse) {
  ingest::log::LogTable log = table_of("", {"stamp", "counts"});
  log.columns[0].values = {1.7e9 + 0.25, 1.7e9 + 1.5};
  log.columns[1].values = {1.7e9 + 0.25, 1.7e9 + 1.5};
  const ingest::log::LogTable table = ingest::dataset::take_columns(
      {log}, {{"stamp", "", ingest::log::ColumnReading::clock}, {"counts"}});
  EXPECT_EQ(table.columns[0].values, (std::vector<double>{0.25, 1.5}));
  EXPECT_EQ(table.columns[0].origin, 1.7e9);
  EXPECT_EQ(table.columns[1].values, log.columns[1].values);
}

TEST(TakeColumns, RefusesADamagedTableOnlyWhereItIsAskedFor) {
  ingest::log::LogTable damaged = table_of("/b", {"time", "p"});
  damaged.refusal = "message 3 of /b ends too early";
  EXPECT_EQ(
      ingest::dataset::take_columns({table_of("/a", {"time", "q"}), damaged}, {{"time"}, {"q"}})
          .group,
      "/a");
  EXPECT_EQ(test::refusal_of<InputError>([&] {
              return ingest::dataset::take_columns({table_of("/a", {"time", "q"}), damaged},
                                                   {{"time"}, {"p"}});
            }),
            "run.mcap: message 3 of /b ends too early");
}

TEST(TakeColumns, FindsTheTableThatHasThemAllAndKeepsTheirOrder) {
  const ingest::log::LogTable table = ingest::dataset::take_columns(
      {table_of("/clock", {"time"}), table_of("/joint_states", {"time", "q.position", "q.effort"})},
      {{"q.effort"}, {"time"}});
  EXPECT_EQ(table.group, "/joint_states");
  ASSERT_EQ(table.columns.size(), 2U);
  EXPECT_EQ(table.columns[0].header.full, "q.effort");
  EXPECT_EQ(table.columns[1].values[0], 0);
}

TEST(TakeColumns, SaysWhatIsMissingAndWhereTwoFit) {
  const auto refused = [](const std::vector<ingest::log::LogTable>& tables,
                          const std::vector<ingest::log::WantedColumn>& columns) {
    return test::refusal_of<InputError>(
        [&] { return ingest::dataset::take_columns(tables, columns); });
  };
  EXPECT_EQ(refused({table_of("/a", {"time"}), table_of("/b", {"time", "elbow.position"})},
                    {{"time"}, {"elbow.positon"}}),
            "run.mcap: column 'elbow.positon' is missing in '/b', found 'time', 'elbow.position'; "
            "hint: did you mean 'elbow.position'?");
  const std::vector<ingest::log::LogTable> twins = {table_of("/left", {"time", "q"}),
                                                    table_of("/right", {"time", "q"})};
  EXPECT_EQ(refused(twins, {{"time"}, {"q"}}),
            "run.mcap: the columns stand in several tables, found '/left', '/right'; hint: put the "
            "table in front of a column's name: '/left/time'");
  EXPECT_EQ(ingest::dataset::take_columns(twins, {{"time"}, {"/right/q"}}).group, "/right");
}

std::string manifest(const std::string& file, const std::string& time, const std::string& angle,
                     const std::string& effort) {
  return fmt::format(
      "schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n[joint]\nname = \"J\"\n"
      "gear_ratio = 100\n[effort]\nkind = \"joint_torque\"\nside = \"joint\"\n[columns]\n"
      "time = {{name = \"{}\", unit = \"s\"}}\nangle = {{name = \"{}\", unit = \"rad\"}}\n"
      "effort = {{name = \"{}\", unit = \"Nm\"}}\n[[recording]]\nrole = \"oscillation\"\n"
      "file = \"{}\"\n",
      time, angle, effort, file);
}

TEST(ReadDataset, TakesAJsonLogAsItTakesText) {
  const test::TemporaryDirectory directory;
  std::string t, q, tau;
  for (int i = 0; i < 50; ++i) {
    const char* const comma = i == 0 ? "" : ",";
    t += fmt::format("{}{}", comma, i / 100.0);
    q += fmt::format("{}0.1", comma);
    tau += fmt::format("{}{}", comma, i);
  }
  const std::string json = fmt::format(R"({{"t": [{}], "q": [{}], "tau": [{}]}})", t, q, tau);
  (void)directory.file("a.json", json);
  const joint::Dataset d =
      ingest::dataset::read_dataset(directory.file("d.toml", manifest("a.json", "t", "q", "tau")));
  ASSERT_EQ(d.recordings.size(), 1U);
  EXPECT_EQ(d.recordings[0].size(), 50U);
  EXPECT_EQ(d.recordings[0].torque_Nm[49], 0.49);
  EXPECT_EQ(d.inputs[1].sha256, sha256_hex(json));
  EXPECT_EQ(d.inputs[1].bytes, json.size());
}

TEST(ReadDataset, TakesAnMcapLogByTheJointsName) {
  const test::TemporaryDirectory directory;
  test::McapWriter writer({10, "zstd"});
  writer.add_schema(1, "sensor_msgs/msg/JointState", "ros2msg", test::joint_state_definition);
  writer.add_channel(1, 1, "/joint_states");
  for (int i = 0; i < 50; ++i) {
    const std::int64_t stamp_ns = 1'700'000'000'000'000'000 + 10'000'000LL * i;
    const test::JointStateMessage message{
        stamp_ns, {"wrist", "elbow"}, {9.0, 0.1}, {}, {9.0, static_cast<double>(i)}};
    writer.add_message(1, static_cast<std::uint64_t>(stamp_ns), message.cdr());
  }
  (void)directory.file("a.mcap", writer.finish());
  const joint::Dataset d = ingest::dataset::read_dataset(
      directory.file("d.toml", manifest("a.mcap", "time", "elbow.position", "elbow.effort")));
  const joint::Recording& r = d.recordings.at(0);
  ASSERT_EQ(r.size(), 50U);
  EXPECT_NEAR(r.t_s[49], 0.49, 1e-12);
  EXPECT_EQ(r.q_rad[7], 0.1);
  EXPECT_EQ(r.torque_Nm[49], 0.49);
}

}  // namespace
}  // namespace tribolog::log_reader_test
