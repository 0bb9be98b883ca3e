// A proposed manifest is one that the reader takes, but for what only the user knows.

#include "inspect/survey/manifest_proposal.h"

#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "ingest/dataset/dataset_file.h"
#include "ingest/manifest/manifest_file.h"
#include "support/run_program.h"

namespace tribolog::manifest_proposal_test {
namespace {

/// A sweep there and back, in columns of these names; angle in degrees, clock in milliseconds.
std::string sweep(const std::string& header) {
  std::string csv = header + "\n";
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    const double q = t < 20 ? -50 + 5 * t : 50 - 5 * (t - 20);
    csv += fmt::format("{},{:.4f},{:.4f}\n", 10 * i, q,
                       3 * std::cos(q / 57.29578) + (t < 20 ? 0.5 : -0.5));
  }
  return csv;
}

inspect::survey::ManifestProposal propose(const test::ScratchDirectory& scratch,
                                          const std::string& log,
                                          inspect::survey::ProposalOptions options = {}) {
  options.directory = scratch.path();
  return inspect::survey::propose_manifest(
      {inspect::survey::survey_log(log, options.log_rules, options.columns)}, options);
}

joint::Manifest proposed_manifest(const test::ScratchDirectory& scratch, const std::string& log,
                                  const inspect::survey::ProposalOptions& options) {
  return ingest::manifest::parse_manifest(propose(scratch, log, options).text, "m.toml").manifest;
}

TEST(ManifestProposal, IsReadByTheReader) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("a log.csv", sweep("time_ms,q_deg,tau_Nm"));
  const inspect::survey::ManifestProposal proposal = propose(scratch, log);
  const joint::Dataset dataset =
      ingest::dataset::read_dataset(scratch.write("dataset.toml", proposal.text));
  ASSERT_EQ(dataset.recordings.size(), 1U);
  EXPECT_EQ(dataset.recordings[0].role, joint::Role::rough_sweep);
  EXPECT_EQ(dataset.recordings[0].name, "a log.csv") << "relative to the manifest";
  EXPECT_NEAR(dataset.recordings[0].t_s.back(), 39.99, 0.01);
  EXPECT_FALSE(dataset.manifest.effort_is_confirmed) << "nobody stated what the torque is";
}

TEST(ManifestProposal, OfTwoCoupledJointsTheDrivenOneIsMeant) {
  const test::ScratchDirectory scratch;
  std::string csv = "t_s,q_1_rad,q_2_rad,tau_1_Nm,tau_2_Nm\n";
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    const double q = t < 20 ? -1 + 0.1 * t : 1 - 0.1 * (t - 20);
    // The second turns with the first, and a little more in the log.
    csv += fmt::format("{},{:.4f},{:.4f},{:.4f},{}\n", t, q, -1.001 * q,
                       3 * std::cos(q) + (t < 20 ? 0.5 : -0.5), i % 2 == 0 ? 0.001 : -0.001);
  }
  const auto proposal = propose(scratch, scratch.write("log.csv", csv));
  EXPECT_EQ(proposal.joint, "1");
  EXPECT_EQ(proposal.moves_too, std::vector<std::string>{"2"});
}

TEST(ManifestProposal, LeavesTheTorqueConstantToTheUser) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,q_deg,i_motor_A"));
  const inspect::survey::ManifestProposal proposal = propose(scratch, log);
  try {
    (void)ingest::manifest::read_manifest(scratch.write("dataset.toml", proposal.text));
    FAIL() << "a current without a torque constant was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("torque_constant_Nm_A"), std::string::npos);
  }
  EXPECT_EQ(proposal.text.find("= 0\n"), std::string::npos) << "no number for what is not known";
  inspect::survey::ProposalOptions options;
  options.torque_constant_Nm_A = 0.35;
  options.gear_ratio = 100;
  options.robot = "a \"robot\"\n";
  const ingest::manifest::ManifestFile manifest =
      ingest::manifest::parse_manifest(propose(scratch, log, options).text, "m.toml");
  EXPECT_EQ(manifest.manifest.drive.torque_constant_Nm_A(), 0.35);
  EXPECT_EQ(manifest.manifest.drive.gear_ratio(), 100);
  EXPECT_EQ(manifest.manifest.drive.side(), joint::Side::motor);
  EXPECT_EQ(manifest.manifest.robot, "a \"robot\"\n");
}

