#include <bit>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/json_text.h"
#include "support/damaged_files.h"
#include "wording/words.h"

namespace tribolog::json_reader_test {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

std::vector<ingest::log::LogTable> read(const std::string& text) {
  return ingest::arrays::parse_json_log(text, "a.json");
}

std::string refusal(const std::string& text) {
  return test::refusal_of<InputError>([&] { return read(text); });
}

/// As Rhoban/bam records a pendulum on a servo.
std::string bam_log(int rows) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-3, 3);
  nlohmann::json log = {{"mass", 0.49},
                        {"arm_mass", 0.0},
                        {"length", 0.1},
                        {"kp", 32},
                        {"vin", 15.0},
                        {"motor", "mx106"},
                        {"trajectory", "lift_and_drop"}};
  for (int i = 0; i < rows; ++i) {
    log["entries"].push_back({{"timestamp", 0.005 * i},
                              {"position", uniform(random)},
                              {"speed", uniform(random)},
                              {"load", uniform(random)},
                              {"input_volts", 15.1},
                              {"goal_position", uniform(random)},
                              {"torque_enable", i % 2 == 0}});
  }
  return log.dump();
}

TEST(Json, EveryOrientationOfPandasIsTheSameTable) {
  // df.to_json(orient=...) of two columns, t and q, and three rows.
  for (const char* const text :
       {R"([{"t":0.0,"q":5.0},{"t":0.5,"q":6.0},{"t":1.0,"q":null}])",
        R"({"t":{"0":0.0,"1":0.5,"2":1.0},"q":{"0":5.0,"1":6.0,"2":null}})",
        R"({"0":{"t":0.0,"q":5.0},"1":{"t":0.5,"q":6.0},"2":{"t":1.0,"q":null}})",
        R"({"columns":["t","q"],"index":[0,1,2],"data":[[0.0,5.0],[0.5,6.0],[1.0,null]]})",
        "{\"t\":0.0,\"q\":5.0}\n{\"t\":0.5,\"q\":6.0}\n\n{\"t\":1.0,\"q\":null}\n"}) {
    const auto tables = read(text);
    ASSERT_EQ(tables.size(), 1U) << text;
    ASSERT_EQ(tables[0].header.size(), 2U) << text;
    const bool is_sorted = tables[0].header == Names{"q", "t"};
    EXPECT_TRUE(is_sorted || tables[0].header == (Names{"t", "q"})) << text;
    const Values& t = tables[0].columns[is_sorted ? 1 : 0].values;
    const Values& q = tables[0].columns[is_sorted ? 0 : 1].values;
    EXPECT_EQ(t, (Values{0, 0.5, 1})) << text;
    ASSERT_EQ(q.size(), 3U) << text;
    EXPECT_EQ(q[1], 6) << text;
    EXPECT_TRUE(std::isnan(q[2])) << text;
  }
}

TEST(Json, WordsInEveryOrientationOfPandasAreAColumn) {
  for (const char* const text :
       {R"({"columns":["t","mode","q"],"index":[0,1],"data":[[0,"slow",5],[1,"fast",6]]})",
        R"({"t":{"0":0,"1":1},"mode":{"0":"slow","1":"fast"},"q":{"0":5,"1":6}})",
        R"([{"t":0,"mode":"slow","q":5},{"t":1,"mode":"fast","q":6}])"}) {
    const auto tables = read(text);
    ASSERT_EQ(tables.size(), 1U);
    EXPECT_EQ(tables[0].header, (Names{"t", "mode", "q"}));
    EXPECT_EQ(tables[0].columns[1].reading, ingest::log::ColumnReading::words);
    EXPECT_EQ(tables[0].columns[1].words, (Names{"slow", "fast"}));
    EXPECT_EQ(tables[0].columns[1].values, (Values{0, 1}));
  }
}

