#include "ingest/dataset/recording_rows.h"

#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/text/csv_reader.h"
#include "wording/words.h"

namespace tribolog::recording_rows_test {
namespace {

ingest::manifest::RecordingEntry entry() {
  ingest::manifest::RecordingEntry e;
  e.role = joint::Role::rough_sweep;
  e.file = e.name = "run.csv";
  e.columns.time = ingest::manifest::ColumnEntry{
      "t", "s", ingest::log::Quantity::time, 1.0, joint::Side::joint, {"m.toml", 1, 1}};
  e.columns.angle = ingest::manifest::ColumnEntry{
      "q", "rad", ingest::log::Quantity::angle, 1.0, joint::Side::joint, {"m.toml", 2, 1}};
  e.columns.effort = ingest::manifest::ColumnEntry{
      "tau", "Nm", ingest::log::Quantity::torque, 1.0, joint::Side::joint, {"m.toml", 3, 1}};
  return e;
}

struct Outcome {
  joint::Recording recording;
  std::vector<std::string> notes;
};

Outcome make(const ingest::manifest::RecordingEntry& e, const std::string& csv,
             const joint::Drive& drive = joint::Drive(1.0, joint::EffortKind::motor_torque,
                                                      joint::Side::motor),
             double sign = 1.0) {
  Outcome outcome;
  MemorySource source(csv);
  const ingest::log::LogTable table =
      ingest::text::read_csv(source, "dir/run.csv", ingest::dataset::columns_wanted(e));
  ingest::dataset::refuse_unusable_columns(e, {}, "dir/run.csv", table);
  std::vector<Statement> notes;
  outcome.recording = ingest::dataset::make_recording(e, table, drive, sign, notes);
  outcome.notes = wording::words(notes);
  return outcome;
}

std::string refusal(const ingest::manifest::RecordingEntry& e, const std::string& csv) {
  return test::refusal_of<InputError>([&] { return make(e, csv); });
}

/// Rows t, q, tau at 100 Hz: q = i/1000, tau = i.
std::string rows(int from, int to) {
  std::string text;
  for (int i = from; i < to; ++i) text += fmt::format("{},{},{}\n", i / 100.0, i / 1000.0, i);
  return text;
}

const std::string header = "t,q,tau\n";

void expect_sum_rule(const joint::Recording& r) {
  std::size_t sum = r.size();
  for (const joint::SkippedRows& skipped : r.skipped) sum += skipped.count;
  EXPECT_EQ(r.rows_read, sum);
}

TEST(RecordingRows, KeepEveryNumberAsItIs) {
  const auto [r, notes] = make(entry(), header + rows(0, 100));
  ASSERT_EQ(r.size(), 100U);
  EXPECT_EQ(r.t_s[7], 0.07);
  EXPECT_EQ(r.q_rad[7], 0.007);
  EXPECT_EQ(r.torque_Nm[7], 7.0);
  EXPECT_TRUE(r.dq_rad_s.empty());
  EXPECT_TRUE(r.skipped.empty());
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(r.name, "run.csv");
}

TEST(RecordingRows, BecomeSiOnTheirStatedSides) {
  ingest::manifest::RecordingEntry e = entry();
  e.columns.angle->side = joint::Side::motor;
  e.columns.angle->unit = "deg";
  e.columns.angle->si_factor = std::numbers::pi / 180;
  e.columns.effort->quantity = ingest::log::Quantity::current;
  e.columns.bristle = ingest::manifest::ColumnEntry{
      "z", "mrad", ingest::log::Quantity::angle, 1e-3, joint::Side::joint, {}};
  std::string csv = "t,q,tau,z\n";
  for (int i = 0; i < 30; ++i) csv += fmt::format("{},{},{},{}\n", i / 100.0, 18000, 2, 5);
  // 18000 deg at the motor are 180 deg at the joint of a gear of 100; 2 A at 10 N·m/A at the joint
  // are 20 N·m there, 0.2 N·m at the motor, and the sign turns them round.
  const auto [r, notes] = make(
      e, csv, joint::Drive(100, joint::EffortKind::motor_current, joint::Side::joint, 10.0), -1.0);
  EXPECT_NEAR(r.q_rad[0], std::numbers::pi, 1e-15);
  EXPECT_NEAR(r.torque_Nm[0], -0.2, 1e-16);
  EXPECT_EQ(r.z_rad[0], 5e-3) << "bristles are on the motor side already";
}

TEST(RecordingRows, OutsideTheWindowAreCounted) {
  ingest::manifest::RecordingEntry e = entry();
  e.from_s = 0.1;
  e.to_s = 0.5;
  const auto [r, notes] = make(e, header + rows(0, 100));
  EXPECT_EQ(r.size(), 41U);
  EXPECT_EQ(r.t_s.front(), 0.1);
  EXPECT_EQ(r.t_s.back(), 0.5);
  ASSERT_EQ(r.skipped.size(), 1U);
  EXPECT_EQ(wording::words(r.skipped[0].reason), "outside the window 0.1..0.5 s");
  EXPECT_EQ(r.skipped[0].count, 59U);
  expect_sum_rule(r);
}

TEST(RecordingRows, WithGapsAreCountedByColumn) {
  const auto [r, notes] = make(
      entry(), header + rows(0, 30) + "0.3,nan,1\n0.31,,1\n0.32,1,nan\nnan,1,1\n" + rows(33, 50));
  EXPECT_EQ(r.size(), 47U);
  ASSERT_EQ(r.skipped.size(), 3U);
  EXPECT_EQ(wording::words(r.skipped[0].reason), "gap (nan) in column 't'");
  EXPECT_EQ(wording::words(r.skipped[1].reason), "gap (nan) in column 'q'");
  EXPECT_EQ(r.skipped[1].count, 2U);
  EXPECT_TRUE(notes.empty()) << "few gaps are no news";
  expect_sum_rule(r);
}

TEST(RecordingRows, ManyGapsAreNotedAndNothingButGapsIsRefused) {
  std::string csv = header;
  for (int i = 0; i < 100; ++i)
    csv += fmt::format("{},{},{}\n", i / 100.0, 0.1, i % 2 ? "nan" : "1");
  EXPECT_EQ(make(entry(), csv).notes.at(0),
            "run.csv: column 'tau': 50 % of the rows are gaps (nan)");
  csv = header;
  for (int i = 0; i < 100; ++i) csv += fmt::format("{},nan,1\n", i / 100.0);
  EXPECT_EQ(refusal(entry(), csv),
            "dir/run.csv: column 'q' holds no number, only gaps (empty or nan)");
}

TEST(RecordingRows, RepeatedTimeStampsKeepTheFirst) {
  const auto [r, notes] = make(entry(), header + rows(0, 50) + "0.49,9,9\n" + rows(50, 80));
  EXPECT_EQ(r.size(), 80U);
  EXPECT_EQ(r.torque_Nm[49], 49.0);
  ASSERT_EQ(r.skipped.size(), 1U);
  EXPECT_EQ(wording::words(r.skipped[0].reason), "repeated time stamp");
  expect_sum_rule(r);
}

TEST(RecordingRows, TooManyRepeatedTimeStampsAreRefused) {
  std::string csv = header;
  for (int i = 0; i < 100; ++i) csv += fmt::format("{},0,0\n", i / 2);
  EXPECT_EQ(
      refusal(entry(), csv),
      "dir/run.csv: column 't': 50 of 100 time stamps repeat an earlier one, expected no more "
      "than 5 %; hint: time column has too few digits?");
}

TEST(RecordingRows, SmallStepsBackArePutInOrder) {
  const auto [r, notes] =
      make(entry(), header + rows(0, 40) + "0.45,1,45\n" + rows(40, 45) + rows(46, 60));
  EXPECT_EQ(r.size(), 60U);
  for (std::size_t i = 0; i < r.size(); ++i) EXPECT_EQ(r.torque_Nm[i], static_cast<double>(i));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "run.csv: time runs backwards in 5 rows (first in line 43); sorted by time");
}

TEST(RecordingRows, LargeStepsBackAreRefusedEvenOutsideTheWindow) {
  ingest::manifest::RecordingEntry e = entry();
  e.to_s = 0.4;
  EXPECT_EQ(refusal(e, header + rows(0, 200) + rows(0, 200)),
            "dir/run.csv:202: time runs back by 1.99 s; hint: two logs concatenated? split the "
            "file, or correct the unit of time");
}

/// Two writers whose rows stand in blocks of 200: each block's begin lies two seconds back.
TEST(RecordingRows, OfTwoWritersAreSortedWhereTheyFitBetweenEachOther) {
  const auto block = [](int from, int every, int shift) {
    std::string text;
    for (int k = 0; k < 200; ++k) {
      const int i = from + every * k + shift;
      text += fmt::format("{},{},{}\n", i / 100.0, i / 1000.0, i);
    }
    return text;
  };
  std::string csv = header;
  for (const int from : {0, 400, 800, 1200, 1600}) csv += block(from, 2, 0) + block(from, 2, 1);
  const auto [r, notes] = make(entry(), csv);
  ASSERT_EQ(r.size(), 2000U);
  for (std::size_t i = 0; i < r.size(); ++i) {
    ASSERT_EQ(r.t_s[i], static_cast<double>(i) / 100.0) << i;
    ASSERT_EQ(r.torque_Nm[i], static_cast<double>(i)) << i;
  }
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes.front().find("sorted by time"), std::string::npos) << notes.front();
}

