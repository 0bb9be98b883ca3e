// A report with sixty figures, as a joint with many recordings could have one, keeps its size.

#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "figures/hand_made_calibration.h"
#include "figures/sweep/swept_figures.h"
#include "render/workers/renderer.h"
#include "report/document/html_report.h"
#include "support/breadth.h"

namespace tribolog::test::sixty_figures_test {
namespace {

constexpr std::size_t count = 60;
constexpr std::size_t most_bytes = 10'000'000;

std::vector<figures::ReportFigure> sixty_figures() {
  std::vector<figures::ReportFigure> all;
  for (const char* example : {"noise", "paper", "ripple", "models"}) {
    for (figures::ReportFigure figure : figures_of(example)) {
      if (all.size() == count) return all;
      figure.id = figure.figure.id = fmt::format("{}-{}", example, figure.id);
      all.push_back(std::move(figure));
    }
  }
  return all;
}

TEST(SixtyFigures, StayUnderTenMegabytes) {
  TRIBOLOG_EACH_NIGHT();
  const std::vector<figures::ReportFigure> figures = sixty_figures();
  ASSERT_EQ(figures.size(), count);
  std::vector<render::figure::Figure> scenes;
  for (const figures::ReportFigure& figure : figures) scenes.push_back(figure.figure);
  const auto drawn =
      render::workers::FigureRenderer(2, render::workers::Prepared::charts_and_scenes).draw(scenes);
  const joint::Dataset dataset = hand_made_dataset();
  const std::string page = report::document::html_report(hand_made_calibration(dataset), figures,
                                                         drawn, calibration::Provenance{});
  std::size_t pictures = 0;
  for (std::size_t at = page.find("data:image/png"); at != std::string::npos;
       at = page.find("data:image/png", at + 1)) {
    ++pictures;
  }
  EXPECT_EQ(pictures, count);
  EXPECT_LT(page.size(), most_bytes);
  RecordProperty("bytes", std::to_string(page.size()));
}

}  // namespace
}  // namespace tribolog::test::sixty_figures_test
