// The paper ticked off: every check of every figure, table and equation holds.

#include <set>

#include <gtest/gtest.h>

#include "figures/figure_set.h"
#include "ingest/robot_file.h"
#include "ingest/scenario_file.h"
#include "paper/checks/golden_numbers.h"
#include "paper/checks/paper_items.h"
#include "paper/paper_drawings.h"
#include "paper/printed_paper.h"
#include "paper/scenes/scene_figures.h"

namespace tribolog::paper {
namespace {

const std::string examples = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/";

class PaperChecks : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    joint_ = new PapersJoint(read_scenario(examples + "scenario.toml"),
                             read_robot(examples + "am100ib.toml"));
    std::vector<ReportFigure> figures = paper_drawings(joint_->scenario.gear_ratio);
    for (const auto& more :
         {scene_figures(joint_->robot), figure_set(joint_->dataset, joint_->calibration)}) {
      figures.insert(figures.end(), more.begin(), more.end());
    }
    sections_ = new std::vector<PaperSection>(paper_items(*joint_, figures));
  }
  static void TearDownTestSuite() {
    delete sections_;
    delete joint_;
  }
  static void expect_all(const std::string& where, const Checks& checks) {
    EXPECT_FALSE(checks.empty()) << where;
    for (const Check& check : checks) {
        printf("%-14s %-90s %.9g %.9g %.2g %.2g %s %s|%s\n", where.c_str(), check.what.c_str(),
               check.expected, check.ours, check.difference(), check.bound, check.unit.c_str(),
               check.expected_words.c_str(), check.ours_words.c_str());
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

TEST_F(PaperChecks, GoldenNumbersHold) { expect_all("golden", golden_numbers(*joint_)); }

}  // namespace
}  // namespace tribolog::paper
