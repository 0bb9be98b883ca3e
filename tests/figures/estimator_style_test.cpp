#include "figures/estimator_style.h"

#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace tribolog::figures::estimator_style_test {
namespace {

// A grey print, or a reader who sees no colour, must still tell every pair apart.
TEST(EstimatorStyle, DashAndMarkerAloneAreDistinct) {
  std::set<std::pair<render::figure::LineStyle, render::figure::Marker>> seen;
  for (const char* name : styled_names) {
    const SeriesStyle style = estimator_style(name);
    EXPECT_TRUE(seen.emplace(style.line, style.marker).second) << name;
    EXPECT_NE(style.line, render::figure::LineStyle::none) << name;
  }
}

TEST(EstimatorStyle, YellowIsTooPaleOnWhite) {
  for (const char* name : styled_names) {
    EXPECT_FALSE(estimator_style(name).colour == render::figure::palette::yellow) << name;
  }
}

TEST(EstimatorStyle, EveryNameHasWords) {
  std::set<std::string> words;
  for (const char* name : styled_names) {
    EXPECT_FALSE(estimator_words(name).empty());
    EXPECT_TRUE(words.insert(estimator_words(name)).second) << name;
  }
  EXPECT_EQ(estimator_words("something else"), "something else");
}

TEST(EstimatorStyle, ApplyGivesTheSeriesThatLook) {
  render::figure::Series series;
  const SeriesStyle style = estimator_style("B");
  apply(style, series);
  EXPECT_TRUE(series.colour == style.colour);
  EXPECT_EQ(series.style, style.line);
  EXPECT_EQ(series.marker, style.marker);
}

}  // namespace
}  // namespace tribolog::figures::estimator_style_test