TEST(Json, WordsAloneAreNoLog) {
  EXPECT_EQ(refusal(R"([{"a": "x"}, {"a": "y"}])"),
            "a.json: no rows of numbers, found 'a' is not read: it holds texts, expected arrays "
            "of two or more numbers");
  // Of names that a configuration lists nothing is made.
  EXPECT_EQ(read(R"({"joints": ["a", "b", "c"], "t": [0, 1, 2]})")[0].header, Names{"t"});
}

TEST(Json, RecordsThatAreNotAlikeAreReadAsThoseThatAre) {
  const auto tables = read(
      R"([{"t": 0, "a": {"x": 1}, "q": [1, 2]}, {"t": 1, "a": {"x": 2}, "q": [3, 4]},
          {"a": {"x": 3}, "t": 2, "q": [5, 6]}, {"t": 3, "a": {"x": 4, "y": 9}, "q": [7, 8]},
          {"t": 4, "a": {"x": 5}, "q": [9, 10, 11]}, {"t": 5, "a": 7, "q": null}])");
  ASSERT_EQ(tables.size(), 1U);
  const auto values = [&](const std::string& name) {
    std::string text;
    for (const auto& column : tables[0].columns) {
      if (column.header.full != name) continue;
      for (const double value : column.values)
        text += std::isnan(value) ? "-" : fmt::format("{} ", value);
    }
    return text;
  };
  EXPECT_EQ(values("t"), "0 1 2 3 4 5 ");
  EXPECT_EQ(values("a.x"), "1 2 3 4 5 -");
  EXPECT_EQ(values("a.y"), "---9 --");
  EXPECT_EQ(values("q_0"), "1 3 5 7 9 -");
  EXPECT_EQ(values("q_2"), "----11 -");
  EXPECT_EQ(values("a"), "-----7 ");
}

TEST(Json, LongFormatHasAColumnForEachSignal) {
  // Out of order, with a reading that is lacking and one that stands twice.
  const auto table = read(R"([
      {"time": 0, "signal": "q", "value": 5, "unit": "deg", "by": "x"},
      {"time": 0, "signal": "tau", "value": 7, "unit": "Nm", "by": "x"},
      {"time": 1, "signal": "tau", "value": 8, "unit": "Nm", "by": "y"},
      {"time": 2, "signal": "q", "value": 6, "unit": "deg", "by": "x"},
      {"time": 2, "signal": "tau", "value": null, "unit": "Nm", "by": "x"},
      {"time": 2, "signal": "q", "value": 99, "unit": "deg", "by": "x"}])")
                         .at(0);
  EXPECT_EQ(table.header, (Names{"time", "q", "tau"}));
  EXPECT_EQ(table.columns[0].values, (Values{0, 1, 2}));
  EXPECT_EQ(table.columns[1].header.unit, "deg");
  EXPECT_EQ(table.columns[1].values[0], 5);
  EXPECT_TRUE(std::isnan(table.columns[1].values[1]));
  EXPECT_EQ(table.columns[1].values[2], 6);
  EXPECT_EQ(table.columns[1].gaps, 1U);
  EXPECT_EQ(table.columns[2].values[1], 8);
  EXPECT_EQ(wording::words(table.notes),
            (Names{"6 rows are a signal's reading each ('q', 'tau'); those of the same time are "
                   "one row here",
                   "1 reading is left out: its signal has one at that time",
                   "'by' is not read: it is said of single readings"}));
}

TEST(Json, SignalsThatHaveNoTimesInCommonAreNotSpread) {
  std::string text = "[";
  for (int k = 0; k < 90; ++k) {
    text +=
        fmt::format(R"({}{{"t": {}, "name": "s{}", "value": {}}})", k == 0 ? "" : ",", k, k % 9, k);
  }
  const auto table = read(text + "]").at(0);
  EXPECT_EQ(table.header, (Names{"t", "name"}));
  EXPECT_EQ(wording::words(table.notes),
            Names{"'value' is not read: its signals have too few times in common to be columns"});
}