/// Two logs, one behind the other: that their rows would fit between each other is by chance.
TEST(RecordingRows, OfALogBehindAnotherAreNotSortedIntoIt) {
  for (const double shift_s : {0.0001, 0.003, 0.005, 0.0099}) {
    std::string twice = header;
    for (const double from_s : {0.0, shift_s}) {
      for (int i = 0; i < 1000; ++i) {
        twice += fmt::format("{:.4f},{},{}\n", i / 100.0 + from_s, i / 1000.0, i);
      }
    }
    const std::string refused = refusal(entry(), twice);
    EXPECT_NE(refused.find("run.csv:1002:"), std::string::npos) << refused;
    EXPECT_NE(refused.find(fmt::format("time runs back by {:.6g} s", 9.99 - shift_s)),
              std::string::npos)
        << refused;
  }
}

/// Logged at 100 Hz of a robot that sends 25 samples in a second.
TEST(RecordingRows, ThatRepeatTheRowBeforeAreUsedOnce) {
  std::string csv = header;
  for (int i = 0; i < 1000; ++i) {
    const int sample = i / 4;
    csv += fmt::format("{},{},{}\n", i / 100.0, sample / 100.0, sample + 0.5);
  }
  const auto [r, notes] = make(entry(), csv);
  ASSERT_EQ(r.size(), 250U);
  for (std::size_t k = 0; k < r.size(); ++k) {
    EXPECT_EQ(r.t_s[k], static_cast<double>(4 * k) / 100.0) << "the first row of each";
    EXPECT_EQ(r.q_rad[k], static_cast<double>(k) / 100.0);
  }
  expect_sum_rule(r);
  ASSERT_EQ(r.skipped.size(), 1U);
  EXPECT_TRUE(r.skipped.front().reason.is("skipped.held"));
  EXPECT_EQ(r.skipped.front().count, 750U);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes.front().find("75 % of the rows repeat the row before: the robot sends a sample "
                               "every 4 rows"),
            std::string::npos)
      << notes.front();
}

