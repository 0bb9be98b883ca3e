// Messages that name their own fields, as columns; written here as JSON.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/bags/json_messages.h"
#include "ingest/messages/message_tree.h"

namespace tribolog::tree_columns_test {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;
constexpr double gap = std::numeric_limits<double>::quiet_NaN();

struct Table {
  std::vector<std::optional<std::int64_t>> stamps;
  std::vector<ingest::log::LogColumn> columns;
  Names long_arrays;
  bool has_too_many{};
};

Table read(const std::vector<std::string>& texts) {
  const auto reader =
      ingest::messages::reader_of_trees(std::make_unique<ingest::bags::JsonDecoder>());
  ingest::messages::MessageColumns columns;
  Table table;
  for (const std::string& text : texts) table.stamps.push_back(reader->take_row(text, columns));
  table.long_arrays = columns.long_arrays();
  table.has_too_many = columns.has_too_many_columns();
  table.columns = std::move(columns).finish();
  return table;
}

Names names_of(const Table& table) {
  Names names;
  for (const ingest::log::LogColumn& column : table.columns) names.push_back(column.header.name);
  return names;
}

void expect_values(const Table& table, std::size_t column, const Values& wanted) {
  const Values& found = table.columns.at(column).values;
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (std::isnan(wanted[i])) {
      EXPECT_TRUE(std::isnan(found[i])) << "row " << i;
    } else {
      EXPECT_EQ(found[i], wanted[i]) << "row " << i;
    }
  }
}

std::string refusal_of(const std::string& text) {
  return test::refusal_of<ingest::messages::MessageError>([&] { return read({text}); });
}

TEST(TreeColumns, NamesNumbersByTheirPath) {
  const Table table = read({R"({"a": 1, "b": {"c": [true, 2.5, {"d": -3}]}, "t": "x", "n": null})",
                            R"({"late": 4, "a": NaN, "b": {"c": [false]}})"});
  EXPECT_EQ(names_of(table), (Names{"a", "b.c[0]", "b.c[1]", "b.c[2].d", "late"}));
  expect_values(table, 0, {1, gap});
  expect_values(table, 1, {1, 0});
  expect_values(table, 3, {-3, gap});
  expect_values(table, 4, {gap, 4});
  EXPECT_EQ(table.columns[4].gaps, 1U);
}

TEST(TreeColumns, TakesTheNamesOfElementsWhereverTheyStand) {
  const Table table =
      read({R"({"position": [1, 2], "name": ["a", "b"], "gains": [7, 8, 9], "effort": []})",
            R"({"name": ["b", "a"], "position": [3, 4]})"});
  EXPECT_EQ(names_of(table),
            (Names{"a.position", "b.position", "gains[0]", "gains[1]", "gains[2]"}));
  expect_values(table, 0, {1, 4});
  expect_values(table, 1, {2, 3});
}

TEST(TreeColumns, NamesAreUsedOnlyWhereTheyTellElementsApart) {
  EXPECT_EQ(names_of(read({R"({"name": ["a", "a"], "q": [1, 2]})"})), (Names{"q[0]", "q[1]"}));
  EXPECT_EQ(names_of(read({R"({"name": ["a", ""], "q": [1, 2]})"})), (Names{"q[0]", "q[1]"}));
  EXPECT_EQ(names_of(read({R"({"name": ["a", 5], "q": [1, 2]})"})),
            (Names{"name[1]", "q[0]", "q[1]"}));
}

TEST(TreeColumns, ObjectsInAnArrayMayHaveNamesThemselves) {
  const Table table =
      read({R"({"arm": {"joints": [{"name": "a", "q": 1}, {"name": "b", "q": 2}]}})",
            R"({"arm": {"joints": [{"name": "b", "q": 3}, {"name": "a", "q": 4}]}})"});
  EXPECT_EQ(names_of(table), (Names{"arm.a.q", "arm.b.q"}));
  expect_values(table, 0, {1, 4});
  const Table two =
      read({R"({"left": [{"name": "a", "q": 1}], "right": [{"name": "a", "q": 2}]})"});
  EXPECT_EQ(names_of(two), (Names{"a.q", "right.a.q"}));
}

TEST(TreeColumns, NamesInterfacesAsDynamicJointStateDoes) {
  const Table table = read({R"({"joint_names": ["a", "b"], "interface_values": [)"
                            R"({"interface_names": ["position", "torque"], "values": [1, 2]},)"
                            R"({"interface_names": ["torque"], "values": [3]}]})"});
  EXPECT_EQ(names_of(table), (Names{"a.position", "a.torque", "b.torque"}));
}

