// The page of the regenerated paper: what it counts, and what it says of a check that fails.

#include "paper/page/paper_page.h"

#include <gtest/gtest.h>

#include "paper/page/page_parts.h"
#include "report/sample_calibration.h"

namespace tribolog::paper_page_test {
namespace {

using paper::checks::Check;
using paper::checks::ItemKind;

struct SmallPaper {
  paper::page::RegeneratedPaper paper;
  std::vector<render::workers::DrawnFigure> drawn;

  SmallPaper() {
    const paper::checks::Check holds = paper::checks::other_way("two and two", 4, 4, 0, "N·m", "");
    const paper::checks::Check as_printed =
        paper::checks::printed_value("four", 4, 0, 4, 0.5, "N·m", "whole numbers");
    paper.sections = {
        {"3.3",
         "Loops",
         {{paper::checks::ItemKind::figure, 15, "Loop", "", {holds}, {}},
          {paper::checks::ItemKind::equation, 4, "Rate", "", {holds}, {"by definition"}},
          {paper::checks::ItemKind::statement, 0, "Words", "", {as_printed}, {}}}}};
    paper.presliding = paper::charts::loops_of_figure_5({});
    figures::ReportFigure figure;
    figure.paper_number = 15;
    figure.id = "fig-15-loop";
    figure.title = "Loop";
    figure.alt = "a loop";
    paper.figures = {figure};
    paper.sources = {{"examples/paper/scenario.toml", "# <b>not bold</b>\n"}};
    paper.provenance.tool_version = "0.1.0";
    paper.provenance.created_utc = "2026-01-01T00:00:00Z";
    paper.provenance.command_line = "tribolog paper";
    render::workers::DrawnFigure picture;
    picture.id = figure.id;
    picture.png = {std::byte{1}};
    picture.width_px = 2;
    picture.height_px = 1;
    drawn = {picture};
  }
  [[nodiscard]] std::string page() const {
    return paper::page::paper_page(paper, test::complete_calibration(), drawn,
                                   paper::page::paper_json(paper));
  }
  [[nodiscard]] paper::page::PaperTally tally(ItemKind kind) const {
    for (const paper::page::PaperTally& one : paper::page::tally_of(paper, drawn)) {
      if (one.kind == kind) return one;
    }
    return {};
  }
};

TEST(PaperPage, CountsWhatIsThereAgainstWhatThePaperHas) {
  const SmallPaper small;
  EXPECT_EQ(small.tally(ItemKind::figure).printed, 22);
  EXPECT_EQ(small.tally(ItemKind::figure).here, 1);
  EXPECT_EQ(small.tally(ItemKind::figure).well, 1);
  EXPECT_EQ(small.tally(ItemKind::table).well, 0);
  EXPECT_EQ(small.tally(ItemKind::equation).well, 1);
  const std::string page = small.page();
  EXPECT_NE(page.find("NOT ALL THAT THE PAPER PRINTS IS FOUND AGAIN"), std::string::npos);
  EXPECT_NE(page.find("1 of 22 figures, 0 of 2 tables and 1 of 14 equations"), std::string::npos);
  EXPECT_NE(page.find("1 of 1 numbers, signs and orders that the paper prints"), std::string::npos);
  EXPECT_NE(page.find("1 of them to the last printed place"), std::string::npos);
  EXPECT_NE(page.find("2 of 2 independent computations"), std::string::npos);
  EXPECT_NE(page.find("1 definitions and values"), std::string::npos);
  EXPECT_NE(page.find("<li>by definition</li>"), std::string::npos);
}

TEST(PaperPage, AFigureWithoutAPictureDoesNotCount) {
  SmallPaper small;
  small.drawn[0].png.clear();
  small.drawn[0].error = Statement::verbatim("the stack is gone");
  EXPECT_EQ(small.tally(ItemKind::figure).here, 0);
  EXPECT_EQ(small.tally(ItemKind::figure).well, 0);
  EXPECT_NE(small.page().find("The stack is gone."), std::string::npos);
  EXPECT_NE(small.page().find("22 of 22 figures missing"), std::string::npos);
}

TEST(PaperPage, NamesTheCheckThatFails) {
  SmallPaper small;
  small.paper.sections[0].items[1].checks.push_back(
      paper::checks::printed_value("mass of row A", 79.999, 3, 80.5, 0.0107, "kg", "rounding"));
  EXPECT_EQ(small.tally(ItemKind::equation).well, 0);
  const std::string page = small.page();
  EXPECT_NE(page.find("Equation 4: mass of row A"), std::string::npos);
  EXPECT_EQ(test::occurrences(page, "<tr class=\"fails\">"), 1U);
  EXPECT_NE(page.find("\"holds\":false"), std::string::npos);
}

TEST(PaperPage, AskNothingOfTheOutsideAndEscapesItsSources) {
  const std::string page = SmallPaper().page();
  EXPECT_EQ(page.find("://"), std::string::npos);
  EXPECT_EQ(page.find("<b>not bold"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;not bold"), std::string::npos);
  EXPECT_EQ(test::occurrences(page, "<script"), 1U);  // the JSON
}

TEST(PaperPage, ShowsTheEquationThatIsMeantOnly) {
  const std::string page = SmallPaper().page();
  EXPECT_EQ(test::occurrences(page, "id=\"equation-"), 1U);
  EXPECT_EQ(test::occurrences(page, "<mi>z</mi></mrow></math>"), 1U);  // eq. (4) ends in z
}

TEST(CheckTexts, ShowAsMuchAsTheBoundLetsMean) {
  const auto mass = paper::checks::printed_value("", 78.811, 3, 78.81753313, 0.0106936, "kg", "");
  const paper::page::CheckTexts texts = paper::page::check_texts(mass);
  EXPECT_EQ(texts.expected, "78.811");
  EXPECT_EQ(texts.ours, "78.8175");
  EXPECT_EQ(texts.difference, "0.0065, 6.5 last places");
  EXPECT_EQ(texts.allowed, "0.0107");  // as it is applied
  EXPECT_EQ(mass.bound, 0.0107);
  EXPECT_EQ(texts.kind, "print");
}

TEST(CheckTexts, CountLastPlacesWherePrintIsMissed) {
  const auto torque = paper::checks::printed_value("", 3.703, 3, 3.69474, 0.029, "N·m", "");
  EXPECT_EQ(paper::page::check_texts(torque).difference, "−0.0083, 8.3 last places");
}

TEST(CheckTexts, RaiseExponentsAndKeepZero) {
  const paper::page::CheckTexts texts =
      paper::page::check_texts(paper::checks::vanishing("", -1.25e-12, 1e-9, "rad", ""));
  EXPECT_EQ(texts.expected, "0");
  EXPECT_EQ(texts.ours, "−1.2×10⁻¹²");
  EXPECT_EQ(texts.allowed, "1×10⁻⁹");
  const paper::page::CheckTexts exact =
      paper::page::check_texts(paper::checks::other_way("", 0.5, 0.5, 0, "", ""));
  EXPECT_EQ(exact.expected, "0.5");
  EXPECT_EQ(exact.difference, "0");
}

TEST(Check, ANumberThatIsNoneDoesNotHold) {
  EXPECT_FALSE(paper::checks::vanishing("", NAN, 1, "", "").holds());
  EXPECT_TRUE(paper::checks::vanishing("", -1, 1, "", "").holds());
  const auto one_is_none = [](double x) { return x > 1 ? NAN : x; };
  EXPECT_TRUE(std::isnan(paper::checks::largest_over({1, 2, 1}, one_is_none)));
  EXPECT_EQ(paper::checks::largest_over({1, -1}, one_is_none), 1);
  EXPECT_FALSE(paper::checks::by_name("", paper::checks::Kind::print, "B", "A").holds());
}

}  // namespace
}  // namespace tribolog::paper_page_test