TEST(RecordingRows, OfACoarseEncoderBesideANoisyTorqueAreNoneThatRepeat) {
  std::string csv = header;
  for (int i = 0; i < 1000; ++i) {
    csv += fmt::format("{},{},{}\n", i / 100.0, (i / 4) / 100.0, (i * 37) % 101);
  }
  EXPECT_EQ(make(entry(), csv).recording.size(), 1000U);
}

TEST(RecordingRows, TooFewAreRefusedWithTheReasons) {
  ingest::manifest::RecordingEntry e = entry();
  e.from_s = 0.9;
  EXPECT_EQ(refusal(e, header + rows(0, 100)),
            "dir/run.csv: too few usable rows, found 10 of 100, expected at least 20; hint: left "
            "out: outside the window 0.9.. s: 90");
}

TEST(RecordingRows, ARowThatIsCutOffIsCounted) {
  const auto [r, notes] = make(entry(), header + rows(0, 30) + "0.3,0.0");
  EXPECT_EQ(r.rows_read, 31U);
  EXPECT_EQ(wording::words(r.skipped.at(0).reason), "cut off at the end of the file");
  EXPECT_EQ(notes.size(), 1U);
  expect_sum_rule(r);
}

TEST(RecordingRows, ImplausibleUnitsAreNotedNeverConverted) {
  std::string csv = header;
  for (int i = 0; i < 50; ++i) csv += fmt::format("{},{},{}\n", i / 8.0, 2 * i - 90, 5000 * i);
  const auto [r, notes] = make(entry(), csv);
  EXPECT_EQ(r.q_rad[0], -90.0);
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0], "run.csv: the joint's angle reaches 90 rad, read as rad: degrees?");
  EXPECT_EQ(
      notes[1],
      "run.csv: the joint's torque reaches 245000 N·m, read as Nm: another unit, or the other "
      "side of the gear?");
  EXPECT_EQ(notes[2], "run.csv: 8 samples per second, read in s: another unit of time?");
}

