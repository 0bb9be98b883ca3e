// The page of a plan and its numbers.

#include "report/experiments/plan_page.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "exports/experiment/plan_files.h"
#include "exports/experiment/plan_table.h"
#include "plan/paper_facts.h"

namespace tribolog::test::plan_page_test {
namespace {

report::experiments::PlanReport report_of(const joint::JointFacts& facts, std::size_t runs = 0) {
  report::experiments::PlanReport report;
  report.plan = plan::plan_experiment(facts, {0.25});
  report.expected = plan::expect_intervals(report.plan, {runs});
  report.joint_file = "joint.toml";
  report.joint_text = "schema = \"<tribolog>\"";
  return report;
}

bool holds(const std::string& html, const std::string& text) {
  return html.find(text) != std::string::npos;
}

TEST(PlanPage, SaysWhatToDoAndWhatToExpect) {
  const std::string html = report::experiments::plan_page(report_of(paper_facts(), 2), {}, {});
  for (const char* text : {"Rough sweep", "Micro-oscillations", "−22.23", "id=\"table-expected\"",
                           "id=\"table-positions\"", "&lt;tribolog&gt;", "torque_mode"}) {
    EXPECT_TRUE(holds(html, text)) << text;
  }
  EXPECT_FALSE(holds(html, "http:"));
  EXPECT_FALSE(holds(html, "https:"));
}

TEST(PlanPage, AFirstPlanSaysSo) {
  const std::string html = report::experiments::plan_page(report_of(bare_facts()), {}, {});
  EXPECT_TRUE(holds(html, "FIRST PART OF TWO"));
  EXPECT_TRUE(holds(html, "--calibration"));
  EXPECT_TRUE(holds(html, "assumed: 10 % of the torque limit"));
  EXPECT_FALSE(holds(html, "id=\"table-expected\""));
}

TEST(PlanPage, NothingPossibleIsSaidWithItsReason) {
  joint::JointFacts f = paper_facts();
  f.torque_limit_Nm = 0.5;
  report::experiments::PlanReport report = report_of(f);
  EXPECT_TRUE(report.plan.segments.empty());
  const std::string html = report::experiments::plan_page(report, {}, {});
  EXPECT_TRUE(holds(html, "NOT POSSIBLE"));
  EXPECT_TRUE(holds(html, "nowhere within the angle limits"));
}

TEST(PlanJson, HoldsThePlan) {
  const report::experiments::PlanReport report = report_of(paper_facts(), 2);
  const auto json = nlohmann::json::parse(
      exports::experiment::plan_json(report.plan, report.expected, report.provenance));
  EXPECT_EQ(json["schema"], "tribolog-plan-1");
  EXPECT_EQ(json["parts"].size(), 5U);
  EXPECT_EQ(json["segments"].size(), report.plan.segments.size());
  EXPECT_EQ(json["expected"]["quantities"].size(), report.expected.quantities.size());
  EXPECT_DOUBLE_EQ(json["duration_s"], report.plan.duration_s());
}

TEST(PlanTable, NumbersEndWhereTheirIntervalBegins) {
  EXPECT_EQ(exports::experiment::interval_text(3.8831857, 2.13e-4, truth::ReadingKind::gravity),
            "3.88319 ± 0.00021 N·m");
  EXPECT_EQ(exports::experiment::interval_text(465.42, 12.3, truth::ReadingKind::stiffness),
            "465 ± 12 N·m/rad");
  EXPECT_EQ(exports::experiment::interval_text(-0.388, 1e-4, truth::ReadingKind::peak_angle),
            "−22.2308° ± 0.0057°");
  EXPECT_EQ(exports::experiment::interval_text(1, std::nan(""), truth::ReadingKind::gravity), "–");
  EXPECT_EQ(exports::experiment::duration_text(59.6), "1 min 0 s");
}

}  // namespace
}  // namespace tribolog::test::plan_page_test
