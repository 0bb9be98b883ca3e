// One log in the dialects that robots, tools and people write: what init proposes for each is read,
// and gives the numbers of the plain one.

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"
#include "inspect/survey/manifest_proposal.h"
#include "support/run_program.h"

namespace tribolog::log_dialects_test {
namespace {

constexpr int rows = 4000;
constexpr double gear_ratio = 50;

double t_s(int row) { return 0.01 * row; }
/// A sweep there and back.
double q_rad(int row) {
  return t_s(row) < 20 ? -0.9 + 0.09 * t_s(row) : 0.9 - 0.09 * (t_s(row) - 20);
}
double current_A(int row) { return 3 * std::cos(q_rad(row)) + (t_s(row) < 20 ? 0.5 : -0.5); }

using Row = std::function<std::string(int)>;

std::string log_of(const std::string& header, const Row& row) {
  std::string text = header;
  for (int k = 0; k < rows; ++k) text += row(k) + "\n";
  return text;
}

/// Angle and current behind a time of any kind.
std::string cells(int row, char delimiter = ',') {
  return fmt::format("{0}{1:.6f}{0}{2:.5f}", delimiter, q_rad(row), current_A(row));
}

std::string with_commas(std::string text) {
  for (char& c : text) c = c == '.' ? ',' : c;
  return text;
}

/// "23:59:50.00" at first.
std::string time_of_day(int row) {
  const int hundredths = (23 * 3600 + 59 * 60 + 50) * 100 + row;
  const int s = hundredths / 100 % 86400;
  return fmt::format("{:02}:{:02}:{:02}.{:02}", s / 3600, s / 60 % 60, s % 60, hundredths % 100);
}

std::string date(int row) { return row < 1000 ? "2026-02-28" : "2026-03-01"; }

inspect::survey::ProposalOptions known() {
  inspect::survey::ProposalOptions options;
  options.gear_ratio = gear_ratio;
  options.columns.gear_ratio = gear_ratio;
  options.torque_constant_Nm_A = 0.1;
  return options;
}

std::string proposed(const std::string& log, const inspect::survey::ProposalOptions& options) {
  return inspect::survey::propose_manifest(
             {inspect::survey::survey_log(log, options.log_rules, options.columns)}, options)
      .text;
}

/// What identify would read.
joint::Dataset dataset_of(const test::ScratchDirectory& scratch, const std::string& file,
                          const std::string& log, inspect::survey::ProposalOptions options) {
  options.directory = scratch.path();
  const std::string manifest = proposed(scratch.write(file, log), options);
  SCOPED_TRACE(manifest);
  return ingest::dataset::read_dataset(scratch.write("dataset.toml", manifest));
}

/// @param lost rows of the plain log that are not among those of this one.
void expect_the_same(const joint::Dataset& dataset, const std::vector<int>& kept) {
  ASSERT_EQ(dataset.recordings.size(), 1U);
  const joint::Recording& r = dataset.recordings.front();
  EXPECT_EQ(r.role, joint::Role::rough_sweep);
  EXPECT_EQ(dataset.manifest.drive.kind(), joint::EffortKind::motor_current);
  ASSERT_EQ(r.t_s.size(), kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    ASSERT_NEAR(r.t_s[k] - r.t_s[0], t_s(kept[k]) - t_s(kept[0]), 2e-6) << k;
    ASSERT_NEAR(r.q_rad[k], q_rad(kept[k]), 2e-6) << k;
    ASSERT_NEAR(r.torque_Nm[k], 0.1 * current_A(kept[k]), 2e-6) << k;
  }
}

std::vector<int> all_rows() {
  std::vector<int> kept(rows);
  for (int k = 0; k < rows; ++k) kept[static_cast<std::size_t>(k)] = k;
  return kept;
}

struct Dialect {
  const char* name;
  const char* file;
  std::string log;
  std::function<void(inspect::survey::ProposalOptions&)> state{};
};

void PrintTo(const Dialect& dialect, std::ostream* out) { *out << dialect.name; }

std::string json_row(int k) {
  return fmt::format(
      "{{\"header\": {{\"stamp\": {{\"sec\": {}, \"nanosec\": {}}}, \"frame_id\": \"\"}}, "
      "\"name\": [\"shoulder\", \"elbow\"], \"position\": [0.1, {:.6f}], \"velocity\": [], "
      "\"effort\": [1.5, {:.5f}]}}",
      1700000000 + k / 100, k % 100 * 10'000'000, q_rad(k), current_A(k));
}

std::string joined(const std::string& open, const Row& row, const std::string& close) {
  std::string text = open;
  for (int k = 0; k < rows; ++k) text += (k == 0 ? "" : ",\n") + row(k);
  return text + close;
}

/// As pandas writes a table by its columns.
std::string pandas_column(const std::string& name, int entries, const Row& value) {
  std::string text = "\"" + name + "\": {";
  for (int k = 0; k < entries; ++k) {
    text += fmt::format("{}\"{}\": {}", k == 0 ? "" : ", ", k, value(k));
  }
  return text + "}";
}

std::vector<Dialect> dialects() {
  const std::string names = ",q_rad,i_A\n";
  const auto seconds = [](int k) { return fmt::format("{:.2f}", t_s(k)); };
  const auto behind = [](const Row& time, char delimiter = ',') {
    return [=](int k) { return time(k) + cells(k, delimiter); };
  };
  const Row plain = behind(seconds);
  return {
      {"Plain", "log.csv", log_of("t_s" + names, plain)},
      {"PandasIndex", "log.csv",
       log_of(",t_s" + names, [=](int k) { return fmt::format("{},", k) + plain(k); })},
      {"TwoColumnsOfOneName", "log.csv",
       log_of("t_s,q_rad,q_rad,i_A\n",
              [=](int k) {
                return fmt::format("{:.2f},{:.6f},0.5,{:.5f}", t_s(k), q_rad(k), current_A(k));
              })},
      {"NamesInAComment", "log.txt", log_of("# t_s q_rad i_A\n", behind(seconds, ' '))},
      {"NamesAndUnitsInComments", "log.txt", log_of("# made by hand\n# t,q,i\n# s,rad,A\n", plain)},
      {"PercentComments", "log.csv", log_of("% a robot\nt_s" + names, plain)},
      {"SlashComments", "log.csv", log_of("// a robot\nt_s" + names, plain)},
      {"DelimiterForExcel", "log.csv", log_of("sep=;\nt_s;q_rad;i_A\n", behind(seconds, ';'))},
      {"DecimalCommas", "log.csv",
       log_of("t_s;q_rad;i_A\n", [=](int k) { return with_commas(behind(seconds, ';')(k)); })},
      {"DecimalCommasBetweenTabs", "log.txt",
       log_of("t_s\tq_rad\ti_A\n", [=](int k) { return with_commas(behind(seconds, '\t')(k)); })},
      {"Minutes", "log.csv", log_of("time_min" + names, behind([](int k) {
                                      return fmt::format("{:.12f}", t_s(k) / 60);
                                    }))},
      {"HundredNanoseconds", "log.csv",
       log_of("time_100ns" + names, behind([](int k) { return fmt::format("{}", k * 100'000); }))},
      {"HundredNanosecondsInBrackets", "log.csv",
       log_of("t [100 ns]" + names, behind([](int k) { return fmt::format("{}", k * 100'000); }))},
      {"WindowsTime", "log.csv", log_of("timestamp" + names, behind([](int k) {
                                          return fmt::format(
                                              "{}", 134'000'000'000'000'000 + k * 100'000L);
                                        }))},
      {"CoarseTimeBesideAFineOne", "log.csv",
       log_of("time,elapsed_ms" + names, behind([](int k) {
                return fmt::format("{},{}", time_of_day(k).substr(0, 8), 10 * k);
              }))},
      {"TimeOfDay", "log.csv", log_of("Uhrzeit" + names, behind(time_of_day))},
      {"DateAndTime", "log.csv",
       log_of("date,time" + names, behind([](int k) { return date(k) + "," + time_of_day(k); }))},
      {"SecondsAndNanoseconds", "log.csv",
       log_of("sec,nanosec" + names, behind([](int k) {
                return fmt::format("{},{}", 1'700'000'000 + k / 100, k % 100 * 10'000'000);
              }))},
      {"SecondsAndNanosecondsOfAStamp", "log.csv",
       log_of("header.stamp.secs,header.stamp.nsecs" + names,
              behind([](int k) { return fmt::format("{},{}", k / 100, k % 100 * 10'000'000); }))},
      {"EchoOfRos2", "log.csv",
       log_of("",
              [](int k) {
                return fmt::format("{},{},base,shoulder,elbow,0.1,{:.6f},0,0,1.5,{:.5f}",
                                   1'700'000'000 + k / 100, k % 100 * 10'000'000, q_rad(k),
                                   current_A(k));
              }),
       [](auto& options) { options.effort_kind = joint::EffortKind::motor_current; }},
      {"EchoOfRos2WithoutSpeeds", "log.csv",
       log_of("",
              [](int k) {
                return fmt::format("{},{},base,shoulder,elbow,0.1,{:.6f},,1.5,{:.5f}",
                                   1'700'000'000 + k / 100, k % 100 * 10'000'000, q_rad(k),
                                   current_A(k));
              }),
       [](auto& options) { options.effort_kind = joint::EffortKind::motor_current; }},
      {"JointStatesAsJsonLines", "log.jsonl", log_of("", json_row)},
      {"NestedJson", "log.json",
       joined(
           "[",
           [](int k) {
             return fmt::format(
                 "{{\"t\": {:.2f}, \"position\": [0.1, {:.6f}], "
                 "\"effort\": [1.5, {:.5f}]}}",
                 t_s(k), q_rad(k), current_A(k));
           },
           "]")},
      {"IsoTimesInJson", "log.json",
       joined(
           "[",
           [](int k) {
             return fmt::format("{{\"when\": \"{}T{}Z\", \"q_rad\": {:.6f}, \"i_A\": {:.5f}}}",
                                date(k), time_of_day(k), q_rad(k), current_A(k));
           },
           "]")},
      {"RowsOfJointsInJson", "log.json",
       joined(
           "{\"robot\": \"arm\", \"samples\": [",
           [](int k) {
             return fmt::format(
                 "{{\"t_s\": {0:.2f}, \"joint\": \"shoulder\", \"q_rad\": 0.1, \"i_A\": 1.5}},"
                 "{{\"t_s\": {0:.2f}, \"joint\": \"elbow\", \"q_rad\": {1:.6f}, \"i_A\": "
                 "{2:.5f}}}",
                 t_s(k), q_rad(k), current_A(k));
           },
           "]}")},
      {"RowsOfJointsByNumberInJsonLines", "log.jsonl",
       log_of("",
              [](int k) {
                return fmt::format(
                    "{{\"t_s\": {0:.2f}, \"joint_id\": 1, \"q_rad\": 0.1, \"i_A\": 1.5}}\n"
                    "{{\"t_s\": {0:.2f}, \"joint_id\": 2, \"q_rad\": {1:.6f}, \"i_A\": {2:.5f}}}",
                    t_s(k), q_rad(k), current_A(k));
              }),
       [](auto& options) { options.joint = "2"; }},
      {"LongFormatInJson", "log.json",
       joined(
           "[",
           [](int k) {
             return fmt::format(
                 "{{\"time\": {0:.2f}, \"signal\": \"q_rad\", \"value\": {1:.6f}}},"
                 "{{\"time\": {0:.2f}, \"signal\": \"i_A\", \"value\": {2:.5f}}}",
                 t_s(k), q_rad(k), current_A(k));
           },
           "]")},
      {"LongFormatOfJointsInJson", "log.json",
       joined(
           "[",
           [](int k) {
             return fmt::format(
                 "{{\"stamp\": {{\"sec\": {0}, \"nanosec\": {1}}}, \"joint\": \"shoulder\", "
                 "\"name\": \"position\", \"value\": 0.1}},"
                 "{{\"stamp\": {{\"sec\": {0}, \"nanosec\": {1}}}, \"joint\": \"elbow\", "
                 "\"name\": \"position\", \"value\": {2:.6f}}},"
                 "{{\"stamp\": {{\"sec\": {0}, \"nanosec\": {1}}}, \"joint\": \"elbow\", "
                 "\"name\": \"current\", \"value\": {3:.5f}}}",
                 1'700'000'000 + k / 100, k % 100 * 10'000'000, q_rad(k), current_A(k));
           },
           "]")},
      {"MeltedByPandas", "log.json",
       "{" +
           pandas_column("t_s", 2 * rows,
                         [](int k) { return fmt::format("{:.2f}", t_s(k % rows)); }) +
           ", " +
           pandas_column("variable", 2 * rows,
                         [](int k) { return k < rows ? "\"q_rad\"" : "\"i_A\""; }) +
           ", " +
           pandas_column("value", 2 * rows,
                         [](int k) {
                           return k < rows ? fmt::format("{:.6f}", q_rad(k))
                                           : fmt::format("{:.5f}", current_A(k - rows));
                         }) +
           "}"},
      {"LongFormatInText", "log.csv",
       log_of("time;signal;value;unit\n",
              [](int k) {
                return fmt::format("{0:.2f};q;{1:.6f};rad\n{0:.2f};i;{2:.5f};A", t_s(k), q_rad(k),
                                   current_A(k));
              })},
      {"LongFormatOfJointsInText", "log.csv",
       log_of(",timestamp,joint,variable,value\n",
              [](int k) {
                return fmt::format("{3},{0:.2f},elbow,q_rad,{1:.6f}\n{4},{0:.2f},elbow,i_A,{2:.5f}",
                                   t_s(k), q_rad(k), current_A(k), 2 * k, 2 * k + 1);
              })},
      {"MeltedInText", "log.csv",
       log_of("t_s,variable,value\n",
              [](int k) { return fmt::format("{:.2f},q_rad,{:.6f}", t_s(k), q_rad(k)); }) +
           log_of("",
                  [](int k) { return fmt::format("{:.2f},i_A,{:.5f}", t_s(k), current_A(k)); })},
      {"KukaTrace", "log.txt",
       log_of("Zeit [ms]\tAIPos_A2 [Grad]\tMACur_A2 [A]\n",
              [](int k) {
                return fmt::format("{}\t{:.8f}\t{:.5f}", 10 * k, 57.29577951 * q_rad(k),
                                   current_A(k));
              })},
      // As UR's RTDE client writes it: the fields of the recipe with an index, blanks between them.
      {"UrRtde", "log.csv",
       log_of("timestamp actual_q_0 actual_q_1 actual_qd_1 actual_current_0 actual_current_1 "
              "target_moment_1\n",
              [](int k) {
                return fmt::format("{:.3f} 0.1 {:.6f} {:.5f} 1.5 {:.5f} 0.0", 1234 + t_s(k),
                                   q_rad(k), t_s(k) < 20 ? 0.09 : -0.09, current_A(k));
              })},
      // Tags and attributes of the telegram of KUKA's RSI; IPOC counts milliseconds.
      {"KukaRsi", "log.csv",
       log_of("Timestamp,Send.IPOC,Send.RIst.X,Send.AIPos.A1,Send.AIPos.A2,Send.MACur.A1,"
              "Send.MACur.A2\n",
              [](int k) {
                return fmt::format("{:.2f},{},1234.5,5.7,{:.8f},1.5,{:.5f}", t_s(k),
                                   4208163634 + 10 * k, 57.29577951 * q_rad(k), current_A(k));
              })},
      // A table as pendants export it, with the axes' numbers.
      {"FanucPendant", "log.csv",
       log_of("Time (ms),J1 (deg),J2 (deg),J1 Current (A),J2 Current (A)\n",
              [](int k) {
                return fmt::format("{},5.7,{:.8f},1.5,{:.5f}", 10 * k, 57.29577951 * q_rad(k),
                                   current_A(k));
              })},
      {"KukaVariables", "log.csv",
       log_of("time [s],$AXIS_ACT[2],MACur_A2 [A]\n",
              [](int k) {
                return fmt::format("{:.2f},{:.8f},{:.5f}", t_s(k), 57.29577951 * q_rad(k),
                                   current_A(k));
              })},
      {"RowsOfJoints", "log.csv",
       log_of("t_s,joint,q_rad,i_A\n",
              [](int k) {
                return fmt::format("{0:.2f},shoulder,0.1,1.5\n{0:.2f},elbow{1}", t_s(k), cells(k));
              })},
      {"RowsOfJointsByNumber", "log.csv",
       log_of(
           "t_s,joint_id,q_rad,i_A\n",
           [](int k) { return fmt::format("{0:.2f},1,0.1,1.5\n{0:.2f},2{1}", t_s(k), cells(k)); }),
       [](auto& options) { options.joint = "2"; }},
      {"AngleOfTheMotor", "log.csv", log_of("t_s,motor_position,i_A\n", [](int k) {
         return fmt::format("{:.2f},{:.5f},{:.5f}", t_s(k), gear_ratio * q_rad(k), current_A(k));
       })}};
}

class LogDialect : public testing::TestWithParam<Dialect> {};

TEST_P(LogDialect, GivesTheNumbersOfThePlainLog) {
  const test::ScratchDirectory scratch;
  inspect::survey::ProposalOptions options = known();
  if (GetParam().state) GetParam().state(options);
  expect_the_same(dataset_of(scratch, GetParam().file, GetParam().log, options), all_rows());
}

INSTANTIATE_TEST_SUITE_P(Logs, LogDialect, testing::ValuesIn(dialects()),
                         [](const auto& info) { return info.param.name; });

// A lost sample would make the joint faster than it is, were the rows counted instead.
TEST(LogDialects, ACounterWithAKnownRateIsAClockThatKnowsOfLostSamples) {
  const test::ScratchDirectory scratch;
  for (const char* name : {"sample", "counter", "index", "cycle"}) {
    std::string log = std::string(name) + ",q_rad,i_A\n";
    std::vector<int> kept;
    for (int k = 0; k < rows; ++k) {
      if (k % 37 == 5) continue;
      kept.push_back(k);
      log += fmt::format("{}{}\n", 8 + 4 * k, cells(k));
    }
    inspect::survey::ProposalOptions options = known();
    options.columns.rate_Hz = 100;
    expect_the_same(dataset_of(scratch, "log.csv", log, options), kept);
  }
}

TEST(LogDialects, ACounterThatBeginsAnewIsNoClockAndThatIsSaid) {
  const test::ScratchDirectory scratch;
  inspect::survey::ProposalOptions options = known();
  options.columns.rate_Hz = 100;
  const std::string path = scratch.write(
      "log.csv", log_of("counter,q_rad,i_A\n",
                        [](int k) { return fmt::format("{}{}", (k + k / 100) % 256, cells(k)); }));
  const std::string manifest = proposed(path, options);
  EXPECT_NE(manifest.find("rate_Hz = 100 }  # 'counter' shows that samples are lost"),
            std::string::npos)
      << manifest;
}

TEST(LogDialects, ACounterWithoutARateIsNoClock) {
  const test::ScratchDirectory scratch;
  const std::string log =
      log_of("sample,q_rad,i_A\n", [](int k) { return std::to_string(k) + cells(k); });
  const std::string path = scratch.write("log.csv", log);
  const std::string said = test::refusal_of<InputError>([&] { return proposed(path, known()); });
  EXPECT_NE(said.find("'sample' counts rows or milliseconds: state --rate HZ"), std::string::npos)
      << said;
}

TEST(LogDialects, CellsForNothingAreGapsThatAreCounted) {
  const test::ScratchDirectory scratch;
  for (const char* nothing : {"-", "#N/A", "NA", "null", "--", ""}) {
    std::vector<int> kept;
    std::string log = "i_A,t_s,q_rad\n";
    for (int k = 0; k < rows; ++k) {
      const bool is_gap = k < 40 || k % 50 == 7;
      if (!is_gap) kept.push_back(k);
      log += fmt::format("{},{:.2f},{:.6f}\n",
                         is_gap ? nothing : fmt::format("{:.5f}", current_A(k)), t_s(k), q_rad(k));
    }
    const joint::Dataset dataset = dataset_of(scratch, "log.csv", log, known());
    SCOPED_TRACE(nothing);
    expect_the_same(dataset, kept);
    EXPECT_EQ(dataset.recordings.at(0).rows_read, static_cast<std::size_t>(rows));
  }
}

// A reading that goes up and down is no joint's number.
TEST(LogDialects, AReadingCalledAfterAJointTellsNoRows) {
  const test::ScratchDirectory scratch;
  const std::string path =
      scratch.write("log.csv", log_of("t_s,q_rad,i_A,motor\n", [](int k) {
                      return fmt::format("{:.2f}{},{}", t_s(k), cells(k), k * k % 7 - 3);
                    }));
  const auto survey = inspect::survey::survey_log(path);
  ASSERT_EQ(survey.tables.size(), 1U);
  EXPECT_FALSE(survey.tables[0].rows_of);
}

// The rows without a current are left out, and what is left of a stroke may be too short to be
// read.
TEST(LogDialects, ALogThatBeginsWithGapsIsReadFromItsFirstNumberOn) {
  const test::ScratchDirectory scratch;
  const auto log = log_of("t_s,q_rad,i_A\n", [](int k) {
    const double q = -0.9 * std::cos(0.157 * t_s(k));
    return k < 1500 ? fmt::format("{:.2f},{:.6f},-", t_s(k), q)
                    : fmt::format("{:.2f},{:.6f},{:.5f}", t_s(k), q, current_A(k));
  });
  const joint::Dataset dataset = dataset_of(scratch, "log.csv", log, known());
  ASSERT_FALSE(dataset.recordings.empty());
  EXPECT_GE(dataset.recordings.front().t_s.front(), 15.0);
}

TEST(LogDialects, RowsOfOtherJointsAreCounted) {
  const test::ScratchDirectory scratch;
  const std::string log = log_of("t_s,joint,q_rad,i_A\n", [](int k) {
    return fmt::format("{0:.2f},shoulder,0.1,1.5\n{0:.2f},elbow{1}", t_s(k), cells(k));
  });
  const joint::Dataset dataset = dataset_of(scratch, "log.csv", log, known());
  EXPECT_EQ(dataset.manifest.joint, "elbow");
  const joint::Recording& r = dataset.recordings.at(0);
  EXPECT_EQ(r.rows_read, 2U * rows);
  ASSERT_EQ(r.skipped.size(), 1U);
  EXPECT_TRUE(r.skipped[0].reason.is("skipped.other_joint"));
  EXPECT_EQ(r.skipped[0].count, static_cast<std::size_t>(rows));
}

// An empty array is an empty cell; what another node publishes, and what is short of cells, is left
// out.
TEST(LogDialects, EchoedJointStatesWithEmptyArraysAreReadWhereTheyTell) {
  const test::ScratchDirectory scratch;
  std::string log;
  std::vector<int> kept;
  std::size_t unclear = 0;
  std::size_t with_gaps = 0;
  for (int k = 0; k < rows; ++k) {
    const std::string stamp = fmt::format("{},{},", 1'700'000'000 + k / 100, k % 100 * 10'000'000);
    const std::string message = stamp + ",shoulder,elbow";
    if (k % 10 == 3) {  // the effort is empty
      log += fmt::format("{},0.1,{:.6f},0,0,\n", message, q_rad(k));
      ++with_gaps;
    } else if (k % 10 == 5) {  // the speed is
      log += fmt::format("{},0.1,{:.6f},,1.5,{:.5f}\n", message, q_rad(k), current_A(k));
      ++with_gaps;
    } else if (k % 10 == 7) {  // one array is lacking, which one is not told
      log += fmt::format("{},0.1,{:.6f},1.5,{:.5f}\n", message, q_rad(k), current_A(k));
      ++unclear;
    } else {
      log += fmt::format("{},0.1,{:.6f},0,0,1.5,{:.5f}\n", message, q_rad(k), current_A(k));
      kept.push_back(k);
    }
    if (k % 4 != 0) continue;  // as many cells, of other joints
    log += stamp + (k % 8 == 0 ? ",left,right,1,2,3,4,5,6\n" : ",gripper,0.5,0,0\n");
    ++unclear;
  }
  inspect::survey::ProposalOptions options = known();
  options.effort_kind = joint::EffortKind::motor_current;
  const joint::Dataset dataset = dataset_of(scratch, "log.csv", log, options);
  expect_the_same(dataset, kept);
  const joint::Recording& r = dataset.recordings.at(0);
  EXPECT_EQ(r.rows_read, rows + static_cast<std::size_t>(rows) / 4);
  std::size_t skipped_unclear = 0;
  std::size_t gaps = 0;
  for (const joint::SkippedRows& skipped : r.skipped) {
    if (skipped.reason.is("skipped.unclear_joint_state")) skipped_unclear += skipped.count;
    if (skipped.reason.is("skipped.gap")) gaps += skipped.count;
  }
  EXPECT_EQ(skipped_unclear, unclear);
  EXPECT_EQ(gaps, with_gaps);
}

/// A log in a vendor's columns whose effort is a torque at the joint, ten times the current.
struct TorqueLog {
  const char* names;  ///< Of time, angle in rad, torque.
  bool is_measured;
};

TEST(LogDialects, TorquesOfVendorsAreThoseOfTheJoint) {
  const test::ScratchDirectory scratch;
  for (const TorqueLog& of :
       {TorqueLog{"time,state.q[1],state.tau_J[1]", true},  // libfranka's logToCSV, in milliseconds
        TorqueLog{"time,q[1],tau_J[1]", true},              // fields of franka::RobotState
        TorqueLog{"time,measured_joint_position_1,measured_torque_1", true},   // LBRState of FRI
        TorqueLog{"time,Joint position 1 [rad],torque_ref 1 [Nm]", false}}) {  // ABB's test signals
    const std::string log = log_of(std::string(of.names) + "\n", [](int k) {
      return fmt::format("{},{:.6f},{:.5f}", 10 * k, q_rad(k), 10 * current_A(k));
    });
    const joint::Dataset dataset = dataset_of(scratch, "log.csv", log, known());
    SCOPED_TRACE(of.names);
    EXPECT_EQ(dataset.manifest.drive.kind(),
              of.is_measured ? joint::EffortKind::joint_torque : joint::EffortKind::target_torque);
    const joint::Recording& r = dataset.recordings.at(0);
    ASSERT_EQ(r.t_s.size(), static_cast<std::size_t>(rows));
    for (int k = 0; k < rows; ++k) {
      const auto row = static_cast<std::size_t>(k);
      ASSERT_NEAR(r.t_s[row], t_s(k), 2e-6) << k;
      ASSERT_NEAR(r.q_rad[row], q_rad(k), 2e-6) << k;
      ASSERT_NEAR(r.torque_Nm[row], 10 * current_A(k) / gear_ratio, 2e-6) << k;
    }
  }
}

// Whose ratio is whose is known after a first look alone: a motor's 90 rad are no degrees, and what
// a joint behind a gear of five moves by is no motor's way.
TEST(LogDialects, AnglesOfMotorsGoByTheGearOfTheirJoint) {
  const test::ScratchDirectory scratch;
  const std::vector<double> ratios{100, 5};
  const std::string path = scratch.write(
      "log.csv", log_of("t_s,motor_position_1,motor_position_2,i_1_A,i_2_A\n", [&](int k) {
        return fmt::format("{:.2f},{:.5f},{:.5f},{:.5f},{:.5f}", t_s(k), ratios[0] * q_rad(k),
                           ratios[1] * q_rad(k), current_A(k), current_A(k));
      }));
  inspect::survey::ProposalOptions options;
  options.directory = scratch.path();
  inspect::survey::StatedJoints known_of{ratios, {0.1}};
  const std::vector<inspect::survey::LogSurvey> first{inspect::survey::survey_log(path)};
  known_of.joints = inspect::survey::joints_of_numbers(first, options, 2);
  ASSERT_EQ(known_of.joints, (std::vector<std::string>{"1", "2"}));
  EXPECT_TRUE(inspect::survey::joints_of_numbers(first, options, 3).empty());
  inspect::survey::StatedColumns stated;
  for (std::size_t k = 0; k < 2; ++k) stated.gear_ratio_of[known_of.joints[k]] = ratios[k];
  const auto robot = inspect::survey::propose_robot_manifest(
      {inspect::survey::survey_log(path, {}, stated)}, options, known_of);
  SCOPED_TRACE(robot.text);
  const std::string manifest = scratch.write("robot.toml", robot.text);
  for (std::size_t k = 0; k < 2; ++k) {
    const joint::Dataset dataset = ingest::dataset::read_dataset(manifest, known_of.joints[k]);
    expect_the_same(dataset, all_rows());
    EXPECT_EQ(dataset.manifest.drive.gear_ratio(), ratios[k]);
  }
}

TEST(LogDialects, OfTwoAnglesTheOneAtTheJointIsTaken) {
  const test::ScratchDirectory scratch;
  const std::string log = log_of("t_s,motor_position,position,i_A\n", [](int k) {
    return fmt::format("{:.2f},{:.5f}{}", t_s(k), 17 * q_rad(k), cells(k));
  });
  expect_the_same(dataset_of(scratch, "log.csv", log, known()), all_rows());
}

// EGM logs no torque: the motion is read.
TEST(LogDialects, AnEgmLogHasAMotionAndNoEffort) {
  const test::ScratchDirectory scratch;
  const std::string log = log_of("TIMESTAMP,R_FB_POS_RJ1,R_FB_POS_RJ2,R_PL_POS_RJ2\n", [](int k) {
    return fmt::format("{:.2f},5.7,{:.8f},0", t_s(k), 57.29577951 * q_rad(k));
  });
  const joint::Dataset dataset = dataset_of(scratch, "log.csv", log, known());
  EXPECT_EQ(dataset.manifest.joint, "2");
  EXPECT_EQ(dataset.manifest.drive.kind(), joint::EffortKind::none);
  const joint::Recording& r = dataset.recordings.at(0);
  ASSERT_EQ(r.q_rad.size(), static_cast<std::size_t>(rows));
  for (int k = 0; k < rows; ++k) {
    ASSERT_NEAR(r.q_rad[static_cast<std::size_t>(k)], q_rad(k), 2e-6);
  }
}

// A manifest names the joint's rows by what stands there, whether words or numbers.
TEST(LogDialects, RowsOfOtherJointsInJsonAreCounted) {
  const test::ScratchDirectory scratch;
  const std::string log = joined(
      "[",
      [](int k) {
        return fmt::format(
            "{{\"t_s\": {0:.2f}, \"joint\": 1, \"q_rad\": 0.1, \"i_A\": 1.5}},"
            "{{\"t_s\": {0:.2f}, \"joint\": 2, \"q_rad\": {1:.6f}, \"i_A\": {2:.5f}}}",
            t_s(k), q_rad(k), current_A(k));
      },
      "]");
  const joint::Dataset dataset = dataset_of(scratch, "log.json", log, known());
  EXPECT_EQ(dataset.manifest.joint, "2");
  const joint::Recording& r = dataset.recordings.at(0);
  EXPECT_EQ(r.rows_read, 2U * rows);
  ASSERT_EQ(r.skipped.size(), 1U);
  EXPECT_TRUE(r.skipped[0].reason.is("skipped.other_joint"));
  EXPECT_EQ(r.skipped[0].count, static_cast<std::size_t>(rows));
}

TEST(LogDialects, OfSeveralColumnsOfOneNameAnUnstatedOneLeavesTheEffortUnconfirmed) {
  const test::ScratchDirectory scratch;
  const std::string log = log_of(
      "t_s,q_rad,i_A,i_A\n", [](int k) { return fmt::format("{:.2f}{},0.25", t_s(k), cells(k)); });
  inspect::survey::ProposalOptions options = known();
  options.effort_side = joint::Side::motor;
  EXPECT_FALSE(dataset_of(scratch, "log.csv", log, options).manifest.effort_is_confirmed);
  options.columns.names = {{"effort", "#3"}};
  EXPECT_TRUE(dataset_of(scratch, "log.csv", log, options).manifest.effort_is_confirmed);
  const std::string angles = log_of("t_s,q_rad,i_A,q_rad\n", [](int k) {
    return fmt::format("{:.2f}{},0.25", t_s(k), cells(k));
  });
  options.columns.names.clear();
  EXPECT_FALSE(dataset_of(scratch, "log.csv", angles, options).manifest.effort_is_confirmed);
}

/// Two sweeps there and back, one behind the other, that are one motion but for what the log says.
std::string two_sweeps(const std::function<std::string(int)>& phase) {
  return log_of("t_s,q_rad,i_A,phase_name\n", [&](int k) {
    const int row = k % (rows / 2) * 2;
    return fmt::format("{:.2f}{},{}", t_s(k), cells(row), phase(k));
  });
}

TEST(LogDialects, PhasesThatALogNamesAreSegments) {
  const test::ScratchDirectory scratch;
  const auto dataset = dataset_of(
      scratch, "log.csv",
      two_sweeps([](int k) { return k < rows / 2 ? "warm up" : "measurement"; }), known());
  ASSERT_EQ(dataset.recordings.size(), 2U);
  EXPECT_NEAR(dataset.recordings[0].t_s.back(), 20, 0.02);
  EXPECT_NEAR(dataset.recordings[1].t_s.front(), 20, 0.02);
  // Parts of one motion, what begins within a stroke, and states that come again and again, are no
  // segments.
  for (const auto& phase : std::vector<std::function<std::string(int)>>{
           [](int k) { return k % 2000 < 1000 ? "forward" : "backward"; },
           [](int k) { return k < 1300 ? "start" : "run"; },
           [](int k) { return k / 300 % 2 == 0 ? "a" : "b"; }}) {
    EXPECT_EQ(dataset_of(scratch, "log.csv", two_sweeps(phase), known()).recordings.size(), 1U);
  }
}

// "1,250" is one and a quarter or more than a thousand.
TEST(LogDialects, NumbersThatMayHaveThousandsSeparatorsAreNotGuessed) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.write(
      "log.csv", log_of("t_s;q_rad\n", [](int k) { return fmt::format("{};1,250", k); }));
  const std::string said = test::refusal_of<InputError>([&] { return proposed(path, known()); });
  EXPECT_NE(said.find("column 'q_rad' is not read: '1,250' has a decimal comma, which "
                      "--decimal-comma states, or a separator of thousands"),
            std::string::npos)
      << said;
  inspect::survey::ProposalOptions options = known();
  options.log_rules.decimal_mark = ingest::text::DecimalMark::comma;
  EXPECT_EQ(inspect::survey::survey_log(path, options.log_rules).tables.at(0).columns.at(1).highest,
            1.25);
}

TEST(LogDialects, AStatedKindDoesNotConfirmAGuessedUnit) {
  const test::ScratchDirectory scratch;
  const std::string log =
      log_of("t_s,q_rad,torque\n", [](int k) { return fmt::format("{:.2f}{}", t_s(k), cells(k)); });
  inspect::survey::ProposalOptions options;
  options.effort_kind = joint::EffortKind::joint_torque;
  EXPECT_FALSE(dataset_of(scratch, "log.csv", log, options).manifest.effort_is_confirmed);
  options.columns.effort_unit = "mNm";
  const joint::Dataset dataset = dataset_of(scratch, "log.csv", log, options);
  EXPECT_TRUE(dataset.manifest.effort_is_confirmed);
  EXPECT_NEAR(dataset.recordings.at(0).torque_Nm.at(0), 1e-3 * current_A(0), 1e-8);
}

TEST(LogDialects, AnEffortThatWasNotUnderstoodIsNamedWithWhatToState) {
  const test::ScratchDirectory scratch;
  inspect::survey::ProposalOptions options = known();
  options.torque_constant_Nm_A.reset();
  const auto log = [](const char* name) {
    return log_of(fmt::format("t_s,q_rad,{}\n", name),
                  [](int k) { return fmt::format("{:.2f}{}", t_s(k), cells(k)); });
  };
  const std::string percent = scratch.write("percent.csv", log("torque_percent"));
  EXPECT_NE(proposed(percent, options).find("'torque_percent' looks like a torque"),
            std::string::npos);
  const std::string load = scratch.write("load.csv", log("load"));
  EXPECT_NE(proposed(load, options).find("not understood: 'load'"), std::string::npos);
  options.effort_kind = joint::EffortKind::motor_torque;
  options.columns.effort_unit = "0.02 Nm";
  const joint::Dataset dataset = dataset_of(scratch, "log.csv", log("torque_percent"), options);
  EXPECT_TRUE(dataset.manifest.effort_is_confirmed);
  EXPECT_NEAR(dataset.recordings.at(0).torque_Nm.at(0), 0.02 * current_A(0), 1e-6);
}

TEST(LogDialects, ADatasetWithoutATorqueNamesTheColumnsThatMayHoldOne) {
  const test::ScratchDirectory scratch;
  const auto notes = [&](const char* name) {
    const std::string log = log_of(fmt::format("t_s,q_rad,{},status\n", name), [](int k) {
      return fmt::format("{:.2f}{},1", t_s(k), cells(k));
    });
    inspect::survey::ProposalOptions options = known();
    options.torque_constant_Nm_A.reset();
    std::string said;
    for (const Statement& note : dataset_of(scratch, "log.csv", log, options).notes) {
      if (!note.is("reading.effort_not_read")) continue;
      said += std::get<std::string>(note.values().at(0).value);
    }
    return said;
  };
  EXPECT_EQ(notes("torque_percent"), "'torque_percent'");
  EXPECT_EQ(notes("Torque [%]"), "'Torque [%]'");
  EXPECT_EQ(notes("load"), "'load'");
  EXPECT_EQ(notes("humidity"), "");
  EXPECT_EQ(notes("torque_enable"), "");
}

TEST(LogDialects, InspectShowsTheEffortAsTheManifestHasIt) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.write("log.csv", log_of("t_s,q_rad,effort\n", [](int k) {
                                           return fmt::format("{:.2f}{}", t_s(k), cells(k));
                                         }));
  std::vector<inspect::survey::LogSurvey> logs{inspect::survey::survey_log(path)};
  inspect::survey::tell_effort(inspect::survey::propose_manifest(logs, known()), logs);
  const std::string text = inspect::survey::survey_text(logs);
  EXPECT_NE(text.find("current"), std::string::npos) << text;
  EXPECT_EQ(text.find("Nm?"), std::string::npos) << text;
}

}  // namespace
}  // namespace tribolog::log_dialects_test
