#include <algorithm>

#include <gtest/gtest.h>

#include "render/check/picture_check.h"
#include "render/check/visibility_map.h"
#include "wording/words.h"

namespace tribolog::render::visibility_test {
namespace {

constexpr figure::Owner first{figure::Role::series, 0, 0};
constexpr figure::Owner second{figure::Role::series, 0, 1};

figure::DrawList list_of(std::vector<figure::Primitive> primitives) {
  figure::DrawList list;
  list.width = 200;
  list.height = 100;
  list.primitives = std::move(primitives);
  return list;
}

figure::Polyline level(figure::Owner owner, double y, figure::Colour colour,
                       std::vector<double> dashes = {}) {
  return {owner, {{10, y}, {190, y}}, 4, colour, std::move(dashes)};
}

figure::Figure two_series() {
  figure::Figure figure;
  figure.panels.resize(1);
  figure.panels[0].series.resize(2);
  figure.panels[0].series[0].label = "below";
  figure.panels[0].series[1].label = "above";
  return figure;
}

figure::Picture white() { return {200, 100, std::vector<std::uint8_t>(200 * 100 * 3, 255)}; }

void paint_row(figure::Picture& picture, int y, figure::Colour colour) {
  for (int x = 10; x < 190; ++x) {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * 200 + static_cast<std::size_t>(x));
    picture.rgb[i] = colour.red;
    picture.rgb[i + 1] = colour.green;
    picture.rgb[i + 2] = colour.blue;
  }
}

figure::Picture with_line(int y, figure::Colour colour) {
  figure::Picture picture = white();
  for (const int row : {y - 2, y - 1, y, y + 1}) paint_row(picture, row, colour);
  return picture;
}

TEST(VisibilityMap, ExpectsNothingOfASeriesUnderALaterOne) {
  const check::VisibilityMap map(list_of(
      {level(first, 50, figure::palette::blue), level(second, 50, figure::palette::vermilion)}));
  bool seen = false;
  for (std::size_t i = 0; i < map.size(); ++i) seen = seen || map.at(i) == 1;
  EXPECT_FALSE(seen);
  EXPECT_GT(map.subjects()[0].painted, 100U);
}

TEST(VisibilityMap, ExpectsTheLowerSeriesInTheGapsOfADashedOne) {
  const check::VisibilityMap map(
      list_of({level(first, 50, figure::palette::blue),
               level(second, 50, figure::palette::vermilion, {20, 20})}));
  int lower = 0;
  int upper = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    lower += map.at(i) == 1 ? 1 : 0;
    upper += map.at(i) == 2 ? 1 : 0;
  }
  EXPECT_GT(lower, 60);
  EXPECT_GT(upper, 60);
}

TEST(PictureCheck, AcceptsASeriesThatIsThere) {
  const auto findings = check::check_picture(list_of({level(first, 50, figure::palette::blue)}),
                                             two_series(), with_line(50, figure::palette::blue));
  EXPECT_EQ(wording::words(findings.error), "");
}

TEST(PictureCheck, FindsABlankPicture) {
  const auto findings = check::check_picture(list_of({level(first, 50, figure::palette::blue)}),
                                             two_series(), white());
  EXPECT_EQ(findings.error, Statement("drawing.blank"));
}

TEST(PictureCheck, FindsASeriesInTheWrongColourOrPlace) {
  for (const figure::Picture& wrong :
       {with_line(50, figure::palette::orange), with_line(20, figure::palette::blue)}) {
    const auto findings = check::check_picture(list_of({level(first, 50, figure::palette::blue)}),
                                               two_series(), wrong);
    EXPECT_EQ(wording::words(findings.error).find("series 'below' is not visible"), 0U)
        << wording::words(findings.error);
  }
}

TEST(PictureCheck, WarnsOfAHiddenSeriesOnly) {
  const auto findings =
      check::check_picture(list_of({level(first, 50, figure::palette::blue),
                                    level(second, 50, figure::palette::vermilion)}),
                           two_series(), with_line(50, figure::palette::vermilion));
  EXPECT_EQ(wording::words(findings.error), "");
  ASSERT_EQ(findings.warnings.size(), 1U);
  EXPECT_EQ(wording::words(findings.warnings[0]),
            "series 'below' is hidden under what is drawn after it");
}

// A curve in two parts of which one is covered; and a panel that shows what another one hides.
TEST(PictureCheck, DoesNotWarnWhereAnotherPartShowsTheSeries) {
  const figure::Owner part{figure::Role::series, 0, 2};
  const figure::DrawList list =
      list_of({level(first, 20, figure::palette::blue), level(part, 50, figure::palette::blue),
               level(second, 50, figure::palette::vermilion)});
  figure::Picture picture = with_line(50, figure::palette::vermilion);
  const figure::Picture other = with_line(20, figure::palette::blue);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    picture.rgb[i] = std::min(picture.rgb[i], other.rgb[i]);
  }
  figure::Figure figure = two_series();
  figure.panels[0].series[1].colour = figure::palette::vermilion;
  figure.panels[0].series.push_back(figure.panels[0].series[0]);
  for (const bool labelled : {true, false}) {
    if (!labelled) figure.panels[0].series.back().label.clear();
    const auto findings = check::check_picture(list, figure, picture);
    EXPECT_EQ(wording::words(findings.error), "");
    EXPECT_TRUE(findings.warnings.empty()) << wording::words(findings.warnings[0]);
  }
  figure.panels[0].series.back().colour = figure::palette::green;
  const auto findings = check::check_picture(list, figure, picture);
  ASSERT_EQ(findings.warnings.size(), 1U) << "a series of its own";
  EXPECT_EQ(wording::words(findings.warnings[0]),
            "series 3 is hidden under what is drawn after it");
}

}  // namespace
}  // namespace tribolog::render::visibility_test
