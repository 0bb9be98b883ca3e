// Every figure of every example once as a picture, in the looks and languages in turn: what the
// graphics stack makes of the draw list.

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "figures/sweep/readings.h"
#include "figures/sweep/swept_figures.h"
#include "render/legibility/picture_border.h"
#include "render/png_reading.h"
#include "render/workers/renderer.h"
#include "support/breadth.h"
#include "wording/words.h"

namespace tribolog::test::drawn_sample_test {
namespace {

namespace legibility = render::legibility;

class DrawnSample : public testing::TestWithParam<std::string> {};

/// One reading for each figure; at a change of every third figure.
struct Sample {
  std::vector<render::figure::Figure> figures;
  std::vector<std::string> names;
};

Sample sample_of(std::string_view example) {
  const render::text::Font font;
  const std::vector<Reading> readings = all_readings();
  Sample out;
  const std::size_t step = every_case() ? 1 : 6;
  for (std::size_t i = 0; i < figures_of(example).size(); i += step) {
    const Reading& reading = readings[i % readings.size()];
    const figures::ReportFigure& figure = figures_of(example, reading.language)[i];
    out.figures.push_back(read_as(reading, figure, font).figure);
    out.names.push_back(figure.id + " (" + reading.name() + ")");
  }
  return out;
}

/// Estimators may agree to a pixel: both are in the legend and in the CSV, and the report says so
/// below the figure.
bool is_of_equal_curves(const Statement& warning) { return warning.is("drawing.hidden"); }

void save(const render::workers::DrawnFigure& drawn, const std::string& name) {
  const char* folder = std::getenv("TRIBOLOG_SAVE_DRAWINGS");
  if (folder == nullptr) return;
  std::ofstream file(std::string(folder) + "/" + name + ".png", std::ios::binary);
  file.write(reinterpret_cast<const char*>(drawn.png.data()),
             static_cast<std::streamsize>(drawn.png.size()));
}

// The renderer holds each picture against its draw list (render/check/picture_check.h).
TEST_P(DrawnSample, IsWholeAndInsideItsMargin) {
  const Sample sample = sample_of(GetParam());
  const auto drawn =
      render::workers::FigureRenderer(2, render::workers::Prepared::charts_and_scenes)
          .draw(sample.figures);
  ASSERT_EQ(drawn.size(), sample.figures.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    save(drawn[i], GetParam() + "-" + sample.names[i]);
    EXPECT_EQ(wording::words(drawn[i].error), "") << sample.names[i];
    for (const Statement& warning : drawn[i].warnings) {
      if (is_of_equal_curves(warning)) continue;
      ADD_FAILURE() << sample.names[i] << ": " << wording::words(warning);
    }
    if (drawn[i].png.empty()) continue;
    for (const auto& one : legibility::ink_at_border(render::read_png(drawn[i].png))) {
      ADD_FAILURE() << sample.names[i] << ": " << legibility::in_words(one);
    }
  }
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Examples, DrawnSample, testing::ValuesIn(swept_examples()), name_of);

}  // namespace
}  // namespace tribolog::test::drawn_sample_test