/// A log of so many samples a second, by the clock of the manifest.
std::string log_of_rate(double rate_Hz) {
  std::string csv = header;
  for (int i = 0; i < 50; ++i) csv += fmt::format("{},0.1,{}\n", i / rate_Hz, i);
  return csv;
}

TEST(RecordingRows, OfARateThatNoLogHasAreRefusedWithLikelierUnits) {
  EXPECT_EQ(refusal(entry(), log_of_rate(0.1)),
            "dir/run.csv: column 't': 0.1 samples per second, read in s, expected 5 to 100000; "
            "hint: another unit of time? in ms they would be 100; if this is right, state any_rate "
            "= true beside the unit");
  EXPECT_EQ(refusal(entry(), log_of_rate(2e5)),
            "dir/run.csv: column 't': 2e+05 samples per second, read in s, expected 5 to 100000; "
            "hint: another unit of time? if this is right, state any_rate = true beside the unit");
  ingest::manifest::RecordingEntry ms = entry();
  ms.columns.time->unit = "ms";
  ms.columns.time->si_factor = 1e-3;
  EXPECT_NE(refusal(ms, log_of_rate(1e3)).find("in s they would be 1e+03;"), std::string::npos);
  ms.columns.time->any_rate = true;
  EXPECT_EQ(make(ms, log_of_rate(1e3)).recording.size(), 50U);
  EXPECT_TRUE(make(entry(), log_of_rate(12)).notes.empty());
}

TEST(RecordingRows, OfALoopShouldBeMany) {
  ingest::manifest::RecordingEntry e = entry();
  e.role = joint::Role::oscillation;
  EXPECT_EQ(
      make(e, log_of_rate(20)).notes,
      std::vector<std::string>{
          "run.csv: 20 samples per second are few to resolve a reversal; log at 100 or more"});
  EXPECT_TRUE(make(e, log_of_rate(66)).notes.empty());
}

TEST(RecordingRows, AHeaderThatContradictsTheManifestIsRefused) {
  EXPECT_EQ(refusal(entry(), "t [s],q [deg],tau [Nm]\n" + rows(0, 30)),
            "m.toml:2:1: unit contradicts the header of the log, found 'rad', expected 'deg' as in "
            "'q [deg]'");
  EXPECT_EQ(make(entry(), "t [s],q [rad],tau [N m]\n" + rows(0, 30)).recording.size(), 30U);
}

TEST(RecordingRows, WithoutEffortNothingCanBeIdentified) {
  EXPECT_EQ(refusal(entry(), "t,q,u_motor_V,tau_Nm\n0,0,0,0\n"),
            "dir/run.csv:1: column 'tau' is missing, found 't', 'q', 'u_motor_V', 'tau_Nm'; hint: "
            "did you mean 'tau_Nm'? without torque or current nothing can be identified");
}

