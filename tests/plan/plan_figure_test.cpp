// The figures of a plan: each part is there by its name, with its own motion.

#include "figures/experiments/plan_figure.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "plan/paper_facts.h"

namespace tribolog::test::plan_figure_test {
namespace {

TEST(PlanFigure, NamesEveryPart) {
  const auto figures = figures::experiments::plan_figures(plan::plan_experiment(paper_facts()));
  ASSERT_EQ(figures.size(), 2U);
  std::set<std::string> labels;
  for (const render::figure::Series& s : figures[0].figure.panels[0].series) labels.insert(s.label);
  for (const char* name : {"rough sweep", "precise sweep", "micro-oscillations",
                           "runs at constant speed", "break-away ramps", "travel and rest"}) {
    EXPECT_EQ(labels.count(name), 1U) << name;
  }
}

TEST(PlanFigure, ShowsTheRangeTheSpeedsAndTheRamps) {
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts());
  const auto figures = figures::experiments::plan_figures(plan);
  const auto highest = [](const render::figure::Panel& panel) {
    double high = 0;
    for (const render::figure::Series& s : panel.series) {
      for (const double y : s.y) {
        EXPECT_TRUE(std::isfinite(y));
        high = std::max(high, y);
      }
    }
    return high;
  };
  const auto& panels = figures[0].figure.panels;
  ASSERT_EQ(panels.size(), 3U);
  EXPECT_NEAR(highest(panels[0]), 60, 1e-6);
  EXPECT_NEAR(highest(panels[1]), plan.motor_speeds_rad_s.back(), 1e-6);
  EXPECT_NEAR(highest(panels[2]), 1.6 * 0.88437633, 0.02);
  EXPECT_NEAR(highest(figures[1].figure.panels[0]), 1e6 * plan.amplitude_rad, 1);
}

TEST(PlanFigure, LeavesOutWhatIsNotPlanned) {
  const auto figures = figures::experiments::plan_figures(plan::plan_experiment(bare_facts()));
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].figure.panels.size(), 2U);
  plan::ExperimentPlan nothing = plan::plan_experiment(bare_facts());
  nothing.segments.clear();
  EXPECT_TRUE(figures::experiments::plan_figures(nothing).empty());
}

}  // namespace
}  // namespace tribolog::test::plan_figure_test
