// Figures for a journal: widths, sizes of letters, what is left out.

#include "render/composition/publication.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "render/composition/figure_layout.h"
#include "render/example_diagram.h"
#include "render/example_figures.h"
#include "render/text/font.h"
#include "render/vector/drawn_set.h"
#include "wording/words.h"

namespace tribolog::render::publication_test {
namespace {

double points(double pixels) { return pixels / composition::publication::px_per_mm * 72 / 25.4; }

template <class Look>
void each_run(const figure::DrawList& list, Look&& look) {
  for (const figure::Primitive& one : list.primitives) {
    if (const auto* run = std::get_if<figure::TextRun>(&one)) look(*run);
  }
}

TEST(Publication, IsOneOrTwoColumnsWideWithLettersOfSevenToEightPoints) {
  const text::Font font;
  for (const figures::ReportFigure& one : paper_set()) {
    const figure::Figure figure = composition::for_publication(one.figure, font);
    const bool single = figure.width_mm == composition::publication::single_column_mm;
    EXPECT_TRUE(single || figure.width_mm == composition::publication::double_column_mm) << one.id;
    EXPECT_EQ(figure.width_px, single ? 1680 : 3480) << one.id;
    EXPECT_LE(figure.height_px,
              composition::publication::highest_mm * composition::publication::px_per_mm)
        << one.id;
    const figure::DrawList list = composition::lay_out(figure, font);
    EXPECT_EQ(list.width_mm, figure.width_mm);
    EXPECT_TRUE(list.warnings.empty()) << one.id << ": " << wording::words(list.warnings.front());
    double largest = 0;
    each_run(list, [&](const figure::TextRun& run) {
      EXPECT_NE(run.owner.role, figure::Role::figure_title) << one.id;
      EXPECT_FALSE(run.text.ends_with("…")) << one.id << " '" << run.text << "'";
      const bool script = run.size < 45;
      EXPECT_GE(points(run.size), script ? 4.7 : 6.9) << one.id << " '" << run.text << "'";
      if (run.text != "∫") largest = std::max(largest, points(run.size));
    });
    EXPECT_LE(largest, 8.3) << one.id;
  }
}

TEST(Publication, HasThinnerLinesThanAReport) {
  const text::Font font;
  const auto width_mm = [&](const figure::Figure& figure, figure::Role role) {
    const figure::DrawList list = composition::lay_out(figure, font);
    for (const figure::Primitive& one : list.primitives) {
      const auto* line = std::get_if<figure::Polyline>(&one);
      if (line != nullptr && line->owner.role == role) {
        return line->width * list.width_mm / list.width;
      }
    }
    return 0.0;
  };
  const figure::Figure report = examples::hysteresis();
  const figure::Figure printed = composition::for_publication(report, font);
  for (const figure::Role role :
       {figure::Role::series, figure::Role::axis, figure::Role::grid, figure::Role::legend_box}) {
    EXPECT_GT(width_mm(printed, role), 0.05) << "a hairline in print";
    EXPECT_LT(width_mm(printed, role), 0.8 * width_mm(report, role));
  }
}

TEST(Publication, TakesTwoColumnsForWhatDoesNotFitIntoOne) {
  const text::Font font;
  EXPECT_EQ(composition::for_publication(examples::plain(), font).width_mm,
            composition::publication::single_column_mm);
  EXPECT_EQ(composition::for_publication(examples::many_curves(12), font).width_mm,
            composition::publication::double_column_mm);
  figure::Figure wordy = examples::plain();
  wordy.panels[0].series[0].label = "a legend text that is far too long for one column of a page";
  EXPECT_EQ(composition::for_publication(wordy, font).width_mm,
            composition::publication::double_column_mm);
  figure::Figure labelled = examples::hysteresis();
  labelled.panels[0].point_labels[0].text = "a point with a text too long to stand in one column";
  EXPECT_EQ(composition::for_publication(labelled, font).width_mm,
            composition::publication::double_column_mm);
  // A peak, and on each side of it a text that has no room beside the curve.
  figure::Figure peak = examples::plain();
  peak.panels[0].series[0].label.clear();
  peak.panels[0].series[0].x.clear();
  peak.panels[0].series[0].y.clear();
  for (int i = -100; i <= 100; ++i) {
    peak.panels[0].series[0].x.push_back(i);
    peak.panels[0].series[0].y.push_back(-i * i);
  }
  EXPECT_EQ(composition::for_publication(peak, font).width_mm,
            composition::publication::single_column_mm);
  peak.panels[0].reference_lines.push_back(
      {figure::ReferenceLine::Direction::vertical, 0, "q_{peak} = −22.23187° here"});
  peak.panels[0].point_labels.push_back({0, 0, "the largest torque is here"});
  EXPECT_EQ(composition::for_publication(peak, font).width_mm,
            composition::publication::double_column_mm);
  figure::Figure drawing = examples::diagram();
  drawing.diagram->width = 160;
  EXPECT_EQ(composition::for_publication(drawing, font).width_mm,
            composition::publication::double_column_mm);
}

TEST(Publication, IsHigherWhereManyNamesStandOnTheAxis) {
  const text::Font font;
  figure::Figure figure = examples::plain();
  EXPECT_EQ(composition::for_publication(figure, font).height_px,
            60 * composition::publication::px_per_mm);
  for (int i = 0; i < 15; ++i) figure.panels[0].y.names.push_back({1.0 * i, "mid-line"});
  EXPECT_EQ(composition::for_publication(figure, font).height_px,
            75 * composition::publication::px_per_mm);
  for (int i = 0; i < 200; ++i) figure.panels[0].y.names.push_back({1.0 * i, "mid-line"});
  EXPECT_EQ(composition::for_publication(figure, font).height_px,
            composition::publication::highest_mm * composition::publication::px_per_mm);
}

TEST(Publication, LeavesTheDataAsTheyAre) {
  const text::Font font;
  const figure::Figure report = examples::hysteresis();
  const figure::Figure printed = composition::for_publication(report, font);
  ASSERT_EQ(printed.panels.size(), report.panels.size());
  EXPECT_EQ(printed.panels[0].series[0].x, report.panels[0].series[0].x);
  EXPECT_EQ(printed.panels[0].series[0].label, report.panels[0].series[0].label);
  EXPECT_TRUE(printed.title.empty());
}

}  // namespace
}  // namespace tribolog::render::publication_test
