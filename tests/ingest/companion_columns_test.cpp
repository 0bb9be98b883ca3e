// A recording whose quantities stand in files of their own is the recording from one file.

#include "ingest/dataset/companion_columns.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/encodings.h"
#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"
#include "wording/words.h"

namespace tribolog::companion_columns_test {
namespace {

using test::TemporaryDirectory;

constexpr int rows = 200;
const std::string effort_column = "- arm_1_joint_effort";
const std::string more = "log both at the same moments, or bring them to one clock in one file";

double time_s(int row) { return row / 100.0; }
double angle_rad(int row) { return 0.3 * std::sin(2 * time_s(row)) + 1e-5 * (row % 7); }
double torque_Nm(int row) { return 20 * std::cos(angle_rad(row)) + 0.1 * (row % 11); }
double temperature_C(int row) { return 30 + 0.01 * row; }

/// "name,name" and a line for each row.
template <class Line>
std::string log(const std::string& header, const Line& line, int number_of_rows = rows) {
  std::string csv = header + "\n";
  for (int i = 0; i < number_of_rows; ++i) csv += line(i) + "\n";
  return csv;
}

std::string all_in_one() {
  return log("t,q,T," + effort_column, [](int i) {
    return fmt::format("{},{},{},{}", time_s(i), angle_rad(i), temperature_C(i), torque_Nm(i));
  });
}

std::string angles() {
  return log("t,q,q2", [](int i) { return fmt::format("{},{},0", time_s(i), angle_rad(i)); });
}

/// @param delay_s of its time from a row on.
std::string efforts(double delay_s = 0, int from_row = 0, const std::string& time = "t") {
  return log(time + ",- torso_lift_joint_effort," + effort_column, [&](int i) {
    return fmt::format("{},0,{}", time_s(i) + (i >= from_row ? delay_s : 0), torque_Nm(i));
  });
}

std::string temperatures() {
  return log("T", [](int i) { return fmt::format("{}", temperature_C(i)); });
}

/// @param places behind the units of effort and temperature: ", file = ...".
std::string manifest(const std::string& file, const std::string& place_of_effort,
                     const std::string& place_of_temperature, const std::string& log_rules = "") {
  return "schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n[joint]\nname = \"J\"\n"
         "gear_ratio = 100\n[effort]\nkind = \"joint_torque\"\nside = \"joint\"\n" +
         log_rules + "[columns]\ntime = {name = \"t\", unit = \"s\"}\n" +
         "angle = {name = \"q\", unit = \"rad\"}\n" +
         fmt::format("effort = {{name = \"{}\", unit = \"Nm\"{}}}\n", effort_column,
                     place_of_effort) +
         fmt::format("temperature = {{name = \"T\", unit = \"degC\"{}}}\n", place_of_temperature) +
         "[[recording]]\nrole = \"rough_sweep\"\nfile = \"" + file + "\"\nfrom_s = 0.1\n";
}

std::string of_three_files(const std::string& more_of_effort = "") {
  return manifest("q.csv", ", file = \"tau.csv\"" + more_of_effort, ", file = \"temp.csv\"");
}

/// The logs beside a manifest.
class CompanionColumns : public testing::Test {
 protected:
  void SetUp() override {
    write("q.csv", angles());
    write("tau.csv", efforts());
    write("temp.csv", temperatures());
  }
  void write(const std::string& name, const std::string& text) {
    (void)directory_.file(name, text);
  }
  joint::Dataset read(const std::string& text) {
    return ingest::dataset::read_dataset(directory_.file("dataset.toml", text));
  }
  std::string refusal(const std::string& text = of_three_files()) {
    const std::string message = test::refusal_of<InputError>([&] { return read(text); });
    const std::string before = directory_.path("");
    return message.starts_with(before) ? message.substr(before.size()) : message;
  }

