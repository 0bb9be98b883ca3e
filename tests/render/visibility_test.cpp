#include <algorithm>

#include <gtest/gtest.h>

#include "render/check/picture_check.h"
#include "render/check/visibility_map.h"

namespace tribolog::render {
namespace {

constexpr Owner first{Role::series, 0, 0};
constexpr Owner second{Role::series, 0, 1};

DrawList list_of(std::vector<Primitive> primitives) {
  DrawList list;
  list.width = 200;
  list.height = 100;
  list.primitives = std::move(primitives);
  return list;
}

Polyline level(Owner owner, double y, Colour colour, std::vector<double> dashes = {}) {
  return {owner, {{10, y}, {190, y}}, 4, colour, std::move(dashes)};
}

Figure two_series() {
  Figure figure;
  figure.panels.resize(1);
  figure.panels[0].series.resize(2);
  figure.panels[0].series[0].label = "below";
  figure.panels[0].series[1].label = "above";
  return figure;
}

Picture white() { return {200, 100, std::vector<std::uint8_t>(200 * 100 * 3, 255)}; }

void paint_row(Picture& picture, int y, Colour colour) {
  for (int x = 10; x < 190; ++x) {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * 200 + static_cast<std::size_t>(x));
    picture.rgb[i] = colour.red;
    picture.rgb[i + 1] = colour.green;
    picture.rgb[i + 2] = colour.blue;
  }
}

Picture with_line(int y, Colour colour) {
  Picture picture = white();
  for (const int row : {y - 2, y - 1, y, y + 1}) paint_row(picture, row, colour);
  return picture;
}

TEST(VisibilityMap, ExpectsNothingOfASeriesUnderALaterOne) {
  const VisibilityMap map(
      list_of({level(first, 50, palette::blue), level(second, 50, palette::vermilion)}));
  bool seen = false;
  for (std::size_t i = 0; i < map.size(); ++i) seen = seen || map.at(i) == 1;
  EXPECT_FALSE(seen);
  EXPECT_GT(map.subjects()[0].painted, 100U);
}

TEST(VisibilityMap, ExpectsTheLowerSeriesInTheGapsOfADashedOne) {
  const VisibilityMap map(
      list_of({level(first, 50, palette::blue), level(second, 50, palette::vermilion, {20, 20})}));
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
  const auto findings = check_picture(list_of({level(first, 50, palette::blue)}), two_series(),
                                      with_line(50, palette::blue));
  EXPECT_EQ(findings.error, "");
}

TEST(PictureCheck, FindsABlankPicture) {
  const auto findings =
      check_picture(list_of({level(first, 50, palette::blue)}), two_series(), white());
  EXPECT_NE(findings.error.find("blank"), std::string::npos);
}

TEST(PictureCheck, FindsASeriesInTheWrongColourOrPlace) {
  for (const Picture& wrong : {with_line(50, palette::orange), with_line(20, palette::blue)}) {
    const auto findings =
        check_picture(list_of({level(first, 50, palette::blue)}), two_series(), wrong);
    EXPECT_NE(findings.error.find("series 'below' is not visible"), std::string::npos)
        << findings.error;
  }
}

TEST(PictureCheck, WarnsOfAHiddenSeriesOnly) {
  const auto findings = check_picture(
      list_of({level(first, 50, palette::blue), level(second, 50, palette::vermilion)}),
      two_series(), with_line(50, palette::vermilion));
  EXPECT_EQ(findings.error, "");
  ASSERT_EQ(findings.warnings.size(), 1U);
  EXPECT_NE(findings.warnings[0].find("'below' is hidden"), std::string::npos);
}

// A curve in two parts of which one is covered; and a panel that shows what another one hides.
TEST(PictureCheck, DoesNotWarnWhereAnotherPartShowsTheSeries) {
  const Owner part{Role::series, 0, 2};
  const DrawList list = list_of({level(first, 20, palette::blue), level(part, 50, palette::blue),
                                 level(second, 50, palette::vermilion)});
  Picture picture = with_line(50, palette::vermilion);
  const Picture other = with_line(20, palette::blue);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    picture.rgb[i] = std::min(picture.rgb[i], other.rgb[i]);
  }
  Figure figure = two_series();
  figure.panels[0].series[1].colour = palette::vermilion;
  figure.panels[0].series.push_back(figure.panels[0].series[0]);
  for (const bool labelled : {true, false}) {
    if (!labelled) figure.panels[0].series.back().label.clear();
    const auto findings = check_picture(list, figure, picture);
    EXPECT_EQ(findings.error, "");
    EXPECT_TRUE(findings.warnings.empty()) << findings.warnings[0];
  }
  figure.panels[0].series.back().colour = palette::green;
  const auto findings = check_picture(list, figure, picture);
  ASSERT_EQ(findings.warnings.size(), 1U) << "a series of its own";
  EXPECT_EQ(findings.warnings[0], "series 3 is hidden under what is drawn after it");
}

}  // namespace
}  // namespace tribolog::render
