// rosbag2 logs in SQLite, written by SQLite itself.

#include <random>
#include <string_view>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/bags/bag_readers.h"
#include "support/cdr_writer.h"
#include "wording/words.h"

namespace tribolog::rosbag_reader_test {
namespace {

using test::CdrWriter;
using test::JointStateMessage;
using Values = std::vector<double>;
using Names = std::vector<std::string>;

/// A bag as ROS 2 Humble lays it out.
class BagWriter {
 public:
  explicit BagWriter(const std::string& path) {
    if (sqlite3_open(path.c_str(), &database_) != SQLITE_OK) throw std::runtime_error("sqlite");
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
        "timestamp INTEGER NOT NULL, data BLOB NOT NULL)");
    run("CREATE INDEX timestamp_idx ON messages (timestamp ASC)");
  }
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;
  ~BagWriter() { sqlite3_close(database_); }

  void run(const std::string& sql) {
    if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
      throw std::runtime_error(sqlite3_errmsg(database_));
    }
  }
  void add_topic(int id, const std::string& name, const std::string& type,
                 const std::string& format = "cdr") {
    run("INSERT INTO topics VALUES(" + std::to_string(id) + ", '" + name + "', '" + type + "', '" +
        format + "', '')");
  }
  void add_message(int topic, std::int64_t log_time_ns, const std::string& data) {
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(database_, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)",
                       -1, &insert, nullptr);
    sqlite3_bind_int(insert, 1, topic);
    sqlite3_bind_int64(insert, 2, log_time_ns);
    sqlite3_bind_blob(insert, 3, data.data(), static_cast<int>(data.size()), SQLITE_TRANSIENT);
    sqlite3_step(insert);
    sqlite3_finalize(insert);
  }

 private:
  sqlite3* database_{};
};

const ingest::log::LogColumn& column(const ingest::log::LogTable& table, std::string_view name) {
  for (const ingest::log::LogColumn& candidate : table.columns) {
    if (candidate.header.name == name) return candidate;
  }
  throw std::runtime_error("no column " + std::string(name));
}

std::string refusal_of(const std::string& path) {
  return test::refusal_of<InputError>([&] { return ingest::bags::read_rosbag_db3(path); });
}

/// Its own directory, one file name with signs that a URI would read otherwise.
class RosbagReader : public testing::Test {
 protected:
  test::TemporaryDirectory directory_;
  std::string path_ = directory_.path("a%20b?c#d&mode=rw.db3");

  void write_joints(std::size_t count) const {
    BagWriter bag(path_);
    bag.run("BEGIN");
    bag.add_topic(1, "/joint_states", "sensor_msgs/msg/JointState");
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = static_cast<double>(i);
      const auto stamp_ns = 1'700'000'000'000'000'000 + static_cast<std::int64_t>(i) * 2'000'001;
      const test::JointStateMessage message =
          i % 2 == 0 ? test::JointStateMessage{stamp_ns, {"a", "b"}, {value, 0}, {}, {1, 2}}
                     : test::JointStateMessage{stamp_ns, {"b", "a"}, {0, value}, {}, {2, 1}};
      bag.add_message(1, stamp_ns + 3, message.cdr());
    }
    bag.run("COMMIT");
  }
};

TEST_F(RosbagReader, ReadsJointStatesByTheTypesName) {
  write_joints(50);
  const std::vector<ingest::log::LogTable> tables = ingest::bags::read_rosbag_db3(path_);
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].group, "/joint_states");
  EXPECT_EQ(tables[0].header, (Names{"time [s]", "log_time [s]", "a.position", "b.position",
                                     "a.effort", "b.effort"}));
  EXPECT_EQ(wording::words(tables[0].notes), Names{});
  ASSERT_EQ(tables[0].rows, 50U);
  for (std::size_t i = 0; i < 50; ++i) {
    const auto value = static_cast<double>(i);
    EXPECT_EQ(column(tables[0], "a.position").values[i], value);
    EXPECT_EQ(column(tables[0], "a.effort").values[i], 1);
    EXPECT_EQ(column(tables[0], "time").values[i], value * 2'000'001 / 1e9);
    EXPECT_EQ(column(tables[0], "log_time").values[i], value * 2'000'001 / 1e9);
  }
  EXPECT_EQ(std::filesystem::directory_iterator(directory_.path())->path(), path_);
  EXPECT_EQ(directory_.entries(), 1U);  // nothing was written beside it
}

