#include "figures/estimator_style.h"

#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace tribolog::figures::estimator_style_test {
namespace {

using method::hysteresis::all_estimators;
using method::hysteresis::Estimator;

// A grey print, or a reader who sees no colour, must still tell every pair apart.
TEST(EstimatorStyle, DashAndMarkerAloneAreDistinct) {
  std::set<std::pair<render::figure::LineStyle, render::figure::Marker>> seen;
  seen.emplace(reference_style.line, reference_style.marker);
  for (const Estimator estimator : all_estimators) {
    const SeriesStyle style = estimator_style(estimator);
    EXPECT_TRUE(seen.emplace(style.line, style.marker).second) << to_string(estimator);
    EXPECT_NE(style.line, render::figure::LineStyle::none) << to_string(estimator);
  }
}

TEST(EstimatorStyle, YellowIsTooPaleOnWhite) {
  for (const Estimator estimator : all_estimators) {
    EXPECT_FALSE(estimator_style(estimator).colour == render::figure::palette::yellow)
        << to_string(estimator);
  }
}

TEST(EstimatorStyle, EveryEstimatorHasWords) {
  std::set<std::string> words;
  for (const Estimator estimator : all_estimators) {
    EXPECT_FALSE(estimator_words(estimator).empty());
    EXPECT_TRUE(words.insert(estimator_words(estimator)).second) << to_string(estimator);
  }
}

TEST(EstimatorStyle, ApplyGivesTheSeriesThatLook) {
  render::figure::Series series;
  const SeriesStyle style = estimator_style(Estimator::B);
  apply(style, series);
  EXPECT_TRUE(series.colour == style.colour);
  EXPECT_EQ(series.style, style.line);
  EXPECT_EQ(series.marker, style.marker);
}

}  // namespace
}  // namespace tribolog::figures::estimator_style_test
