// Data sets of LeRobot: how their columns are named.

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/parquet/parquet_reader.h"
#include "support/parquet_writer.h"
#include "wording/words.h"

namespace tribolog::lerobot_set_test {
namespace {

/// Two rows of state and action of two joints.
std::string rows_of(bool with_timestamps = true, const std::string& more = "") {
  test::WrittenParquet file;
  test::add_lists("observation.state", {{1, 2}, {3, 4}}, file);
  test::add_lists("action", {{5, 6}, {7, 8}}, file);
  if (!more.empty()) test::add_lists(more, {{9, 10}, {11, 12}}, file);
  if (with_timestamps) test::add_doubles("timestamp", {0, 0.1}, file);
  test::add_integers("frame_index", {0, 1}, file);
  test::add_integers("episode_index", {0, 0}, file);
  return test::write_parquet(file);
}

/// A set with this description, in folders as version 2 and 3 have them.
class Set {
 public:
  explicit Set(const std::string& info, const std::string& rows = rows_of()) {
    std::filesystem::create_directories(directory_.path("meta"));
    std::filesystem::create_directories(directory_.path("data/chunk-000"));
    (void)directory_.file("meta/info.json", info);
    (void)directory_.file("data/chunk-000/file-000.parquet", rows);
  }
  [[nodiscard]] ingest::log::LogTable table() const {
    return ingest::parquet::read_parquet(directory_.path("data/chunk-000/file-000.parquet")).at(0);
  }

 private:
  test::TemporaryDirectory directory_;
};

std::string info_with(const std::string& names, const std::string& feature = "") {
  std::string features = R"("observation.state": {"dtype": "float32", "names": )" + names +
                         R"(}, "action": {"dtype": "float32", "names": )" + names + "}";
  if (!feature.empty()) features += ", \"" + feature + "\": {\"names\": " + names + "}";
  return R"({"codebase_version": "v3.0", "fps": 10, "features": {)" + features + "}}";
}

std::vector<std::string> first_names(const ingest::log::LogTable& table, std::size_t count) {
  return {table.header.begin(), table.header.begin() + static_cast<std::ptrdiff_t>(count)};
}

TEST(LeRobotSet, ElementsAreNamedAsTheSetSays) {
  const std::vector<std::string> expected{"pan.position", "lift.position", "pan.position_command",
                                          "lift.position_command"};
  for (const char* names :
       {R"(["pan", "lift"])", R"({"motors": ["pan", "lift"]})", R"({"lift": 1, "pan": 0})"}) {
    EXPECT_EQ(first_names(Set(info_with(names)).table(), 4), expected) << names;
  }
}

TEST(LeRobotSet, QuantitiesInNamesStay) {
  EXPECT_EQ(first_names(Set(info_with(R"(["pan.pos", "pan.torque"])")).table(), 4),
            (std::vector<std::string>{"pan.pos", "pan.torque", "pan.position_command",
                                      "pan.effort_command"}));
  for (const std::string quantity : {"velocity", "effort", "torque", "current"}) {
    const std::string feature = "observation." + quantity;
    const ingest::log::LogTable table =
        Set(info_with(R"(["pan.pos", "lift"])", feature), rows_of(true, feature)).table();
    EXPECT_EQ(table.header[4], "pan." + quantity);
    EXPECT_EQ(table.header[5], "lift." + quantity);
  }
}

TEST(LeRobotSet, WithoutNamesElementsAreCounted) {
  const std::vector<std::string> expected{"observation.state_0", "observation.state_1", "action_0",
                                          "action_1"};
  for (const char* names : {"null", R"(["only one"])", R"([1, 2])", R"({"a": 7, "b": 8})"}) {
    EXPECT_EQ(first_names(Set(info_with(names)).table(), 4), expected) << names;
  }
  EXPECT_EQ(first_names(ingest::parquet::parse_parquet(rows_of(), "a.parquet").at(0), 4), expected);
}

TEST(LeRobotSet, FramesAreTheClockWhereThereAreNoTimestamps) {
  const ingest::log::LogTable table = Set(info_with("null"), rows_of(false)).table();
  EXPECT_EQ(table.header[0], "timestamp");
  EXPECT_EQ(table.columns[0].values, (std::vector<double>{0, 0.1}));
  EXPECT_EQ(wording::words(table.notes).at(0),
            "the data set has no timestamps: its frames, 10 in a second, are the clock");
}

TEST(LeRobotSet, ThatHasNoTorqueSaysSo) {
  const std::string note =
      "no torque or current in observation.*: the motion can be looked at, and no friction be "
      "identified";
  EXPECT_EQ(wording::words(Set(info_with("null")).table().notes), std::vector<std::string>{note});
  const std::string effort = "observation.effort";
  EXPECT_EQ(wording::words(Set(info_with("null"), rows_of(true, effort)).table().notes),
            std::vector<std::string>{});
}

TEST(LeRobotSet, ADescriptionThatIsNoneIsRefused) {
  for (const std::string info : {"{", "[]", R"({"fps": 30})"}) {
    EXPECT_THROW(Set(info).table(), InputError) << info;
  }
  EXPECT_NO_THROW(Set(R"({"features": {"action": 3, "observation.state": {}}})").table());
}

}  // namespace
}  // namespace tribolog::lerobot_set_test