TEST_F(RosbagReader, TakesDefinitionsThatTheLogHolds) {
  {
    BagWriter bag(path_);
    bag.run(
        "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, "
        "encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL, "
        "type_description_hash TEXT NOT NULL)");
    bag.run(
        "INSERT INTO message_definitions VALUES(1, 'arm_msgs/msg/Arm', 'ros2msg', "
        "'int16 current' || char(10) || 'float64[2] tau', '')");
    bag.add_topic(1, "/arm", "arm_msgs/msg/Arm");
    bag.add_topic(2, "/unknown", "arm_msgs/msg/Hand");
    bag.add_topic(3, "/proto", "x", "protobuf");
    bag.add_message(
        1, 10, test::CdrWriter(std::endian::big).add(std::int16_t{-3}).add(1.0).add(2.0).message());
    bag.add_message(2, 11, "x");
    bag.add_message(3, 11, "x");
    bag.add_message(4, 11, "x");
    bag.add_message(1, 9, test::CdrWriter().add(std::int16_t{4}).add(3.0).add(4.0).message());
  }
  const std::vector<ingest::log::LogTable> tables = ingest::bags::read_rosbag_db3(path_);
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].header, (Names{"log_time [s]", "current", "tau[0]", "tau[1]"}));
  EXPECT_EQ(column(tables[0], "current").values, (Values{-3, 4}));
  EXPECT_EQ(column(tables[0], "tau[1]").values, (Values{2, 4}));
  EXPECT_EQ(column(tables[0], "log_time").values, (Values{0, -1e-9}));
  EXPECT_EQ(wording::words(tables[0].notes),
            (Names{"/arm: rows are in the file's order; log_time goes back at 1 of 2",
                   "/unknown is not read: the log does not say what arm_msgs/msg/Hand consists of",
                   "/proto is not read: the log does not say what x consists of",
                   "messages left out because they belong to no topic: 1"}));
}

TEST_F(RosbagReader, StatesMessageAndRowOfADisagreement) {
  {
    BagWriter bag(path_);
    bag.add_topic(1, "/joint_states", "sensor_msgs/msg/JointState");
    bag.add_message(1, 0, test::JointStateMessage{0, {"a"}, {1}, {}, {}}.cdr());
    bag.add_message(1, 1, test::JointStateMessage{1, {"a"}, {1, 2}, {}, {}}.cdr());
  }
  EXPECT_EQ(refusal_of(path_), path_ +
                                   ": message 2 of /joint_states has 2 elements in position, where "
                                   "1 have a name (row 2 of messages)");
}

TEST_F(RosbagReader, NotesAWriteAheadLogBesideIt) {
  write_joints(3);
  std::ofstream(path_ + "-wal") << "not joined";
  EXPECT_EQ(wording::words(ingest::bags::read_rosbag_db3(path_).at(0).notes),
            Names{"the recording was not closed: what is in " + path_ +
                  "-wal (10 bytes) is not read; sqlite3 can merge it into the log"});
}

TEST_F(RosbagReader, RefusesWhatIsNoBag) {
  EXPECT_EQ(refusal_of(directory_.file("empty.db3", "")),
            directory_.path("empty.db3") + ": file is empty");
  const std::string packed = directory_.file("a.db3.zstd", "\x28\xb5\x2f\xfd....");
  EXPECT_EQ(refusal_of(packed), packed +
                                    ": is packed with zstd (byte 0), expected an SQLite "
                                    "database; hint: unpack it: zstd -d " +
                                    packed);
  const std::string text = directory_.file("t.db3", "t,q\n0,1\n");
  EXPECT_EQ(refusal_of(text), text +
                                  ": is not an SQLite database (byte 0), found 't,q\\x0a0,1"
                                  "\\x0a', expected 'SQLite format 3'");
  const std::string other = directory_.path("other.db3");
  sqlite3* database = nullptr;
  sqlite3_open(other.c_str(), &database);
  sqlite3_exec(database, "CREATE TABLE x(y)", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  EXPECT_EQ(refusal_of(other),
            other + ": cannot read as a rosbag2 log, found no such table: topics");
}

TEST_F(RosbagReader, RefusesOrReadsDamagedFilesInOneLine) {
  write_joints(200);
  const std::string bytes = directory_.contents(std::filesystem::path(path_).filename());
  std::mt19937 random(3);
  std::size_t refused = 0;
  constexpr std::size_t trials = 500;
  for (std::size_t trial = 0; trial < 2 * trials; ++trial) {
    std::string changed = bytes;
    if (trial < trials) {
      changed[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
    } else {
      changed.resize(random() % bytes.size());
    }
    const std::string refusal = refusal_of(directory_.file("changed.db3", changed));
    ASSERT_NE(refusal.substr(0, 7), "other: ") << refusal;
    ASSERT_EQ(refusal.find('\n'), std::string::npos) << refusal;
    refused += refusal.empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 0U);
  EXPECT_LT(refused, 2 * trials);
}

}  // namespace
}  // namespace tribolog::rosbag_reader_test