// A driver's "effort" may be a torque or a current: who knows a torque constant knows which.
TEST(ManifestProposal, AnEffortOfUnknownKindWithATorqueConstantIsACurrent) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,q_deg,effort"));
  inspect::survey::ProposalOptions options;
  EXPECT_EQ(proposed_manifest(scratch, log, options).drive.kind(), joint::EffortKind::joint_torque);
  EXPECT_FALSE(proposed_manifest(scratch, log, options).effort_is_confirmed);
  options.torque_constant_Nm_A = 0.35;
  options.gear_ratio = 100;
  options.effort_side = joint::Side::motor;
  const joint::Manifest manifest = proposed_manifest(scratch, log, options);
  EXPECT_EQ(manifest.drive.kind(), joint::EffortKind::motor_current);
  EXPECT_EQ(manifest.drive.torque_constant_Nm_A(), 0.35);
  EXPECT_TRUE(manifest.effort_is_confirmed);
  options.effort_side.reset();
  // A torque that is one stays one, and what is called one, even without a unit.
  for (const char* name : {"tau_Nm", "tau", "joint_torque", "moment", "drehmoment"}) {
    const std::string torque =
        scratch.write("torque.csv", sweep(fmt::format("time_ms,q_deg,{}", name)));
    EXPECT_EQ(proposed_manifest(scratch, torque, options).drive.kind(),
              joint::EffortKind::joint_torque)
        << name;
    const std::string text = propose(scratch, torque, options).text;
    EXPECT_NE(text.find("It is called a torque: the torque constant of 0.35"), std::string::npos)
        << text;
  }
}

TEST(ManifestProposal, AStatedKindIsConfirmedUnlessTheLogContradicts) {
  const test::ScratchDirectory scratch;
  inspect::survey::ProposalOptions options;
  options.effort_kind = joint::EffortKind::motor_torque;
  const std::string torque = scratch.write("torque.csv", sweep("time_ms,q_deg,tau_Nm"));
  const joint::Manifest manifest = proposed_manifest(scratch, torque, options);
  EXPECT_EQ(manifest.drive.kind(), joint::EffortKind::motor_torque);
  EXPECT_EQ(manifest.drive.side(), joint::Side::motor);
  EXPECT_TRUE(manifest.effort_is_confirmed);
  const std::string current = scratch.write("current.csv", sweep("time_ms,q_deg,i_motor_A"));
  EXPECT_THROW((void)propose(scratch, current, options), UsageError);
  options.effort_kind = joint::EffortKind::motor_current;
  EXPECT_THROW((void)propose(scratch, torque, options), UsageError);
}

TEST(ManifestProposal, SaysWhoMeasuredWhatAndWhen) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,q_deg,tau_Nm"));
  inspect::survey::ProposalOptions options;
  options.serial = "R-1";
  options.operator_name = "J. Nowak";
  options.measured_on = "2026-11-26";
  options.temperature_C = 31.5;
  options.payload_kg = 2;
  const joint::Manifest manifest = proposed_manifest(scratch, log, options);
  EXPECT_EQ(manifest.serial, "R-1");
  EXPECT_EQ(manifest.operator_name, "J. Nowak");
  EXPECT_EQ(manifest.measured_on, "2026-11-26");
  EXPECT_EQ(manifest.temperature_C, 31.5);
  EXPECT_EQ(manifest.payload_kg, 2);
  options.measured_on = "2026-13-45";
  EXPECT_THROW((void)propose(scratch, log, options), UsageError);
  options.measured_on.reset();
  options.serial = " ";
  EXPECT_THROW((void)propose(scratch, log, options), UsageError);
}