TEST(TreeColumns, TakesTheTimeOfTheMessage) {
  const auto stamp = [](const std::string& text) { return read({text}).stamps.front(); };
  constexpr std::int64_t wanted = 1'700'000'000'123'456'789;
  const std::string parts = R"({"sec": 1700000000, "nanosec": 123456789})";
  EXPECT_EQ(stamp(R"({"header": {"stamp": )" + parts + R"(, "frame_id": "x"}, "q": 1})"), wanted);
  EXPECT_EQ(stamp(R"({"timestamp": )" + parts + "}"), wanted);
  EXPECT_EQ(stamp(R"({"stamp": {"nsec": 123456789, "secs": 1700000000}})"), wanted);
  EXPECT_EQ(stamp(R"({"timestamp": "2023-11-14T22:13:20.123456789Z"})"), wanted);
  EXPECT_EQ(stamp(R"({"time": "2023-11-14T22:13:20Z"})"), wanted - 123'456'789);
  EXPECT_EQ(stamp(R"({"timestamp": 5, "stamp": {"sec": -2, "nsec": 5}})"), -1'999'999'995);
  EXPECT_EQ(stamp(R"({"timestamp": 1700000000123456789})"), wanted);
  for (const char* const none :
       {"{}", "[1]", R"({"stamp": {"sec": 1}})", R"({"stamp": {"sec": 1.5, "nsec": 0}})",
        R"({"stamp": {"sec": 1e300, "nsec": 0}})", R"({"stamp": {"sec": 1, "nsec": 1e11}})",
        R"({"stamp": "yesterday"})", R"({"timestamp": 1700000000123456})",
        R"({"timestamp": 18446744073709551615})", R"({"timestamp": 1.7e18})",
        R"({"stamp": {"sec": 1, "nsec": 0, "q": 1}})"}) {
    EXPECT_EQ(stamp(none), std::nullopt) << none;
  }
  const Table table = read({R"({"header": {"stamp": )" + parts + R"(, "seq": 4}, "q": 1})"});
  EXPECT_EQ(names_of(table), Names{"q"});
}

TEST(TreeColumns, LeavesOutLongArraysWithoutNames) {
  std::string numbers = "0";
  std::string names = "\"j0\"";
  for (int i = 1; i < 65; ++i) {
    numbers += "," + std::to_string(i);
    names += ",\"j" + std::to_string(i) + "\"";
  }
  const Table table = read({"{\"cloud\": [" + numbers + "], \"tags\": [" + names + "], \"q\": 1}"});
  EXPECT_EQ(table.long_arrays, Names{"cloud"});
  EXPECT_EQ(names_of(table), Names{"q"});
  EXPECT_EQ(read({"{\"q\": [" + numbers + "], \"name\": [" + names + "]}"}).columns.size(), 65U);
}

TEST(TreeColumns, ReadsMessagesThatAreNoObjects) {
  EXPECT_EQ(names_of(read({"2.5"})), Names{"value"});
  EXPECT_EQ(names_of(read({"[1, 2]"})), (Names{"value[0]", "value[1]"}));
}

TEST(TreeColumns, RefusesWhatIsNoMessage) {
  EXPECT_EQ(refusal_of(R"({"a": 1,})"), R"(is no JSON: '1,}' stands at its byte 9)");
  EXPECT_EQ(refusal_of(""), "is no JSON: '' stands at its byte 1");
  EXPECT_EQ(refusal_of(std::string(40, '[')), "is nested more than 32 deep");
  EXPECT_EQ(refusal_of("{\"" + std::string(300, 'k') + "\": 1}"),
            "has a field whose name takes 300 bytes");
  std::string zeros = "[0";
  for (int i = 0; i < (1 << 20); ++i) zeros += ",0";
  EXPECT_EQ(refusal_of(zeros + "]"), "has more than 1048576 values");
}

TEST(TreeColumns, ASmallLogAsksForLittleMemory) {
  std::string wide = "{\"dense\": 1";
  for (int i = 1; i < 4999; ++i) wide += ", \"k" + std::to_string(i) + "\": 1";
  std::vector<std::string> messages(100'000, R"({"dense": 2, "late": 3})");
  messages.front() = messages.back() = wide + "}";
  const Table sparse = read(messages);
  EXPECT_TRUE(sparse.has_too_many);
  EXPECT_LT(sparse.columns.size(), 400U);
  EXPECT_EQ(sparse.columns.front().header.name, "dense");
  EXPECT_EQ(sparse.columns.front().gaps, 0U);
  EXPECT_EQ(sparse.columns.back().gaps, 2U);
  EXPECT_EQ(names_of(sparse).back(), "late");
}

TEST(TreeColumns, KeepsTheNumberOfColumnsBounded) {
  std::vector<std::string> messages;
  for (int i = 0; i < 6000; ++i) messages.push_back("{\"k" + std::to_string(i) + "\": 1}");
  const Table table = read(messages);
  EXPECT_TRUE(table.has_too_many);
  EXPECT_EQ(table.columns.size(), 5000U);
}

}  // namespace
}  // namespace tribolog::tree_columns_test