TEST(Json, ABrokenLineIsNamed) {
  const std::string said = refusal("{\"t\":0}\n{\"t\":1}\n{\"t\":oops}\n");
  EXPECT_NE(said.find("a.json:3:"), std::string::npos) << said;
}

TEST(Json, BamLogsAreReadToTheBit) {
  const std::string text = bam_log(300);
  const test::TemporaryDirectory directory;
  const auto tables = ingest::arrays::read_bam_json(directory.file("log.json", text));
  ASSERT_EQ(tables.size(), 1U);
  const ingest::log::LogTable& table = tables[0];
  EXPECT_EQ(table.header, (Names{"goal_position", "input_volts", "load", "position", "speed",
                                 "timestamp", "torque_enable"}));
  const auto log = nlohmann::json::parse(text);
  for (std::size_t row = 0; row < 300; ++row) {
    const double position = log["entries"][row]["position"];
    ASSERT_EQ(std::bit_cast<std::uint64_t>(table.columns[3].values[row]),
              std::bit_cast<std::uint64_t>(position));
    ASSERT_EQ(table.columns[6].values[row], row % 2 == 0 ? 1 : 0);
  }
  EXPECT_EQ(wording::words(table.notes),
            (Names{"arm_mass = 0", "kp = 32", "length = 0.1", "mass = 0.49", "vin = 15",
                   "motor = 'mx106'", "trajectory = 'lift_and_drop'"}));
}

TEST(Json, ObjectOfArrays) {
  const auto tables = read(R"({"t": [0, 1, 2], "arm": {"q": [[1, 2], [3, 4], [5, 6]]}, "n": 3})");
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].header, (Names{"t", "arm.q_0", "arm.q_1"}));
  EXPECT_EQ(tables[0].columns[2].values, (Values{2, 4, 6}));
  EXPECT_EQ(wording::words(tables[0].notes), (Names{"n = 3"}));
}

TEST(Json, ArrayOfObjectsWithKeysThatComeAndGo) {
  const auto tables =
      read(R"([{"t": 0, "q": 1}, {"t": 1, "T": 20}, {"t": 2, "q": null, "s": [[]]}])");
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].header, (Names{"t", "q", "T"}));
  EXPECT_EQ(tables[0].columns[1].gaps, 2U);
  EXPECT_EQ(tables[0].columns[2].gaps, 2U);
  EXPECT_EQ(tables[0].columns[2].values[1], 20);
  EXPECT_EQ(wording::words(tables[0].notes),
            (Names{"'s' is not read: it holds lists or objects in its rows"}));
}

TEST(Json, SeveralArraysOfObjectsKeepTheirNames) {
  const auto tables = read(R"({"a": [{"t": 0}, {"t": 1}], "b": [{"t": 0}, {"t": 1}, {"t": 2}]})");
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].group, "b");
  EXPECT_EQ(tables[0].header, (Names{"b/t"}));
  EXPECT_EQ(tables[1].group, "a");
}

