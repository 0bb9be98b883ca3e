// Figures and reports through the door.

#include "tribolog/figures.h"

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "api/dataset_example.h"
#include "tribolog/report.h"

namespace tribolog::test::figures_test {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++found;
  return found;
}

TEST(Charts, NeedNoRendererAsVectors) {
  EXPECT_FALSE(needs_renderer(example_manifest, {FigureFormat::svg, FigureFormat::pdf}));
  EXPECT_TRUE(needs_renderer(example_manifest, {FigureFormat::svg, FigureFormat::png}));
  FigureOptions options;
  options.formats = {FigureFormat::svg};
  const Figures figures = draw_figures(identified_example(), options);
  EXPECT_EQ(figures.files.size(), figures.outcomes.size());
  EXPECT_EQ(figures.drawn(), figures.outcomes.size());
  EXPECT_GE(figures.drawn(), 8U);
  for (const File& file : figures.files) {
    EXPECT_TRUE(file.name.ends_with(".svg")) << file.name;
    EXPECT_NE(file.bytes.find("<svg"), std::string::npos) << file.name;
  }
}

TEST(AReport, HasTheFiguresThatARendererDraws) {
  Renderer renderer;
  const Calibration found = identified_example();
  const Report plain = make_report(found);
  const Report drawn = make_report(found, {}, &renderer);
  EXPECT_EQ(count(plain.html, "data:image/png;base64,"), 0U);
  EXPECT_TRUE(plain.figures.empty());
  EXPECT_EQ(count(drawn.html, "data:image/png;base64,"), drawn.figures.size());
  for (const FigureOutcome& figure : drawn.figures) EXPECT_EQ(figure.error, "") << figure.id;
}

TEST(AReport, ShowsWhatHasChangedSinceAnEarlierCalibration) {
  const Calibration found = identified_example();
  const Calibration earlier = Calibration::from_json(found.to_json(), "earlier.json");
  const std::string without = make_report(found).html;
  const std::string with =
      make_report(found, {"en", EarlierCalibration{earlier, "0123456789abcdef"}, "", {}}).html;
  EXPECT_EQ(without.find("0123456789"), std::string::npos);
  EXPECT_NE(with.find("0123456789"), std::string::npos);
  EXPECT_EQ(with.find("0123456789a"), std::string::npos) << "ten characters are shown";
  EXPECT_NE(with.find("no change seen"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::test::figures_test