TEST(ManifestProposal, StatedColumnsStandBeforeNames) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("a,b,c"));
  inspect::survey::ProposalOptions options;
  options.columns.names = {{"time", "a"}, {"angle", "#2"}, {"effort", "c"}};
  options.columns.angle_unit = "deg";
  const ingest::manifest::ManifestFile manifest =
      ingest::manifest::parse_manifest(propose(scratch, log, options).text, "m.toml");
  const ingest::manifest::ColumnEntries& columns = manifest.recordings.front().columns;
  EXPECT_EQ(columns.angle->name, "b");
  EXPECT_EQ(columns.angle->unit, "deg");
  EXPECT_EQ(columns.effort->name, "c");
  EXPECT_EQ(columns.time->unit, "ms") << "by the magnitude of its steps";
  options.columns.names = {{"angle", "nope"}};
  EXPECT_THROW((void)propose(scratch, log, options), InputError);
  // Of several angles the stated one is meant, with the effort that is stated beside it.
  const std::string two = scratch.write("two.csv", sweep("time_ms,q1_deg,q2_deg"));
  options.columns.names = {{"angle", "q1_deg"}, {"effort", "q2_deg"}};
  const inspect::survey::ManifestProposal proposal = propose(scratch, two, options);
  EXPECT_EQ(proposal.joint, "1");
  EXPECT_TRUE(proposal.moves_too.empty());
}

TEST(ManifestProposal, AStatedColumnKeepsTheUnitOfItsName) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,joint_deg,motor_current_mA"));
  inspect::survey::ProposalOptions options;
  options.columns.names = {{"angle", "joint_deg"}, {"effort", "motor_current_mA"}};
  options.torque_constant_Nm_A = 0.35;
  options.gear_ratio = 100;
  const ingest::manifest::ManifestFile manifest =
      ingest::manifest::parse_manifest(propose(scratch, log, options).text, "m.toml");
  const ingest::manifest::ColumnEntries& columns = manifest.recordings.front().columns;
  EXPECT_EQ(columns.angle->unit, "deg");
  EXPECT_EQ(columns.effort->unit, "mA");
  // Its name holds no joint, but a unit that none knows.
  const std::string percent = scratch.write("percent.csv", sweep("time_ms,q_deg,torque_percent"));
  options.columns.names = {{"effort", "torque_percent"}};
  options.torque_constant_Nm_A.reset();
  const std::string text = propose(scratch, percent, options).text;
  EXPECT_NE(text.find("effort = { name = \"torque_percent\""), std::string::npos) << text;
  EXPECT_NE(text.find("confirmed = false"), std::string::npos) << text;
}

TEST(ManifestProposal, APlaceCountsTheFilesColumns) {
  const test::ScratchDirectory scratch;
  std::string rows = "phase,time_ms,q_deg,tau_Nm,tau2_Nm\n";
  std::istringstream numbers(sweep("a,b,c"));
  std::string row;
  std::getline(numbers, row);
  while (std::getline(numbers, row)) rows += "slow," + row + ",1\n";
  const std::string log = scratch.write("log.csv", rows);
  inspect::survey::ProposalOptions options;
  options.columns.names = {{"effort", "#4"}};
  const std::string text = propose(scratch, log, options).text;
  EXPECT_NE(text.find("effort = { name = \"tau_Nm\""), std::string::npos) << text;
}

TEST(ManifestProposal, ATorqueConstantWithoutItsSideOfTheGearLeavesTheTorqueUnconfirmed) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,q_deg,i_A"));
  inspect::survey::ProposalOptions options;
  options.torque_constant_Nm_A = 0.35;
  const auto expect_confirmed = [&](bool is_confirmed) {
    const std::string text = propose(scratch, log, options).text;
    EXPECT_NE(text.find("side = \"motor\""), std::string::npos) << text;
    EXPECT_EQ(text.find("confirmed = false") == std::string::npos, is_confirmed) << text;
  };
  expect_confirmed(false);
  options.gear_ratio = 100;
  expect_confirmed(false);
  options.effort_side = joint::Side::motor;
  expect_confirmed(true);
  // Without a gear both sides are one.
  options.effort_side.reset();
  options.gear_ratio = 1;
  expect_confirmed(true);
}

TEST(ManifestProposal, StatedColumnsAreParsed) {
  EXPECT_EQ(inspect::survey::parse_stated_column("angle=q=1"),
            (std::pair<std::string, std::string>("angle", "q=1")));
  for (const char* text : {"angle", "angle=", "foo=q", "=q", ""}) {
    EXPECT_THROW((void)inspect::survey::parse_stated_column(text), UsageError) << text;
  }
}