TEST(Json, NumbersThatOnlyPythonWritesAreGaps) {
  const auto tables =
      read(R"({"q": [1, NaN, Infinity, -Infinity, null], "a NaN": "Infinity \" NaN"})");
  EXPECT_EQ(tables[0].columns[0].gaps, 4U);
  EXPECT_EQ(wording::words(tables[0].notes), (Names{R"(a NaN = 'Infinity " NaN')"}));
}

TEST(Json, RoundedIntegersAreNoted) {
  EXPECT_EQ(wording::words(read("[1700000000000000001, 2]")[0].notes),
            (Names{"'value' holds integers of 2^53 and more: they are rounded"}));
}

TEST(Json, KeysOfFewRowsDoNotBlowTheTableUp) {
  std::string text = "[";
  for (int i = 0; i < 50'000; ++i) {
    if (i > 0) text += ',';
    text.append("{\"k").append(std::to_string(i)).append("\":1,\"t\":0}");
  }
  const auto tables = read(text + "]");
  EXPECT_EQ(tables[0].header, (Names{"t"}));
  EXPECT_EQ(wording::words(tables[0].notes.back()), "and 49988 more that are not read");
}

TEST(Json, RefusalsSayWhere) {
  EXPECT_EQ(refusal("{\"q\": [1, NaN, 2,\n NaN, x]}").substr(0, 23), "a.json:2:7: no JSON: sy");
  EXPECT_EQ(refusal(R"({"q": [1, 2], "q": [3, 4]})"),
            "a.json: key 'q' stands twice in one object; hint: rename one of them");
  EXPECT_EQ(refusal(R"({"mass": 1, "name": "x", "ragged": [[1], [2, 3]]})"),
            "a.json: no rows of numbers, found mass = 1; name = 'x'; 'ragged' is not read: its "
            "lists are of different length, expected arrays of two or more numbers");
  EXPECT_NE(refusal("[1, 1e999]").find("no JSON"), std::string::npos);
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("[]"), "");
  EXPECT_NE(refusal("7"), "");
}

TEST(Json, DeepNestingIsRefused) {
  EXPECT_EQ(refusal(std::string(5'000'000, '[')), "a.json: JSON is nested more than 32 deep");
  std::string deep = "[1, 2]";
  for (std::size_t i = 1; i < ingest::arrays::deepest_json; ++i) deep = R"({"a": )" + deep + "}";
  EXPECT_EQ(read(deep)[0].rows, 2U);
  EXPECT_NE(refusal("[" + deep + "]"), "");
}

TEST(Json, DamageIsAnswered) {
  const std::string text = bam_log(20);
  test::expect_cuts_answered(read, text, 500);
  test::expect_changes_answered(read, text, 500);
}

// As a node of ROS writes sensor_msgs/JointState line by line.
TEST(JsonReader, NamesTheNumbersOfAListAfterTheJoints) {
  const auto line = [](int k) {
    return "{\"stamp\": {\"sec\": " + std::to_string(k) +
           "}, \"name\": [\"a\", \"b\"], \"position\": [0.5, " + std::to_string(k) +
           "], \"velocity\": [], \"k\": [7, 8, 9]}\n";
  };
  const auto table = read(line(1) + line(2)).at(0);
  EXPECT_EQ(table.header, (Names{"stamp.sec", "a.position", "b.position", "k_0", "k_1", "k_2"}));
  EXPECT_EQ(table.columns.at(2).values, (Values{1, 2}));
  ASSERT_EQ(table.notes.size(), 1U);
  EXPECT_NE(wording::words(table.notes[0]).find("'velocity' is not read"), std::string::npos);
  // A path that stands twice would give two numbers a row.
  EXPECT_EQ(read(R"([{"a": {"b": 1}, "a.b": 2, "t": 0}, {"a": {"b": 1}, "a.b": 2, "t": 1}])")
                .at(0)
                .header,
            Names{"t"});
}

TEST(JsonReader, ReadsIsoTimes) {
  for (const char* text :
       {R"([{"t": "2026-03-01T08:15:00.5Z", "q": 1}, {"t": "2026-03-01T08:15:02.25Z", "q": 2}])",
        R"({"t": ["2026-03-01T08:15:00.5Z", "2026-03-01T08:15:02.25Z"], "q": [1, 2]})",
        R"({"t": {"0": "2026-03-01T08:15:00.5Z", "1": "2026-03-01T08:15:02.25Z"},
            "q": {"0": 1, "1": 2}})"}) {
    const auto table = read(text).at(0);
    EXPECT_EQ(table.columns.at(0).reading, ingest::log::ColumnReading::iso_time) << text;
    EXPECT_EQ(table.columns.at(0).values, (Values{0.5, 2.25})) << text;
    EXPECT_EQ(table.columns.at(0).origin, 1772352900) << text;
  }
  EXPECT_EQ(read(R"([{"t": "2026-03-01T08:15:00Z", "q": 1}, {"t": 5, "q": 2}])").at(0).header,
            Names{"q"})
      << "times and numbers";
}

}  // namespace
}  // namespace tribolog::json_reader_test