 private:
  test::TemporaryDirectory directory_;
};

void expect_same(const joint::Recording& a, const joint::Recording& b) {
  EXPECT_EQ(a.t_s, b.t_s);
  EXPECT_EQ(a.q_rad, b.q_rad);
  EXPECT_EQ(a.torque_Nm, b.torque_Nm);
  EXPECT_EQ(a.temperature_C, b.temperature_C);
  EXPECT_EQ(a.rows_read, b.rows_read);
}

/// To the last bit, and identification is a function of the recordings.
TEST_F(CompanionColumns, GiveTheRecordingOfOneFile) {
  write("all.csv", all_in_one());
  const joint::Dataset split = read(of_three_files());
  const joint::Dataset whole = read(manifest("all.csv", "", ""));
  ASSERT_EQ(split.recordings.at(0).size(), static_cast<std::size_t>(rows - 10));
  expect_same(split.recordings[0], whole.recordings.at(0));
  EXPECT_EQ(wording::words(split.notes),
            std::vector<std::string>{"columns of the logs that are not used: "
                                     "'- torso_lift_joint_effort'"});
}

/// Rows a hundredth of a second apart, whether the log says so or the manifest.
TEST_F(CompanionColumns, MayBeOfLogsWithoutAClock) {
  std::string text = of_three_files();
  const std::string clock = "time = {name = \"t\", unit = \"s\"}";
  text.replace(text.find(clock), clock.size(), "time = {rate_Hz = 100}");
  expect_same(read(text).recordings.at(0), read(of_three_files()).recordings.at(0));
}

TEST_F(CompanionColumns, AreAmongTheInputs) {
  const joint::Dataset d = read(of_three_files());
  ASSERT_EQ(d.inputs.size(), 4U);
  EXPECT_EQ(d.inputs[1].name, "q.csv");
  EXPECT_EQ(d.inputs[1].conversions.size(), 4U);
  EXPECT_EQ(d.inputs[2].name, "tau.csv");
  EXPECT_EQ(d.inputs[2].role, "rough_sweep");
  EXPECT_EQ(d.inputs[2].sha256, sha256_hex(efforts()));
  EXPECT_EQ(d.inputs[2].bytes, efforts().size());
  EXPECT_EQ(d.inputs[2].rows_read, static_cast<std::size_t>(rows));
  EXPECT_EQ(d.inputs[2].rows_used, static_cast<std::size_t>(rows - 10));
  EXPECT_EQ(d.inputs[2].skipped.at(0).count, 10U);
  EXPECT_TRUE(d.inputs[2].conversions.empty()) << "they are the recording's";
  EXPECT_EQ(d.inputs[3].name, "temp.csv");
  EXPECT_EQ(d.inputs[3].sha256, sha256_hex(temperatures()));
}

TEST_F(CompanionColumns, MayNameTheRecordingsOwnFile) {
  write("all.csv", all_in_one());
  const joint::Dataset d = read(manifest("all.csv", ", file = \"all.csv\"", ""));
  EXPECT_EQ(d.inputs.size(), 2U);
  EXPECT_EQ(d.recordings.at(0).torque_Nm.size(), static_cast<std::size_t>(rows - 10));
}

TEST_F(CompanionColumns, MayStandInOneFileTogetherAndOverrideTheCommonOnes) {
  write("rest.csv", log("T," + effort_column, [](int i) {
          return fmt::format("{},{}", temperature_C(i), torque_Nm(i));
        }));
  const std::string place = ", file = \"rest.csv\"";
  const joint::Dataset d = read(manifest("q.csv", place, place));
  EXPECT_EQ(d.inputs.size(), 3U) << "read once";
  write("all.csv", all_in_one());
  expect_same(d.recordings.at(0), read(manifest("all.csv", "", "")).recordings.at(0));
  const joint::Dataset own =
      read(manifest("q.csv", ", file = \"gone.csv\"", place) + "columns = {effort = {name = \"" +
           effort_column + "\", unit = \"Nm\", file = \"rest.csv\"}}\n");
  expect_same(own.recordings.at(0), d.recordings[0]);
}

TEST_F(CompanionColumns, MayBeOfAnotherFormat) {
  nlohmann::json json;
  for (int i = 0; i < rows; ++i) {
    json["t"].push_back(time_s(i));
    json[effort_column].push_back(torque_Nm(i));
  }
  write("tau.json", json.dump());
  const std::string text = manifest("q.csv", ", file = \"tau.json\"", ", file = \"temp.csv\"");
  expect_same(read(text).recordings.at(0), read(of_three_files()).recordings.at(0));
  json["t"][70] = 0.8;
  write("tau.json", json.dump());
  EXPECT_EQ(refusal(text),
            "tau.json: column 't': row 71 is of another time than in 'q.csv', found 0.8 s, "
            "expected 0.7 s within half a sampling step, 0.005 s; hint: the rows of both files are "
            "matched one by one: " +
                more);
}

TEST_F(CompanionColumns, LeaveOutRowsThatAreGaps) {
  write("tau.csv", log("t," + effort_column, [](int i) {
          return fmt::format("{},{}", time_s(i), i == 50 ? "nan" : fmt::format("{}", torque_Nm(i)));
        }));
  const joint::Dataset d = read(of_three_files());
  EXPECT_EQ(d.recordings.at(0).size(), static_cast<std::size_t>(rows - 11));
  ASSERT_EQ(d.recordings[0].skipped.size(), 2U);
  EXPECT_EQ(wording::words(d.recordings[0].skipped[1].reason),
            "gap (nan) in column '- arm_1_joint_effort'");
  EXPECT_EQ(d.recordings[0].skipped[1].count, 1U);
}

/// Power that fails while both files are written.
TEST_F(CompanionColumns, MayBeCutOffInTheLastRow) {
  std::string csv = efforts();
  csv.resize(csv.rfind(','));
  write("tau.csv", csv);
  const joint::Dataset d = read(of_three_files());
  EXPECT_EQ(d.recordings.at(0).rows_read, static_cast<std::size_t>(rows));
  EXPECT_EQ(d.recordings[0].size(), static_cast<std::size_t>(rows - 11));
  EXPECT_EQ(wording::words(d.recordings[0].skipped.at(0).reason), "cut off at the end of the file");
}

TEST_F(CompanionColumns, HaveToHaveTheSameNumberOfRows) {
  write("temp.csv", log("T", [](int) { return std::string("30"); }, 150));
  EXPECT_EQ(refusal(),
            "temp.csv: the number of rows is not that of 'q.csv', found 150, expected 200; hint: "
            "the rows of both files are matched one by one: " +
                more);
}

TEST_F(CompanionColumns, HaveToBeOfTheSameTime) {
  write("tau.csv", efforts(0.004));
  EXPECT_EQ(read(of_three_files()).recordings.at(0).size(), static_cast<std::size_t>(rows - 10))
      << "less than half a step of 10 ms";
  write("tau.csv", efforts(0.006, 120));
  EXPECT_EQ(refusal(),
            "tau.csv:122: column 't': row 121 is of another time than in 'q.csv', found 1.206 s, "
            "expected 1.2 s within half a sampling step, 0.005 s; hint: the rows of both files are "
            "matched one by one: " +
                more);
}

TEST_F(CompanionColumns, MayNameTheirTimeOtherwise) {
  const std::string text = of_three_files(", time = \"stamp\"");
  write("tau.csv", efforts(0, 0, "stamp"));
  EXPECT_EQ(read(text).recordings.at(0).size(), static_cast<std::size_t>(rows - 10));
  write("tau.csv", efforts(5, 0, "stamp"));
  EXPECT_EQ(read(of_three_files()).recordings.at(0).size(), static_cast<std::size_t>(rows - 10))
      << "a time of another name is not known to be one";
  EXPECT_NE(refusal(text).find("tau.csv:2: column 'stamp': row 1 is of another time than in "
                               "'q.csv', found 5 s, expected 0 s"),
            std::string::npos)
      << refusal(text);
  write("tau.csv", efforts());
  EXPECT_NE(refusal(text).find("tau.csv:1: column 'stamp' is missing"), std::string::npos)
      << refusal(text);
}

/// Clocks that count from 1970 are compared as they stand, though each is read from its start.
TEST_F(CompanionColumns, AreComparedOnClocksOfOneEpoch) {
  const auto at = [](double start, const char* column) {
    return log(std::string("t,") + column,
               [&](int i) { return fmt::format("{:.3f},{}", start + time_s(i), torque_Nm(i)); });
  };
  write("q.csv", at(1.7e9, "q"));
  write("tau.csv", at(1.7e9, effort_column.c_str()));
  EXPECT_EQ(read(of_three_files()).recordings.at(0).size(), static_cast<std::size_t>(rows - 10));
  write("tau.csv", at(1.7e9 + 3, effort_column.c_str()));
  EXPECT_NE(refusal().find("row 1 is of another time than in 'q.csv', found 3 s, expected 0 s"),
            std::string::npos)
      << refusal();
}

TEST_F(CompanionColumns, AreNotMatchedWhereRowsWereSkipped) {
  std::string csv = efforts();
  csv.insert(csv.find("\n0.5,") + 1, "fault\n");
  write("tau.csv", csv);
  const std::string text = manifest("q.csv", ", file = \"tau.csv\"", ", file = \"temp.csv\"",
                                    "[log]\nskip_bad_rows = true\n");
  EXPECT_EQ(
      refusal(text),
      "tau.csv: the rows of several files are matched one by one, and rows are left out here, "
      "found 1, expected none; hint: mend them, or write nan");
}

TEST_F(CompanionColumns, AreRefusedAtTheirOwnPlace) {
  write("tau.csv", log(effort_column, [](int i) { return std::string(i == 40 ? "1e300" : "1"); }));
  EXPECT_TRUE(refusal().starts_with("tau.csv:42: column '- arm_1_joint_effort': no joint has"))
      << refusal();
  write("tau.csv", log("t,tau", [](int i) { return fmt::format("{},1", time_s(i)); }));
  EXPECT_TRUE(refusal().starts_with("tau.csv:1: column '- arm_1_joint_effort' is missing"))
      << refusal();
}

TEST_F(CompanionColumns, AreStatedInTheManifestAlone) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = of_three_files();
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(refusal(with("name = \"t\"", "name = \"t\", file = \"clock.csv\"")),
            "dataset.toml:11:28: key 'columns.time.file': is not for the time; "
            "hint: the recording's file is the one that has the time; state a file for the other "
            "columns");
  EXPECT_TRUE(refusal(with("tau.csv", "")).find("'columns.effort.file': is empty") !=
              std::string::npos)
      << refusal(with("tau.csv", ""));
  EXPECT_NE(refusal(with("file = \"tau.csv\"", "time = \"t\"")).find("unknown key"),
            std::string::npos)
      << "a time without a file";
  EXPECT_NE(refusal(manifest("q.csv", ", file = \"tau.csv\", time = \"t\"",
                             ", file = \"tau.csv\", time = \"u\""))
                .find("another name for the time of 'tau.csv', found 'u', expected 't'"),
            std::string::npos);
}

}  // namespace
}  // namespace tribolog::companion_columns_test