// Rows of numbers, without names and without a clock: a torque that rises is none.
TEST(ManifestProposal, ALogWithoutAClockIsReadByItsRate) {
  const test::ScratchDirectory scratch;
  std::string rows;
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    const double q = t < 20 ? -0.9 + 0.09 * t : 0.9 - 0.09 * (t - 20);
    rows += fmt::format("{:.5f} {:.5f} {:.4f}\n", q, 0.001 * i,
                        3 * std::cos(q) + (t < 20 ? 0.5 : -0.5));
  }
  const std::string log = scratch.write("rows.txt", rows);
  inspect::survey::ProposalOptions options;
  options.columns.rate_Hz = 100;
  options.columns.names = {{"angle", "#1"}, {"effort", "#3"}};
  options.effort_kind = joint::EffortKind::joint_torque;
  const inspect::survey::ManifestProposal proposal = propose(scratch, log, options);
  EXPECT_NE(proposal.text.find("time = { rate_Hz = 100 }"), std::string::npos) << proposal.text;
  const joint::Dataset dataset =
      ingest::dataset::read_dataset(scratch.write("dataset.toml", proposal.text));
  ASSERT_EQ(dataset.recordings.size(), 1U);
  const joint::Recording& r = dataset.recordings[0];
  EXPECT_EQ(r.role, joint::Role::rough_sweep);
  ASSERT_EQ(r.size(), 4000U);
  EXPECT_NEAR(r.t_s[1] - r.t_s[0], 0.01, 1e-12);
  EXPECT_NEAR(r.t_s.back(), 39.99, 1e-9);
  EXPECT_NEAR(r.q_rad[0], -0.9, 1e-9);
}

// Which units they are in, the angle's slope says.
TEST(ManifestProposal, UnitsOfAngleAndSpeedAreThoseThatFitEachOther) {
  const auto log = [](double angle_per_rad, double speed_per_rad) {
    std::string csv = "time_s,pos,vel,tau_Nm\n";
    for (int i = 0; i < 4000; ++i) {
      const double t = 0.01 * i;
      csv +=
          fmt::format("{:.2f},{:.6f},{:.6f},{:.4f}\n", t, angle_per_rad * 0.1 * std::sin(0.5 * t),
                      speed_per_rad * 0.05 * std::cos(0.5 * t), 3.0);
    }
    return csv;
  };
  constexpr double deg = 57.29577951;
  struct Case {
    double angle;
    double speed;
    const char* angle_unit;
    const char* speed_unit;
  };
  for (const Case& one :
       {Case{deg, 1, "deg", "rad/s"}, Case{1, deg, "rad", "deg/s"}, Case{1, 1, "rad", "rad/s"}}) {
    const test::ScratchDirectory scratch;
    const std::string path = scratch.write("log.csv", log(one.angle, one.speed));
    const inspect::survey::LogSurvey survey = inspect::survey::survey_log(path);
    const inspect::survey::TableSurvey& table = survey.tables.at(0);
    EXPECT_EQ(table.columns[1].meaning->unit, one.angle_unit);
    EXPECT_EQ(table.columns[2].meaning->unit, one.speed_unit);
  }
}

TEST(ManifestProposal, FrictionPointsAreReadAsTheFileWas) {
  const test::ScratchDirectory scratch;
  std::string rows = "by hand; on Monday\nspeed [rad/s];friction torque [Nm]\n";
  for (int k = 1; k < 10; ++k) rows += fmt::format("0,{};1,{}\n", k, k);
  inspect::survey::ProposalOptions options;
  options.log_rules.header_line = 2;
  options.log_rules.decimal_mark = ingest::text::DecimalMark::comma;
  const std::string log = scratch.write("points.csv", rows);
  const joint::Dataset dataset = ingest::dataset::read_dataset(
      scratch.write("dataset.toml", propose(scratch, log, options).text));
  ASSERT_EQ(dataset.friction_points.size(), 1U);
  EXPECT_EQ(dataset.friction_points[0].torque_Nm.at(4), 1.5);
}

