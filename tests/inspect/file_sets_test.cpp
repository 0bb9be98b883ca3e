// Recordings in a file for each quantity: found by their names, and joined where their content
// bears that out.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/requirements.h"
#include "ingest/dataset/dataset_file.h"
#include "inspect/survey/log_survey.h"
#include "inspect/survey/manifest_proposal.h"
#include "support/run_program.h"

namespace tribolog::file_sets_test {
namespace {

using Names = std::vector<std::string>;
using Signal = std::function<double(double t_s)>;

double angle_rad(double t_s) { return t_s < 20 ? -0.9 + 0.09 * t_s : 0.9 - 0.09 * (t_s - 20); }
double torque_Nm(double t_s) { return 3 * std::cos(angle_rad(t_s)) + (t_s < 20 ? 0.5 : -0.5); }

/// Rows without names: the clock and the signal, or the signal alone.
std::string rows(const Signal& signal, bool with_clock = true, double start_s = 0,
                 int count = 4000) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double t = 0.01 * i;
    if (with_clock) text += fmt::format("{:.2f} ", start_s + t);
    text += fmt::format("{:.5f}\n", signal(t));
  }
  return text;
}

/// "angle + others", for each set.
Names sets_in(const Names& paths) {
  Names shown;
  for (const inspect::survey::FileSet& set : inspect::survey::sets_of_files(paths)) {
    shown.push_back(set.path);
    for (const inspect::survey::FileOfQuantity& one : set.beside) shown.back() += " + " + one.path;
  }
  return shown;
}

TEST(FileSets, AreFilesWhoseNamesDifferInTheQuantity) {
  EXPECT_EQ(sets_in({"tau1_run.t", "other.csv", "pos1_run.t", "pos2_run.t"}),
            (Names{"other.csv", "pos1_run.t + tau1_run.t", "pos2_run.t"}));
  EXPECT_EQ(sets_in({"a/q.txt", "b/q.txt", "a/dq.txt", "b/tau.txt"}),
            (Names{"a/q.txt + a/dq.txt", "b/q.txt + b/tau.txt"}));
  EXPECT_EQ(sets_in({"angle/1.txt", "torque/1.txt"}), Names{"angle/1.txt + torque/1.txt"});
  EXPECT_EQ(sets_in({"rec_ang.txt", "rec_vel.txt", "rec_motor.txt"}),
            Names{"rec_ang.txt + rec_vel.txt + rec_motor.txt"});
  const Names without_angle{"vel_1.txt", "tau_1.txt"};
  EXPECT_EQ(sets_in(without_angle), without_angle);
  const Names with_rivals{"pos_1.txt", "tau_1.txt", "torque_1.txt"};
  EXPECT_EQ(sets_in(with_rivals), with_rivals);
  const Names of_other_runs{"pos_1.txt", "tau_2.txt"};
  EXPECT_EQ(sets_in(of_other_runs), of_other_runs);
}

/// What two files, "pos.txt" and "tau.txt", are as one log.
class TwoFiles : public testing::Test {
 protected:
  std::optional<inspect::survey::LogSurvey> survey(
      const std::string& of_angle, const std::string& of_torque,
      const inspect::survey::StatedColumns& stated = {}) {
    const Names paths{scratch_.write("pos.txt", of_angle), scratch_.write("tau.txt", of_torque)};
    const auto sets = inspect::survey::sets_of_files(paths);
    return sets.size() == 1 ? inspect::survey::survey_set(sets.front(), {}, stated) : std::nullopt;
  }

  test::ScratchDirectory scratch_;
};