TEST(RecordingRows, OfAnEncoderThatWrapsRoundGoOn) {
  std::string csv = header;
  for (int i = 0; i < 100; ++i) {
    const double q = 3.0 + 0.01 * i;
    csv += fmt::format("{},{},1\n", i / 100.0, q > std::numbers::pi ? q - 2 * std::numbers::pi : q);
  }
  const auto made = make(entry(), csv);
  EXPECT_EQ(made.notes,
            std::vector<std::string>{"run.csv: the angle wraps round 1 time, at 0.15 s, by 6.28319 "
                                     "rad: it is read as going on there"});
  for (std::size_t i = 0; i < made.recording.size(); ++i) {
    EXPECT_NEAR(made.recording.q_rad[i], 3.0 + 0.01 * static_cast<double>(i), 1e-12);
  }
  // In a window behind the jump too.
  ingest::manifest::RecordingEntry late = entry();
  late.from_s = 0.5;
  EXPECT_NEAR(make(late, csv).recording.q_rad.front(), 3.5, 1e-12);
  // A motor that turns once a sample does not wrap.
  ingest::manifest::RecordingEntry e = entry();
  e.columns.angle->side = joint::Side::motor;
  csv = header;
  for (int i = 0; i < 100; ++i) csv += fmt::format("{},{},1\n", i / 100.0, 6.28 * i);
  EXPECT_TRUE(make(e, csv, joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor))
                  .notes.empty());
}

TEST(RecordingRows, ANumberThatNoJointHasIsRefused) {
  ingest::manifest::RecordingEntry e = entry();
  EXPECT_EQ(refusal(e, header + rows(0, 30) + "0.3,0,1e300\n" + rows(31, 40)),
            "dir/run.csv:32: column 'tau': no joint has a torque of this size, found 1e+300 Nm, "
            "expected at most 1e+07 Nm; hint: another unit? where only this row is damaged, write "
            "nan, or [log] skip_bad_rows = true leaves it out, up to 1 % of all");
  e.columns.effort->si_factor = 1e3;
  e.columns.effort->unit = "kNm";
  EXPECT_EQ(refusal(e, header + rows(0, 30) + "0.3,0,-1e307\n" + rows(31, 40)),
            "dir/run.csv:32: column 'tau': no joint has a torque of this size, found -1e+307 kNm, "
            "expected at most 10000 kNm; hint: another unit? where only this row is damaged, write "
            "nan, or [log] skip_bad_rows = true leaves it out, up to 1 % of all");
}

TEST(RecordingRows, SingleNumbersThatNoJointHasCanBeMadeGaps) {
  const ingest::manifest::RecordingEntry e = entry();
  const auto mended_of = [&](const std::string& csv) {
    MemorySource source(csv);
    return ingest::dataset::without_impossible_values(
        e, ingest::text::read_csv(source, "run.csv", ingest::dataset::columns_wanted(e)));
  };
  EXPECT_FALSE(mended_of(header + rows(0, 100)));
  const auto mended = mended_of(header + rows(0, 100) + "1,0,1e300\n" + rows(101, 200));
  ASSERT_TRUE(mended);
  std::vector<Statement> notes;
  const joint::Recording r = ingest::dataset::make_recording(
      e, *mended, joint::Drive(1.0, joint::EffortKind::motor_torque, joint::Side::motor), 1.0,
      notes);
  EXPECT_EQ(r.size(), 199U);
  ASSERT_EQ(r.skipped.size(), 1U);
  EXPECT_EQ(r.skipped[0].count, 1U);
  EXPECT_EQ(wording::words(r.skipped[0].reason), "a number that no joint has in column 'tau'");
  EXPECT_THROW(mended_of(header + rows(0, 50) + "0.5,0,1e300\n" + rows(51, 80)), InputError)
      << "more than one in a hundred: another unit";
}

TEST(RecordingRows, ThatWereSkippedAreCounted) {
  ingest::text::TextLogRules rules;
  rules.skip_bad_rows = true;
  const std::string csv = header + rows(0, 100) + "1,fault\n" + rows(101, 200);
  MemorySource source(csv);
  const ingest::log::LogTable table =
      ingest::text::read_csv(source, "run.csv", ingest::dataset::columns_wanted(entry()), rules);
  std::vector<Statement> notes;
  const joint::Recording r = ingest::dataset::make_recording(
      entry(), table, joint::Drive(1.0, joint::EffortKind::motor_torque, joint::Side::motor), 1.0,
      notes);
  EXPECT_EQ(r.size(), 199U);
  ASSERT_EQ(r.skipped.size(), 1U);
  EXPECT_EQ(wording::words(r.skipped[0].reason), "cannot be used (skip_bad_rows)");
  expect_sum_rule(r);
}

}  // namespace
}  // namespace tribolog::recording_rows_test
