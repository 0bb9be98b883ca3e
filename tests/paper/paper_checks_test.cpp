// The paper ticked off: every check of every figure, table and equation holds.

#include <set>

#include <gtest/gtest.h>

#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/scenario_file.h"
#include "paper/checks/golden_numbers.h"
#include "paper/checks/paper_figures.h"
#include "paper/checks/paper_items.h"
#include "paper/drawings/printed_paper.h"

namespace tribolog::paper {
namespace {

const std::string examples = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/";

class PaperChecks : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    joint_ = new PapersJoint(read_scenario(examples + "scenario.toml"),
                             read_robot(examples + "am100ib.toml"));
    sections_ = new std::vector<PaperSection>(paper_items(*joint_, paper_figures(*joint_)));
  }
  static void TearDownTestSuite() {
    delete sections_;
    delete joint_;
  }
  static void expect_all(const std::string& where, const Checks& checks) {
    EXPECT_FALSE(checks.empty()) << where;
    for (const Check& check : checks) {
      EXPECT_TRUE(check.holds()) << where << ": " << check.what << ": expected " << check.expected
                                 << check.expected_words << ", ours " << check.ours
                                 << check.ours_words << ", off by " << check.difference() << " "
                                 << check.unit << ", allowed " << check.bound;
    }
  }
  static PapersJoint* joint_;
  static std::vector<PaperSection>* sections_;
};

PapersJoint* PaperChecks::joint_ = nullptr;
std::vector<PaperSection>* PaperChecks::sections_ = nullptr;

TEST_F(PaperChecks, AllHold) {
  for (const PaperSection& section : *sections_) {
    for (const PaperItem& item : section.items) {
      expect_all(section.number + " " + std::to_string(static_cast<int>(item.kind)) + "-" +
                     std::to_string(item.number),
                 item.checks);
    }
  }
}

int failures(const Scenario& scenario) {
  const PapersJoint joint(scenario, read_robot(examples + "am100ib.toml"));
  int failed = 0;
  const auto add = [&](const Checks& checks) {
    const Tally tally = tally_checks(checks);
    failed += tally.there - tally.hold;
  };
  for (const PaperSection& section : paper_items(joint, paper_figures(joint))) {
    for (const PaperItem& item : section.items) add(item.checks);
  }
  add(golden_numbers(joint));
  return failed;
}

// A check that cannot fail shows nothing: other joints than the paper's must be told from it.
TEST_F(PaperChecks, FailForAnotherJoint) {
  const Scenario& own = joint_->scenario;
  EXPECT_EQ(failures(own), 0);

  Scenario other = own;
  LuGreFriction::Parameters p = bristles_of(own).parameters();
  p.bristle_stiffness_Nm_rad *= 1.05;
  other.presliding = std::make_shared<LuGreFriction>(p);
  EXPECT_GT(failures(other), 5) << "stiffness";

  other = own;
  other.gear_ratio = 99;
  EXPECT_GT(failures(other), 5) << "gear ratio";

  other = own;
  const GravityLoad& load = own.load;
  other.load = GravityLoad(load.mass_kg() * 1.001, load.distance_m(), load.q_peak_rad());
  EXPECT_GT(failures(other), 3) << "mass";

  other = own;
  other.load = GravityLoad(load.mass_kg(), load.distance_m(), load.q_peak_rad() + 1e-5);
  EXPECT_GT(failures(other), 3) << "angle";

  other = own;
  WaiboerFriction::Parameters w = sliding_of(own).parameters();
  w.smoothing_s_rad = 1e3;
  other.sliding = std::make_shared<WaiboerFriction>(w);
  EXPECT_GT(failures(other), 1) << "smoothing";
}

TEST_F(PaperChecks, ListTheWholePaperOnce) {
  for (const auto& [kind, all] :
       {std::pair{ItemKind::figure, printed::figures}, std::pair{ItemKind::table, printed::tables},
        std::pair{ItemKind::equation, printed::equations}}) {
    std::set<int> numbers;
    int hold = 0;
    for (const PaperSection& section : *sections_) {
      for (const PaperItem& item : section.items) {
        if (item.kind != kind) continue;
        EXPECT_TRUE(numbers.insert(item.number).second) << item.number;
        if (every_check_holds(item)) ++hold;
      }
    }
    EXPECT_EQ(static_cast<int>(numbers.size()), all);
    EXPECT_EQ(*numbers.begin(), 1);
    EXPECT_EQ(*numbers.rbegin(), all);
    EXPECT_EQ(hold, all);
  }
}

TEST_F(PaperChecks, AFigureThatIsMissingIsNamed) {
  std::vector<ReportFigure> figures = paper_figures(*joint_);
  std::erase_if(figures, [](const ReportFigure& figure) { return figure.number == 16; });
  try {
    paper_items(*joint_, figures);
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("figure 16"), std::string::npos) << error.what();
  }
}

TEST_F(PaperChecks, GoldenNumbersHold) { expect_all("golden", golden_numbers(*joint_)); }

}  // namespace
}  // namespace tribolog::paper
