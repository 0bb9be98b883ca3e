// Units that a log does not state: found where its numbers leave no other, else marked as guesses.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/requirements.h"
#include "ingest/log/units.h"
#include "ingest/manifest/manifest_file.h"
#include "inspect/survey/manifest_proposal.h"
#include "support/run_program.h"

namespace tribolog::unit_evidence_test {
namespace {

using ingest::log::Quantity;
using std::numbers::pi;

double factor_of(Quantity quantity, const std::string& unit) {
  return present(ingest::log::find_si_factor(quantity, unit));
}

struct Units {
  std::string angle{"rad"};
  std::string speed{"rad/s"};
  std::string time{"s"};
};

struct Stated {
  bool angle{};
  bool speed{};
  bool time{};
};

/// A slow sine in these units, with the units that are stated in brackets.
std::string log_in(const Units& units, const Stated& stated, double step_s = 0.01) {
  const auto header = [](const char* name, const std::string& unit, bool is_stated) {
    return is_stated ? fmt::format("{} [{}]", name, unit) : std::string(name);
  };
  std::string csv = header("time", units.time, stated.time) + "," +
                    header("pos", units.angle, stated.angle) + "," +
                    header("vel", units.speed, stated.speed) + ",tau [Nm]\n";
  for (int i = 0; i < 4000; ++i) {
    const double phase = 8 * pi * i / 4000;
    const double speed_rad_s = 8 * pi / (4000 * step_s) * std::cos(phase);
    csv += fmt::format("{:.12g},{:.12g},{:.12g},{:.4f}\n",
                       step_s * i / factor_of(Quantity::time, units.time),
                       std::sin(phase) / factor_of(Quantity::angle, units.angle),
                       speed_rad_s / factor_of(Quantity::angular_speed, units.speed),
                       3 * std::cos(std::sin(phase)) + std::copysign(0.5, speed_rad_s));
  }
  return csv;
}

struct FoundUnits {
  inspect::survey::ColumnSurvey angle;
  inspect::survey::ColumnSurvey speed;
  inspect::survey::ClockSurvey clock;
};

FoundUnits found_in(const std::string& csv, const inspect::survey::StatedColumns& stated = {}) {
  const test::ScratchDirectory scratch;
  const inspect::survey::LogSurvey log =
      inspect::survey::survey_log(scratch.write("log.csv", csv), {}, stated);
  const inspect::survey::TableSurvey& table = log.tables.at(0);
  return {table.columns.at(1), table.columns.at(2), present(table.clock)};
}

const std::array<std::string, 4> angle_units{"rad", "deg", "turn", "mrad"};
const std::array<std::string, 5> speed_units{"rad/s", "deg/s", "rpm", "turn/s", "mrad/s"};

std::string pair_of(const std::string& a, const std::string& b) { return a + " and " + b; }

TEST(UnitEvidence, OfAStatedAngleTheSpeedsUnitFollows) {
  for (const std::string& angle : angle_units) {
    for (const std::string& speed : speed_units) {
      const FoundUnits found = found_in(log_in({angle, speed}, {true, false, true}));
      EXPECT_EQ(found.speed.meaning->unit, speed) << pair_of(angle, speed);
      EXPECT_TRUE(found.speed.unit_is_proven) << pair_of(angle, speed);
      EXPECT_EQ(found.angle.meaning->unit, angle);
    }
  }
}

TEST(UnitEvidence, OfAStatedSpeedTheAnglesUnitFollows) {
  for (const std::string& angle : angle_units) {
    for (const std::string& speed : speed_units) {
      const FoundUnits found = found_in(log_in({angle, speed}, {false, true, true}));
      EXPECT_EQ(found.angle.meaning->unit, angle) << pair_of(angle, speed);
      EXPECT_TRUE(found.angle.is_certain()) << pair_of(angle, speed);
    }
  }
  const FoundUnits counts = found_in(log_in({"0.000244140625 turn", "rpm"}, {false, true, true}));
  EXPECT_NEAR(factor_of(Quantity::angle, counts.angle.meaning->unit), 2 * pi / 4096, 1e-9)
      << counts.angle.meaning->unit;
  EXPECT_TRUE(counts.angle.unit_is_proven);
  const FoundUnits odd = found_in(log_in({"0.0003 rad", "rpm"}, {false, true, true}));
  EXPECT_FALSE(odd.angle.unit_is_proven) << "no encoder has so many counts";
}

/// German for degrees; a 400th of a turn elsewhere.
TEST(UnitEvidence, GradIsProposedAsDegreesUnlessItIsProven) {
  const auto log = [](const std::string& angle_in, const Units& written, const Stated& stated) {
    std::string csv = log_in({angle_in, written.speed}, {false, stated.speed, true});
    return csv.replace(csv.find("pos"), 3, "pos [" + written.angle + "]");
  };
  for (const char* const written : {"Grad", "grad"}) {
    const FoundUnits alone = found_in(log("deg", {written, "deg/s"}, {}));
    EXPECT_EQ(alone.angle.meaning->unit, "deg");
    EXPECT_FALSE(alone.angle.is_certain());
    const FoundUnits degrees = found_in(log("deg", {written, "rad/s"}, {false, true}));
    EXPECT_EQ(degrees.angle.meaning->unit, "deg");
    EXPECT_TRUE(degrees.angle.is_certain());
    const FoundUnits gon = found_in(log("0.9 deg", {written, "rad/s"}, {false, true}));
    EXPECT_NEAR(factor_of(Quantity::angle, gon.angle.meaning->unit), 2 * pi / 400, 1e-9);
    EXPECT_TRUE(gon.angle.is_certain());
    inspect::survey::StatedColumns stated;
    stated.angle_unit = "deg";
    EXPECT_TRUE(found_in(log("deg", {written, "deg/s"}, {}), stated).angle.is_certain());
  }
}

TEST(UnitEvidence, OfTwoUnitsThatAreNotEqualTheRatioTellsBoth) {
  for (const char* const angle : {"rad", "deg", "turn"}) {
    for (const char* const speed : {"rad/s", "deg/s", "rpm", "turn/s"}) {
      const FoundUnits found = found_in(log_in({angle, speed}, {false, false, true}));
      const bool are_equal = speed == std::string(angle) + "/s";
      EXPECT_EQ(found.angle.unit_is_proven, !are_equal) << pair_of(angle, speed);
      EXPECT_EQ(found.speed.unit_is_proven, !are_equal) << pair_of(angle, speed);
      EXPECT_FALSE(found.angle.is_certain() && are_equal) << pair_of(angle, speed);
      if (are_equal) continue;
      EXPECT_EQ(found.angle.meaning->unit, angle) << pair_of(angle, speed);
      EXPECT_EQ(found.speed.meaning->unit, speed) << pair_of(angle, speed);
    }
  }
}

TEST(UnitEvidence, ASpeedThatCountsTheOtherWayTellsTheSame) {
  std::string csv = "time [s],pos,vel,tau [Nm]\n";
  for (int i = 0; i < 4000; ++i) {
    const double phase = 8 * pi * i / 4000;
    csv += fmt::format("{:.2f},{:.8g},{:.8g},3\n", 0.01 * i, std::sin(phase) * 180 / pi,
                       -8 * pi / 40 * std::cos(phase));
  }
  const FoundUnits found = found_in(csv);
  EXPECT_EQ(found.angle.meaning->unit, "deg");
  EXPECT_TRUE(found.angle.unit_is_proven);
  EXPECT_EQ(found.speed.meaning->unit, "rad/s");
  EXPECT_TRUE(found.speed.unit_is_proven);
}

TEST(UnitEvidence, OfStatedAngleAndSpeedTheClocksTicksFollow) {
  for (const char* tick :
       {"s", "ms", "us", "ns", "min", "h", "100 ns", "10 us", "100 us", "0.5 ms", "2 ms", "4 ms",
        "5 ms", "8 ms", "10 ms", "0.125 ms", "0.25 ms", "0.0009765625 s"}) {
    const FoundUnits found = found_in(log_in({"deg", "deg/s", tick}, {true, true, false}, 0.04));
    EXPECT_TRUE(found.clock.is_proven) << tick;
    EXPECT_FALSE(found.clock.unit_is_stated) << tick;
    EXPECT_EQ(found.clock.unit, tick);
    EXPECT_NEAR(found.clock.rate_Hz(), 25, 0.3) << tick;
  }
}

TEST(UnitEvidence, TellsAThousandthFromA1024thOfASecond) {
  const Units ticks{"deg", "deg/s", "0.0009765625 s"};
  EXPECT_EQ(found_in(log_in(ticks, {true, true, false})).clock.unit, "0.0009765625 s");
  EXPECT_EQ(found_in(log_in({"deg", "deg/s", "ms"}, {true, true, false})).clock.unit, "ms");
  // With one unit stated the ratio tells the other, but is not as exact as a clock has to be.
  const FoundUnits found = found_in(log_in(ticks, {true, false, false}));
  EXPECT_EQ(found.speed.meaning->unit, "deg/s");
  EXPECT_FALSE(found.clock.is_proven) << found.clock.unit_by;
  EXPECT_TRUE(found_in(log_in({"deg", "deg/s", "ms"}, {true, false, false})).clock.is_proven);
}

TEST(UnitEvidence, AClockOfNoUsualTicksIsNotProven) {
  const FoundUnits found = found_in(log_in({"deg", "deg/s", "1.37 ms"}, {true, true, false}));
  EXPECT_FALSE(found.clock.is_certain());
  EXPECT_EQ(found.angle.meaning->unit, "deg");
}

TEST(UnitEvidence, OfNothingStatedAndEqualUnitsTheClockAloneIsProven) {
  const FoundUnits found = found_in(log_in({}, {}));
  EXPECT_TRUE(found.clock.is_proven);
  EXPECT_FALSE(found.angle.is_certain());
  EXPECT_FALSE(found.speed.is_certain());
}

// What a manifest says of it.

ingest::manifest::ColumnEntries proposed_columns(
    const std::string& csv, const inspect::survey::StatedColumns& stated = {}) {
  const test::ScratchDirectory scratch;
  inspect::survey::ProposalOptions options;
  options.directory = scratch.path();
  options.columns = stated;
  options.gear_ratio = stated.gear_ratio;
  const std::string text =
      inspect::survey::propose_manifest(
          {inspect::survey::survey_log(scratch.write("log.csv", csv), {}, stated)}, options)
          .text;
  SCOPED_TRACE(text);
  return ingest::manifest::parse_manifest(text, "m.toml").recordings.at(0).columns;
}

TEST(UnitEvidence, WhatNothingProvesIsWrittenAsNotConfirmed) {
  const auto guessed = proposed_columns(log_in({}, {}));
  EXPECT_TRUE(guessed.angle->is_proposed);
  EXPECT_FALSE(guessed.time->is_proposed) << "its speed proves the clock";
  const auto proven = proposed_columns(log_in({"deg", "rpm"}, {}));
  EXPECT_FALSE(proven.angle->is_proposed);
  EXPECT_EQ(proven.angle->unit, "deg");
  inspect::survey::StatedColumns stated;
  stated.angle_unit = "0.001 rad";
  const auto by_user = proposed_columns(log_in({"mrad", "mrad/s"}, {}), stated);
  EXPECT_FALSE(by_user.angle->is_proposed);
  EXPECT_EQ(by_user.angle->unit, "0.001 rad");
}

TEST(UnitEvidence, AClockWithoutASpeedIsWrittenAsNotConfirmedUnlessItIsStated) {
  std::string csv = "time,q [rad],tau [Nm]\n";
  for (int i = 0; i < 4000; ++i) {
    const double q = i < 2000 ? -0.9 + 9e-4 * i : 0.9 - 9e-4 * (i - 2000);
    csv += fmt::format("{},{:.5f},{:.4f}\n", 10 * i, q, 3 * std::cos(q) + (i < 2000 ? 0.5 : -0.5));
  }
  const auto guessed = proposed_columns(csv);
  EXPECT_TRUE(guessed.time->is_proposed);
  EXPECT_EQ(guessed.time->unit, "ms");
  EXPECT_FALSE(guessed.angle->is_proposed);
  inspect::survey::StatedColumns stated;
  stated.time_unit = "0.5 ms";
  const auto by_user = proposed_columns(csv, stated);
  EXPECT_FALSE(by_user.time->is_proposed);
  EXPECT_EQ(by_user.time->unit, "0.5 ms");
}

TEST(UnitEvidence, AnAngleOfManyTurnsBesideAGearMayBeTheMotors) {
  std::string csv = "time [s],q [rad],tau [Nm]\n";
  for (int i = 0; i < 4000; ++i) {
    const double q = i < 2000 ? -20 + 0.02 * i : 20 - 0.02 * (i - 2000);
    csv += fmt::format("{:.2f},{:.5f},{:.4f}\n", 0.01 * i, q,
                       3 * std::cos(q / 50) + (i < 2000 ? 0.5 : -0.5));
  }
  inspect::survey::StatedColumns stated;
  stated.gear_ratio = 50;
  EXPECT_TRUE(proposed_columns(csv, stated).angle->is_proposed);
  for (const joint::Side side : {joint::Side::motor, joint::Side::joint}) {
    stated.angle_side = side;
    const auto columns = proposed_columns(csv, stated);
    EXPECT_FALSE(columns.angle->is_proposed);
    EXPECT_EQ(columns.angle->side, side);
  }
}

TEST(UnitEvidence, OptionsTakeUnitsOfTheirQuantityAlone) {
  EXPECT_EQ(inspect::survey::parse_unit("--angle-unit", "0.088 deg", {Quantity::angle}),
            "0.088 deg");
  for (const char* text : {"rpm", "Nm", "", "0 deg", "deg deg"}) {
    EXPECT_THROW((void)inspect::survey::parse_unit("--angle-unit", text, {Quantity::angle}),
                 UsageError)
        << text;
  }
}

// A stated column is one of a joint that its name tells by a number.

TEST(StatedColumns, AreOfTheJointWhoseNumberTheirNameHolds) {
  std::string csv = "t_s,q_1_rad,q_2_rad,tau_1_Nm,A2\n";
  for (int i = 0; i < 4000; ++i) {
    const double q = i < 2000 ? -0.9 + 9e-4 * i : 0.9 - 9e-4 * (i - 2000);
    csv += fmt::format("{:.2f},{:.5f},{:.5f},0,{:.4f}\n", 0.01 * i, 0.3 * q, q,
                       3 * std::cos(q) + (i < 2000 ? 0.5 : -0.5));
  }
  inspect::survey::StatedColumns stated;
  stated.names = {{"effort", "A2"}};
  const auto columns = proposed_columns(csv, stated);
  EXPECT_EQ(columns.angle->name, "q_2_rad");
  ASSERT_TRUE(columns.effort);
  EXPECT_EQ(columns.effort->name, "A2");
}

}  // namespace
}  // namespace tribolog::unit_evidence_test
