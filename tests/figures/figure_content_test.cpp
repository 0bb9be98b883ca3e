// What holds for every panel of every figure.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures/figure_set.h"
#include "figures/hand_made_calibration.h"

namespace tribolog::figure_content_test {
namespace {

class EveryPanel : public ::testing::Test {
 protected:
  EveryPanel() : dataset_(test::hand_made_dataset()) {
    for (const calibration::Calibration& calibration :
         {test::hand_made_calibration(dataset_), test::sweep_only_calibration(dataset_)}) {
      for (figures::ReportFigure& figure : figures::figure_set(dataset_, calibration))
        figures_.push_back(figure);
    }
  }

  template <typename Check>
  void for_each_panel(const Check& check) const {
    for (const figures::ReportFigure& figure : figures_) {
      SCOPED_TRACE(figure.id);
      ASSERT_FALSE(figure.figure.panels.empty());
      for (const render::figure::Panel& panel : figure.figure.panels) check(panel);
    }
  }

  joint::Dataset dataset_;
  std::vector<figures::ReportFigure> figures_;
};

void expect_quantity_and_unit(const std::string& title) {
  const std::size_t open = title.rfind('[');
  ASSERT_NE(open, std::string::npos) << title;
  EXPECT_EQ(title.back(), ']') << title;
  EXPECT_GT(open, 2U) << title;
  EXPECT_LT(open + 1, title.size() - 1) << "empty unit: " << title;
}

TEST_F(EveryPanel, HasUnitsOnBothAxes) {
  for_each_panel([](const render::figure::Panel& panel) {
    expect_quantity_and_unit(panel.x.title);
    expect_quantity_and_unit(panel.y.title);
  });
}

TEST_F(EveryPanel, HasSeriesOfEqualLengthWithSomethingToDraw) {
  for_each_panel([](const render::figure::Panel& panel) {
    EXPECT_FALSE(panel.series.empty());
    for (const render::figure::Series& series : panel.series) {
      ASSERT_EQ(series.x.size(), series.y.size()) << series.label;
      std::size_t drawable = 0;
      for (std::size_t i = 0; i < series.x.size(); ++i) {
        EXPECT_FALSE(std::isinf(series.x[i]) || std::isinf(series.y[i])) << series.label;
        // A gap is one in both, so that neither half of it hides a sample.
        EXPECT_EQ(std::isnan(series.x[i]), std::isnan(series.y[i])) << series.label;
        if (!std::isnan(series.x[i])) ++drawable;
      }
      EXPECT_GE(drawable, 1U) << series.label;
    }
    for (const render::figure::Band& band : panel.bands) {
      EXPECT_EQ(band.x.size(), band.low.size());
      EXPECT_EQ(band.x.size(), band.high.size());
    }
  });
}

TEST_F(EveryPanel, NamesEachSeriesOnce) {
  for_each_panel([](const render::figure::Panel& panel) {
    std::vector<std::string> labels;
    for (const render::figure::Series& series : panel.series) {
      if (!series.label.empty()) labels.push_back(series.label);
    }
    std::sort(labels.begin(), labels.end());
    EXPECT_EQ(std::adjacent_find(labels.begin(), labels.end()), labels.end());
  });
}

TEST_F(EveryPanel, ErrorBarsAndPointsAreFinite) {
  for_each_panel([](const render::figure::Panel& panel) {
    for (const render::figure::ErrorBar& bar : panel.error_bars) {
      EXPECT_TRUE(std::isfinite(bar.x));
      EXPECT_LE(bar.low, bar.high);
    }
    for (const render::figure::PointLabel& point : panel.point_labels) {
      EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y)) << point.text;
      EXPECT_FALSE(point.text.empty());
    }
    for (const render::figure::ReferenceLine& at : panel.reference_lines) {
      EXPECT_TRUE(std::isfinite(at.at)) << at.text;
    }
  });
}

TEST_F(EveryPanel, LogarithmicAxesHoldPositiveNumbersOnly) {
  for_each_panel([](const render::figure::Panel& panel) {
    if (!panel.x.logarithmic) return;
    EXPECT_GT(panel.x.minimum.value_or(1.0), 0.0);
    for (const render::figure::Series& series : panel.series) {
      for (const double x : series.x) EXPECT_GT(x, 0.0) << series.label;
    }
  });
}

}  // namespace
}  // namespace tribolog::figure_content_test
