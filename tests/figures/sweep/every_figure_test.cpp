// Every figure of every example, in both looks and all languages, as a careful reader would look
// at it; at a change each in one of them.

#include <gtest/gtest.h>

#include "figures/sweep/readings.h"
#include "figures/sweep/swept_figures.h"
#include "render/composition/figure_layout.h"
#include "render/legibility/contrast.h"
#include "render/legibility/letter_sizes.h"
#include "render/legibility/panel_content.h"
#include "render/legibility/text_collisions.h"
#include "support/breadth.h"
#include "wording/words.h"

namespace tribolog::test::every_figure_test {
namespace {

namespace legibility = render::legibility;

constexpr double least_letters_pt = 7;  // in a journal; a report is magnified by its reader

/// Counts, names, and one that says its unit in words.
const std::vector<std::string> without_unit{
    "cycles recorded", "parameters of the model", "quantity", "estimator",
    "deviation from the simulated value, in half widths of the stated 95 % interval"};

class EveryFigure : public testing::TestWithParam<std::string> {};

void expect_none(const legibility::Findings& findings, const std::string& figure) {
  for (const legibility::Finding& one : findings) {
    ADD_FAILURE() << figure << ": " << legibility::in_words(one);
  }
}

void expect_legible(const figures::ReportFigure& figure, const Reading& reading,
                    const render::text::Font& font) {
  const std::string name = figure.id + " (" + reading.name() + ")";
  const render::figure::DrawList list = render::composition::lay_out(figure.figure, font);
  for (const auto check :
       {legibility::overlapping_texts, legibility::texts_off_the_picture, legibility::texts_on_data,
        legibility::markers_under_texts, legibility::curves_under_labels,
        legibility::data_under_legends, legibility::data_outside_axes, legibility::faint_texts,
        legibility::faint_lines}) {
    expect_none(check(list), name);
  }
  expect_none(legibility::empty_panels(list, figure.figure), name);
  if (reading.look == render::figure::Look::publication) {
    expect_none(legibility::small_letters(list, least_letters_pt), name);
  }
  for (const Statement& warning : list.warnings) {
    ADD_FAILURE() << name << ": " << wording::words(warning);
  }
}

TEST_P(EveryFigure, IsLegible) {
  const render::text::Font font;
  const std::vector<Reading> readings = all_readings();
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const auto& figures = figures_of(GetParam(), readings[k].language);
    ASSERT_FALSE(figures.empty());
    for (std::size_t i = 0; i < figures.size(); ++i) {
      if (!every_case() && i % readings.size() != k) continue;
      expect_legible(read_as(readings[k], figures[i], font), readings[k], font);
    }
  }
}

TEST_P(EveryFigure, StatesItsUnits) {
  for (const figures::ReportFigure& one : figures_of(GetParam())) {
    expect_none(legibility::axes_without_unit(one.figure, without_unit), one.id);
  }
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Examples, EveryFigure, testing::ValuesIn(swept_examples()), name_of);

}  // namespace
}  // namespace tribolog::test::every_figure_test
