// The paper ticked off: every check of every figure, table and equation holds.

#include <set>

#include <gtest/gtest.h>

#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/scenario_file.h"
#include "paper/checks/golden_numbers.h"
#include "paper/checks/paper_items.h"
#include "paper/drawings/printed_paper.h"

namespace tribolog::paper::paper_checks_test {
namespace {

const std::string examples = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/";

class PaperChecks : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    joint_ = new checks::PapersJoint(ingest::manifest::read_scenario(examples + "scenario.toml"),
                                     ingest::manifest::read_robot(examples + "am100ib.toml"));
    sections_ = new std::vector<checks::PaperSection>(
        checks::paper_items(*joint_, checks::paper_figures(*joint_)));
  }
  static void TearDownTestSuite() {
    delete sections_;
    delete joint_;
  }
  static void expect_all(const std::string& where, const checks::Checks& checks) {
    EXPECT_FALSE(checks.empty()) << where;
    for (const checks::Check& check : checks) {
      EXPECT_TRUE(check.holds()) << where << ": " << check.what << ": expected " << check.expected
                                 << check.expected_words << ", ours " << check.ours
                                 << check.ours_words << ", off by " << check.difference() << " "
                                 << check.unit << ", allowed " << check.bound;
    }
  }
  static checks::PapersJoint* joint_;
  static std::vector<checks::PaperSection>* sections_;
};

checks::PapersJoint* PaperChecks::joint_ = nullptr;
std::vector<checks::PaperSection>* PaperChecks::sections_ = nullptr;

TEST_F(PaperChecks, AllHold) {
  for (const checks::PaperSection& section : *sections_) {
    for (const checks::PaperItem& item : section.items) {
      expect_all(section.number + " " + std::to_string(static_cast<int>(item.kind)) + "-" +
                     std::to_string(item.number),
                 item.checks);
    }
  }
}

int failures(const simulate::Scenario& scenario) {
  const checks::PapersJoint joint(scenario,
                                  ingest::manifest::read_robot(examples + "am100ib.toml"));
  int failed = 0;
  const auto add = [&](const checks::Checks& checks) {
    const checks::Tally tally = checks::tally_checks(checks);
    failed += tally.there - tally.hold;
  };
  for (const checks::PaperSection& section :
       checks::paper_items(joint, checks::paper_figures(joint))) {
    for (const checks::PaperItem& item : section.items) add(item.checks);
  }
  add(checks::golden_numbers(joint));
  return failed;
}

// A check that cannot fail shows nothing: other joints than the paper's must be told from it.
TEST_F(PaperChecks, FailForAnotherJoint) {
  const simulate::Scenario& own = joint_->scenario;
  EXPECT_EQ(failures(own), 0);

  simulate::Scenario other = own;
  friction::LuGreFriction::Parameters p = checks::bristles_of(own).parameters();
  p.bristle_stiffness_Nm_rad *= 1.05;
  other.presliding = std::make_shared<friction::LuGreFriction>(p);
  EXPECT_GT(failures(other), 5) << "stiffness";

  other = own;
  other.gear_ratio = 99;
  EXPECT_GT(failures(other), 5) << "gear ratio";

  other = own;
  const joint::GravityLoad& load = own.load;
  other.load = joint::GravityLoad(load.mass_kg() * 1.001, load.distance_m(), load.q_peak_rad());
  EXPECT_GT(failures(other), 3) << "mass";

  other = own;
  other.load = joint::GravityLoad(load.mass_kg(), load.distance_m(), load.q_peak_rad() + 1e-5);
  EXPECT_GT(failures(other), 3) << "angle";

  other = own;
  friction::WaiboerFriction::Parameters w = checks::sliding_of(own).parameters();
  w.smoothing_s_rad = 1e3;
  other.sliding = std::make_shared<friction::WaiboerFriction>(w);
  EXPECT_GT(failures(other), 1) << "smoothing";
}

TEST_F(PaperChecks, ListTheWholePaperOnce) {
  for (const auto& [kind, all] : {std::pair{checks::ItemKind::figure, drawings::figures},
                                  std::pair{checks::ItemKind::table, drawings::tables},
                                  std::pair{checks::ItemKind::equation, drawings::equations}}) {
    std::set<int> numbers;
    int hold = 0;
    for (const checks::PaperSection& section : *sections_) {
      for (const checks::PaperItem& item : section.items) {
        if (item.kind != kind) continue;
        EXPECT_TRUE(numbers.insert(item.number).second) << item.number;
        if (checks::every_check_holds(item)) ++hold;
      }
    }
    EXPECT_EQ(static_cast<int>(numbers.size()), all);
    EXPECT_EQ(*numbers.begin(), 1);
    EXPECT_EQ(*numbers.rbegin(), all);
    EXPECT_EQ(hold, all);
  }
}

TEST_F(PaperChecks, AFigureThatIsMissingIsNamed) {
  std::vector<figures::ReportFigure> figures = checks::paper_figures(*joint_);
  std::erase_if(figures, [](const figures::ReportFigure& figure) { return figure.number == 16; });
  try {
    checks::paper_items(*joint_, figures);
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("figure 16"), std::string::npos) << error.what();
  }
}

TEST_F(PaperChecks, GoldenNumbersHold) { expect_all("golden", checks::golden_numbers(*joint_)); }

}  // namespace
}  // namespace tribolog::paper::paper_checks_test
