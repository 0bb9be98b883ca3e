// A proposed manifest is one that the reader takes, but for what only the user knows.

#include "inspect/survey/manifest_proposal.h"

#include <cmath>

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
  return inspect::survey::propose_manifest({inspect::survey::survey_log(log)}, options);
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

TEST(ManifestProposal, LeavesTheTorqueConstantToTheUser) {
  const test::ScratchDirectory scratch;
  const std::string log = scratch.write("log.csv", sweep("time_ms,q_deg,i_motor_A"));
  const inspect::survey::ManifestProposal proposal = propose(scratch, log);
  try {
    (void)ingest::manifest::read_manifest(scratch.write("dataset.toml", proposal.text));
    FAIL() << "a torque constant of 0 was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("torque_constant_Nm_A"), std::string::npos);
  }
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