TEST_F(TwoFiles, AreReadByTheManifestThatIsProposed) {
  inspect::survey::ProposalOptions options;
  options.directory = scratch_.path();
  options.effort_kind = joint::EffortKind::joint_torque;
  options.columns.effort_unit = "Nm";
  const auto read = [&] {
    const auto log = survey(rows(angle_rad), rows(torque_Nm), options.columns);
    return ingest::dataset::read_dataset(scratch_.write(
        "dataset.toml", inspect::survey::propose_manifest({present(log)}, options).text));
  };
  const joint::Dataset dataset = read();
  ASSERT_EQ(dataset.recordings.size(), 1U);
  const joint::Recording& r = dataset.recordings[0];
  ASSERT_EQ(r.size(), 4000U);
  EXPECT_NEAR(r.q_rad[1000], angle_rad(10), 1e-5);
  EXPECT_NEAR(r.torque_Nm[1000], torque_Nm(10), 1e-5);
  EXPECT_NEAR(r.t_s[1000], 10, 1e-9);
  EXPECT_FALSE(dataset.manifest.effort_is_confirmed) << "a file's name is no proof";
  options.columns.names = {{"effort", "#2 of tau.txt"}};
  EXPECT_TRUE(read().manifest.effort_is_confirmed);
}

TEST_F(TwoFiles, OfSeveralJointsHaveAColumnForEach) {
  const auto both = [](const Signal& first, const Signal& second) {
    std::string text;
    for (int i = 0; i < 4000; ++i) {
      text += fmt::format("{:.5f} {:.5f}\n", first(0.01 * i), second(0.01 * i));
    }
    return text;
  };
  const auto still = [](double) { return 0.1; };
  const std::string angles = both(still, angle_rad);
  const std::string torques = both([](double t_s) { return 0.3 * std::sin(9 * t_s); }, torque_Nm);
  EXPECT_FALSE(survey(angles, torques)) << "the first column is no clock";
  inspect::survey::StatedColumns stated;
  stated.rate_Hz = 100;
  const auto log = survey(angles, torques, stated);
  ASSERT_TRUE(log);
  const inspect::survey::TableSurvey& table = log->tables.at(0);
  ASSERT_EQ(table.joints.size(), 2U);
  EXPECT_EQ(table.joints[1].name, "2");
  EXPECT_EQ(table.columns.at(table.joints[1].angle).key, "#2");
  ASSERT_TRUE(table.joints[1].effort);
  const inspect::survey::ColumnSurvey& effort = table.columns.at(*table.joints[1].effort);
  EXPECT_EQ(effort.key, "#2");
  EXPECT_EQ(effort.file, scratch_.file("tau.txt"));
  EXPECT_TRUE(effort.is_guess);

  inspect::survey::ProposalOptions options;
  options.directory = scratch_.path();
  options.columns = stated;
  options.columns.names = {{"angle", "#1"}};
  const auto of_first = survey(both(torque_Nm, angle_rad), torques, options.columns);
  const auto proposal = inspect::survey::propose_manifest({present(of_first)}, options);
  EXPECT_EQ(proposal.joint, "1") << "the stated one, whichever moves more";
  EXPECT_NE(proposal.text.find("[[other_joint]]\nname = \"2\"\nangle = { name = \"#2\""),
            std::string::npos)
      << proposal.text;
}

TEST_F(TwoFiles, ThatDoNotBelongTogetherAreNotJoined) {
  const std::string angles = rows(angle_rad);
  EXPECT_TRUE(survey(angles, rows(torque_Nm)));
  EXPECT_FALSE(survey(angles, rows(torque_Nm, true, 0, 3999))) << "other rows";
  EXPECT_FALSE(survey(angles, rows(torque_Nm, true, 5))) << "other times";
  EXPECT_FALSE(survey(angles, rows(torque_Nm, false))) << "no clock";
  EXPECT_FALSE(survey("t q\n" + angles, "t tau\n" + rows(torque_Nm))) << "named columns";
  EXPECT_FALSE(survey(angles, "not a table\n"));
}

/// Recordings in which the position or the torque is controlled are called so too.
TEST_F(TwoFiles, ThatHoldAnAngleAndItsSpeedAreLogsByThemselves) {
  std::string whole;
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    whole += fmt::format("{:.2f} {:.5f} {:.5f} {:.5f}\n", t, std::sin(t), std::cos(t), 0.1 * t);
  }
  EXPECT_FALSE(survey(whole, whole));
}

}  // namespace
}  // namespace tribolog::file_sets_test
