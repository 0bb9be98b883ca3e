#include "report/document/html_report.h"

#include <regex>
#include <tuple>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "calibration/calibration_json.h"
#include "identify/identify.h"
#include "render/figure/figure.h"
#include "report/sample_calibration.h"
#include "support/paper_joint.h"

namespace tribolog::test::html_report_test {
namespace {

TEST(HtmlReport, SameArgumentsSameBytes) {
  EXPECT_EQ(report_of(complete_calibration()), report_of(complete_calibration()));
}

TEST(HtmlReport, PointsToNothingOutside) {
  for (const calibration::Calibration& c : {complete_calibration(), sweep_only()}) {
    const std::string html = report_of(c);
    const std::regex link(
        R"re(\s(?:src|href|action|poster)\s*=\s*(?!"#|"data:image/png;base64,))re");
    const std::string body = html.substr(0, html.find("<script type"));
    EXPECT_FALSE(std::regex_search(body, link));
    for (const char* word : {"http:", "https:", "url(", "@import", "fetch(", "XMLHttpRequest"}) {
      EXPECT_EQ(body.find(word), std::string::npos) << word;
    }
    // The result, and where there is something to review the viewer and its data.
    EXPECT_EQ(occurrences(html, "<script"), c.viscous.curves.empty() ? 1U : 3U);
  }
}

TEST(HtmlReport, SectionsComeInTheContractsOrder) {
  for (const calibration::Calibration& c : {complete_calibration(), sweep_only()}) {
    const std::string html = report_of(c);
    std::size_t last = 0;
    for (const std::string id :
         {"verdict", "quantities", "boundary", "certificate", "findings", "budget", "stage-1",
          "stage-2", "stage-3", "stage-4", "stage-5", "stage-6", "stage-7", "stage-8",
          "data-checks", "key-numbers", "intervals", "provenance"}) {
      const bool is_judged = id == "quantities" || id == "findings" || id == "budget";
      if (is_judged && c.judgement.quantities.empty()) continue;
      if (id == "data-checks" && c.data_checks.checks.empty()) continue;
      const std::size_t at = html.find("<section id=\"" + id + "\"");
      ASSERT_NE(at, std::string::npos) << id;
      EXPECT_GT(at, last) << id;
      last = at;
    }
  }
}

TEST(HtmlReport, ABudgetOfTheRecordingsAloneIsALineAndWhatWouldAddToIt) {
  calibration::Calibration c = complete_calibration();
  EXPECT_NE(report_of(c).find("id=\"table-budget\""), std::string::npos);
  for (calibration::QuantityVerdict& q : c.judgement.quantities) {
    if (q.budget) q.budget->parts.resize(1);
  }
  const std::string html = report_of(c);
  EXPECT_EQ(html.find("id=\"table-budget\""), std::string::npos);
  EXPECT_NE(html.find("torque_constant_percent = 2"), std::string::npos);
  EXPECT_NE(html.find("hoses and cables, typical 0.10"), std::string::npos);
}

TEST(HtmlReport, KeyNumbersAppear) {
  const std::string html = report_of(complete_calibration());
  for (const char* text : {"79.168 ± 0.088", "−22.232 ± 0.012", "388.32 ± 0.43", "USABLE",
                           "Mid-line", "140\u202f410", "outside the window 5..62.3 s"}) {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
}

TEST(HtmlReport, VerdictIsAWordAnIconAndAColour) {
  calibration::Calibration c = complete_calibration();
  for (const auto& [verdict, word, colour] :
       {std::tuple{calibration::Verdict::usable, "USABLE", "good"},
        std::tuple{calibration::Verdict::doubtful, "DOUBTFUL", "partial"},
        std::tuple{calibration::Verdict::not_identifiable, "NOT IDENTIFIABLE", "bad"}}) {
    c.judgement.verdict = verdict;
    const std::string html = report_of(c);
    const std::size_t at =
        html.find("<section id=\"verdict\" class=\"verdict " + std::string(colour));
    ASSERT_NE(at, std::string::npos) << word;
    const std::string banner = html.substr(at, html.find("</section>", at) - at);
    EXPECT_NE(banner.find("<span class=\"word\">" + std::string(word)), std::string::npos);
    EXPECT_EQ(occurrences(banner, "<svg"), 1U);
  }
}

TEST(HtmlReport, EachQuantityHasItsVerdictAndRefersToItsReasons) {
  const std::string html = report_of(complete_calibration());
  const std::size_t at = html.find("id=\"table-quantities\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(at, html.find("id=\"findings\""));  // on page one
  const std::string table = html.substr(at, html.find("</table>", at) - at);
  EXPECT_NE(table.find("state good"), std::string::npos);
  for (const char* text : {"usable", "≤ −20°</bdi>", "met", "3.883 ± 0.020\u00a0N·m",
                           "388.3 ± 2.0\u00a0N·m", "1.96", "torque constant 95\u00a0%"}) {
    EXPECT_NE(table.find(text), std::string::npos) << text << " in\n" << table;
  }
  // Said once, referred to by number.
  EXPECT_EQ(occurrences(html, ": the data do not show it."), 1U);
  EXPECT_EQ(occurrences(html, "A fast sine."), 1U);
}

TEST(HtmlReport, EveryReferenceLeadsToAFinding) {
  for (const calibration::Calibration& c :
       {complete_calibration(), identify::identify(simulate::simulated_dataset(paper_joint()))}) {
    const std::string html = report_of(c);
    std::size_t references = 0;
    const std::string start = "href=\"#finding-";
    for (std::size_t at = html.find(start); at != std::string::npos;
         at = html.find(start, at + 1)) {
      const std::size_t number = at + start.size();
      const std::string id = html.substr(number, html.find('"', number) - number);
      EXPECT_EQ(occurrences(html, "id=\"finding-" + id + "\""), 1U) << id;
      ++references;
    }
    EXPECT_GT(references, 0U);
  }
}

TEST(HtmlReport, ItsNumberIsThatOfTheArchiveOrOfItsContent) {
  const calibration::Calibration c = complete_calibration();
  const std::string filed = report::document::html_report(
      c, {}, {}, sample_provenance(), {std::nullopt, {}, "0123456789abcdef0123"});
  EXPECT_NE(filed.find("Identification report <bdi>tribolog-0123456789ab</bdi>"),
            std::string::npos);
  EXPECT_NE(filed.find("@top-right{content:\"tribolog-0123456789ab\""), std::string::npos);
  const auto number = [](const calibration::Calibration& found, const std::string& command) {
    calibration::Provenance p = sample_provenance();
    p.command_line = command;
    const std::string html = report::document::html_report(found, {}, {}, p);
    return html.substr(html.find("<bdi>tribolog-"), 26);
  };
  EXPECT_EQ(number(c, "tribolog report a.toml"), number(c, "tribolog report a.toml -o b.html"));
  calibration::Calibration other = c;
  other.inputs.back().sha256 = std::string(64, 'c');
  EXPECT_NE(number(c, "tribolog"), number(other, "tribolog"));
}

TEST(HtmlReport, ChangesSinceTheLastCalibrationStandBesideTheQuantities) {
  const calibration::Calibration c = complete_calibration();
  EXPECT_NE(report_of(c).find("There is no earlier calibration of this joint"), std::string::npos);
  history::Comparison since;
  since.first.facts.measured_at = "2026-01-04T10:00:00Z";
  since.first.id = "0123456789abcdef";
  history::ComparedQuantity angle;
  angle.name = to_string(c.judgement.quantities.front().quantity);
  angle.unit = "rad";
  angle.second = c.judgement.quantities.front().estimate;
  angle.change = history::Change{{0.01, 0.008, 0.012, {}}, {}, 1e-6};
  angle.word = history::ChangeWord::changed;
  since.quantities = {angle};
  const std::string html = report::document::html_report(c, {}, {}, sample_provenance(), {since});
  const std::size_t at = html.find("id=\"table-quantities\"");
  const std::string table = html.substr(at, html.find("</section>", at) - at);
  EXPECT_NE(table.find("Since <span class=\"unit\">2026-01-04</span></th>"), std::string::npos);
  EXPECT_NE(table.find("<bdi>+0.57°</bdi> <small><bdi>± 0.11</bdi></small> <small "
                       "class=\"word\">changed</small></td>"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("<code>0123456789</code>"), std::string::npos);
}

TEST(HtmlReport, TheWeightiestThreeFindingsAreOnPageOne) {
  calibration::Calibration c = complete_calibration();
  const Statement lowers = Statement::verbatim("five");
  c.judgement.findings = {Statement::verbatim("one"), Statement::verbatim("two"),
                          Statement::verbatim("three"), Statement::verbatim("four"), lowers};
  c.judgement.quantities.resize(1);
  c.judgement.quantities.front().verdict = calibration::Verdict::doubtful;
  c.judgement.quantities.front().reasons = {lowers};
  const std::string html = report_of(c);
  const std::size_t at = html.find("id=\"verdict\"");
  const std::string banner = html.substr(at, html.find("</section>", at) - at);
  // That on which a number's verdict rests comes first.
  EXPECT_LT(banner.find("Five."), banner.find("One."));
  EXPECT_NE(banner.find("Two."), std::string::npos);
  EXPECT_EQ(banner.find("Three."), std::string::npos);
  EXPECT_NE(banner.find("<a href=\"#findings\">"), std::string::npos);
  EXPECT_GT(html.find("Four."), html.find("id=\"findings\""));
}

TEST(HtmlReport, ChecksOnTheDataStandWithNumberAndLimit) {
  const std::string html = report_of(complete_calibration());
  const std::size_t at = html.find("id=\"check-speed-scale\"");
  ASSERT_NE(at, std::string::npos);
  const std::string row = html.substr(at, html.find("</tr>", at) - at);
  for (const char* text : {"fails", "2.00", "0.98 to 1.02", "Factor 2 ± 0.01.", "run_07.csv",
                           "Speeds are wrong.", "Correct the unit."}) {
    EXPECT_NE(row.find(text), std::string::npos) << text << " in\n" << row;
  }
  EXPECT_NE(html.find("1.25\u00a0%"), std::string::npos);
  EXPECT_NE(html.find("≤ 5\u00a0%"), std::string::npos);
}

TEST(HtmlReport, TheResultCanBeReadBackFromIt) {
  const calibration::Calibration c = complete_calibration();
  const std::string html = report_of(c);
  const std::string start = "<script type=\"application/json\" id=\"tribolog-result\">";
  const std::size_t from = html.find(start) + start.size();
  const std::string embedded = html.substr(from, html.find("</script>", from) - from);
  EXPECT_EQ(nlohmann::json::parse(embedded),
            nlohmann::json::parse(calibration::calibration_json(c, sample_provenance())));
}

TEST(HtmlReport, AFailedFigureLeavesAPlaceholderWithTheReason) {
  const calibration::Calibration c = complete_calibration();
  const auto figures = sample_figures(c);
  auto drawn = sample_pictures(figures);
  drawn[2].png.clear();
  drawn[2].error = Statement::verbatim("no off-screen context <could> be made");
  const std::string html = report::document::html_report(c, figures, drawn, sample_provenance());
  EXPECT_NE(html.find("1 figure missing"), std::string::npos);
  EXPECT_NE(html.find("No off-screen context &lt;could&gt; be made."), std::string::npos);
  EXPECT_EQ(occurrences(html, "<img "), figures.size() - 1);
}

// What is said of a figure is stated where it is drawn and becomes words on the page.
TEST(HtmlReport, SpeaksOfItsFiguresInThePagesLanguage) {
  const calibration::Calibration c = complete_calibration();
  const auto figures = sample_figures(c);
  auto drawn = sample_pictures(figures);
  const StatedValue series{"series", render::figure::name_of_series("tarcie", 0)};
  drawn[0].warnings = {{"drawing.samples_not_finite", {series, {"dropped", 2}, {"all", 6}}}};
  drawn[1].png.clear();
  drawn[1].error = {"drawing.process_lost",
                    {{"end", Statement{"drawing.stopped_by_signal",
                                       {{"signal", 11}, {"name", "Segmentation fault"}}}}}};
  const std::string english = report::document::html_report(c, figures, drawn, sample_provenance());
  EXPECT_NE(english.find("series &#39;tarcie&#39;: dropped 2 of 6 samples that are not finite"),
            std::string::npos);
  EXPECT_NE(english.find("The drawing process was lost: it was stopped by signal 11 "
                         "(Segmentation fault)."),
            std::string::npos);
  const std::string polish =
      report::document::html_report(c, figures, drawn, sample_provenance(), {std::nullopt, {"pl"}});
  EXPECT_NE(polish.find("seria &#39;tarcie&#39;: pominięto 2 z 6 próbek, które nie są skończone"),
            std::string::npos);
  EXPECT_NE(polish.find("Utracono proces rysujący: zatrzymał go sygnał 11 (Segmentation fault)."),
            std::string::npos);
  EXPECT_EQ(polish.find("dropped"), std::string::npos);
  EXPECT_EQ(polish.find("drawing process"), std::string::npos);
}

TEST(HtmlReport, WithoutFiguresItIsStillWhole) {
  const std::string html = report::document::html_report(sweep_only(), {}, {}, sample_provenance());
  EXPECT_EQ(html.find("<figure"), std::string::npos);
  EXPECT_EQ(html.find("figures missing"), std::string::npos);
  EXPECT_NE(html.find("</html>"), std::string::npos);
}

TEST(HtmlReport, TheFirstThreeFiguresLoadAtOnce) {
  const std::string html = report_of(complete_calibration());
  EXPECT_EQ(occurrences(html, "loading=\"eager\""), 3U);
  EXPECT_EQ(occurrences(html, "loading=\"lazy\""), 5U);
  EXPECT_EQ(occurrences(html, "width=\"1600\" height=\"1000\""), 8U);
}

TEST(HtmlReport, AnEmptyCalibrationReadsWell) {
  const joint::Dataset nothing;
  const std::string html = report_of(identify::identify(nothing));
  EXPECT_NE(html.find("Robot not named"), std::string::npos);
  EXPECT_EQ(html.find("unknown N·m"), std::string::npos);
  EXPECT_EQ(html.find(">nan<"), std::string::npos);
}

TEST(HtmlReport, TheSimulatedJointsMassAppears) {
  const joint::Dataset dataset = simulate::simulated_dataset(paper_joint());
  const std::string html = report_of(identify::identify(dataset));
  EXPECT_NE(html.find("79.167"), std::string::npos);
  EXPECT_EQ(html.find("Table 2 of the paper"), std::string::npos) << "stands on the paper's page";
}

}  // namespace
}  // namespace tribolog::test::html_report_test