/// Columns without names: the clock, angles, speeds and two other groups of two joints.
TEST(ManifestProposal, AnEffortThatIsSaidToBeThereIsTakenByItsPlaceAndNotConfirmed) {
  const test::ScratchDirectory scratch;
  std::string rows;
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    const double q = std::sin(0.3 * t) + 0.2 * std::sin(0.9 * t);
    const double v = 0.3 * std::cos(0.3 * t) + 0.18 * std::cos(0.9 * t);
    const double current = 3 * std::cos(q) + std::copysign(1, v);
    rows += fmt::format("{:.2f},{:.5f},0.1,{:.5f},0,{:.4f},0.2,{:.4f},0.3\n", t, q, v, current,
                        current + 0.1);
  }
  const std::string log = scratch.write("rows.csv", rows);
  inspect::survey::ProposalOptions options;
  EXPECT_EQ(propose(scratch, log, options).effort.kind, joint::EffortKind::none);
  options.effort_side = joint::Side::joint;
  options.torque_constant_Nm_A = 9;
  options.columns.effort_is = ingest::log::Quantity::current;
  const joint::Manifest manifest = proposed_manifest(scratch, log, options);
  EXPECT_EQ(manifest.drive.kind(), joint::EffortKind::motor_current);
  EXPECT_FALSE(manifest.effort_is_confirmed);
  EXPECT_NE(propose(scratch, log, options).text.find("effort = { name = \"#6\", unit = \"A\""),
            std::string::npos);
}

TEST(ManifestProposal, JointsThatMoveInColumnsWithoutNamesAreStated) {
  const test::ScratchDirectory scratch;
  std::string rows;
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    rows +=
        fmt::format("{:.2f},{:.5f},{:.5f},0.1,{:.5f},{:.5f},0,1.5,0.2,0.3\n", t, std::sin(0.3 * t),
                    0.3 * std::sin(0.5 * t), 0.3 * std::cos(0.3 * t), 0.15 * std::cos(0.5 * t));
  }
  const std::string log = scratch.write("rows.csv", rows);
  const joint::Manifest manifest = proposed_manifest(scratch, log, {});
  ASSERT_EQ(manifest.other_joints.size(), 1U) << "the third joint stands still";
  EXPECT_EQ(manifest.other_joints[0].name, "2");
  EXPECT_EQ(manifest.other_joints[0].angle, "#3");
}

TEST(ManifestProposal, WithoutEffortSaysWhatToRecord) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,q_deg,u_motor_V"));
  const inspect::survey::ManifestProposal proposal = propose(scratch, log);
  EXPECT_NE(proposal.text.find("kind = \"none\""), std::string::npos);
  EXPECT_NE(proposal.text.find("u_motor_V"), std::string::npos);
  EXPECT_NE(proposal.text.find("Record the motor current or the torque"), std::string::npos);
  EXPECT_EQ(ingest::manifest::parse_manifest(proposal.text, "m.toml").manifest.drive.kind(),
            joint::EffortKind::none);
}

TEST(ManifestProposal, NamesOfColumnsCannotBreakOutOfTheirText) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,q_deg,\"tau \\ x\x1b[31m_Nm\""));
  const inspect::survey::ManifestProposal proposal = propose(scratch, log);
  EXPECT_EQ(proposal.text.find('\x1b'), std::string::npos);
  const ingest::manifest::ManifestFile manifest =
      ingest::manifest::parse_manifest(proposal.text, "m.toml");
  EXPECT_EQ(manifest.recordings.size(), 1U);
}

TEST(ManifestProposal, AJointThatNoLogHasGetsTheList) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,q1_deg,q2_deg"));
  inspect::survey::ProposalOptions options;
  options.joint = "7";
  EXPECT_THROW((void)propose(scratch, log, options), UsageError);
  options.joint = "2";
  EXPECT_EQ(propose(scratch, log, options).joint, "2");
}

TEST(ManifestProposal, ALogWithoutAngleIsRefusedWithItsColumns) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", "alpha,beta\n1,2\n1,3\n");
  EXPECT_THROW((void)propose(scratch, log), InputError);
}

}  // namespace
}  // namespace tribolog::manifest_proposal_test
