#include "report/timeline/fleet_page.h"

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "history/sample_fleet.h"
#include "report/timeline/sparkline.h"
#include "support/run_program.h"

namespace tribolog::archive::fleet_page_test {
namespace {

using test::measured_fleet;

calibration::Provenance sample_provenance() {
  calibration::Provenance p;
  p.tool_version = "0.1.0";
  p.created_utc = "2026-12-24T12:00:00Z";
  p.command_line = "tribolog archive fleet";
  return p;
}

std::string page_of(const std::vector<calibration::Measured>& measured,
                    const report::timeline::FleetLinks& links = {}) {
  return report::timeline::fleet_page(history::fleet_of(measured),
                                      history::joint_trends(measured, {}), links, "a.tribolog",
                                      sample_provenance());
}

std::vector<calibration::Measured> one_worn(const test::FleetSize& size) {
  std::vector<calibration::Measured> all = test::measured_fleet(size, 11);
  auto& latest = all[static_cast<std::size_t>(size.calibrations) - 1];
  latest.quantities[7].estimate = statistics::scaled(*latest.quantities[7].estimate, 1.5);
  return all;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(FleetPage, OfFiveHundredRobotsStaysUnderTenMegabytes) {
  const std::string page = page_of(one_worn({500, 6, 10}));
  constexpr std::size_t most_bytes = 10'000'000;
  EXPECT_LT(page.size(), most_bytes);
  EXPECT_EQ(count_of(page, "<table class=\"fleet\""), 50U);
  EXPECT_EQ(count_of(page, "<th scope=\"row\">"), 3000U);
  // A picture for each result, of the outliers a second one, and that of the explanation.
  EXPECT_GE(count_of(page, "<svg"), 30'000U + 2U);
  EXPECT_EQ(count_of(page, "<script"), 1U);
  EXPECT_NE(page.find("content-visibility: auto"), std::string::npos);
}

TEST(FleetPage, ShowsTheOutlierFirst) {
  const std::string page = page_of(one_worn({20, 2, 6}));
  EXPECT_NE(page.find("1 of 40 joints stands out"), std::string::npos);
  ASSERT_EQ(count_of(page, "<article class=\"outlier\">"), 1U);
  const std::string card =
      page.substr(page.find("<article"), page.find("</article>") - page.find("<article"));
  for (const char* part : {"<bdi>J1</bdi>", "R1000 · S1000", "<b>Coulomb torque</b>",
                           "against 19 other robots", "against 5 earlier ones of its own"}) {
    EXPECT_NE(card.find(part), std::string::npos) << part << " in\n" << card;
  }
  EXPECT_LT(page.find("<article"), page.find("id=\"robots\""));
  const std::string first = page.substr(page.find("<tr><td class=\"of\">"), 80);
  EXPECT_NE(first.find("R1000"), std::string::npos) << first;
  EXPECT_EQ(count_of(page, "class=\"out\""), 1U);
  const std::string none = page_of(test::measured_fleet({20, 2, 6}, 12));
  EXPECT_NE(none.find("NO OUTLIER"), std::string::npos);
  EXPECT_NE(page_of({}).find("NOTHING TO COMPARE"), std::string::npos);
}

// One that wears slowly is far from no other yet, and is named first all the same.
TEST(FleetPage, ListsTheJointThatChanges) {
  const test::FleetSize size{6, 1, 20};
  std::vector<calibration::Measured> all = test::measured_fleet(size, 5);
  EXPECT_EQ(page_of(all).find("Joints that change"), std::string::npos);
  for (std::size_t k = 0; k < 20; ++k) {
    auto& torque = all[k].quantities[7];
    torque.estimate = statistics::scaled(*torque.estimate, 1 + 0.02 * static_cast<double>(k));
  }
  const std::string page = page_of(all);
  EXPECT_NE(page.find("1 of 6 joints changes over time."), std::string::npos);
  EXPECT_NE(
      page.find("<li><b><bdi>R1000 · S1000</bdi>, joint <bdi>J1</bdi>:</b> Coulomb torque has"),
      std::string::npos);
  EXPECT_LT(page.find("Joints that change"), page.find("How to read it"));
}

TEST(FleetPage, LinksToReportsThatAreThere) {
  const std::vector<calibration::Measured> all = one_worn({8, 1, 5});
  const std::string id = all[4].entry.id;
  const report::timeline::FleetLinks links{{id}, "reports \"of\" <all>%:javascript"};
  const std::string page = page_of(all, links);
  const std::string href =
      "href=\"reports%20%22of%22%20%3Call%3E%25%3Ajavascript/" + id + ".html\"";
  EXPECT_EQ(count_of(page, href), 2U);  // its card and its row
  EXPECT_EQ(count_of(page, "<a href="), 2U);
  const std::string command =
      "tribolog archive report " + id.substr(0, calibration::shown_digits) + " -o ";
  EXPECT_EQ(page.find(command), std::string::npos);
  report::timeline::FleetLinks beside;
  beside.found[id] = "reports/a b.html";
  EXPECT_EQ(count_of(page_of(all, beside), "href=\"reports/a%20b.html\""), 2U);
  const std::string without = page_of(all);
  EXPECT_EQ(count_of(without, "<a href="), 0U);
  EXPECT_NE(without.find(command), std::string::npos);
}

TEST(FleetPage, LinksToTheTrendsOfItsRobots) {
  report::timeline::FleetLinks links;
  links.trends[{"R1000", "S1000"}] = "trends/R1000.S1000.html";
  const std::string page = page_of(one_worn({8, 2, 5}), links);
  EXPECT_EQ(count_of(page, "href=\"trends/R1000.S1000.html\""), 3U);  // its card and two joints
  EXPECT_EQ(count_of(page, "<a class=\"trend\" href="), 2U);
  EXPECT_EQ(count_of(page, "<caption"), 1U);
}

TEST(FleetPage, KeepsResultsBelowTheirHeadings) {
  std::vector<calibration::Measured> all = test::measured_fleet({1, 2, 1}, 13);
  // The first joint without its inertia, and with a doubtful Coulomb torque.
  all[0].quantities[6].estimate.reset();
  all[0].quantities[7].verdict = calibration::Verdict::doubtful;
  // Of the second, the data do not show the mass: the number that is there is none.
  all[1].quantities[2].verdict = calibration::Verdict::not_identifiable;
  const std::string page = page_of(all);
  EXPECT_EQ(count_of(page, "<thead><tr>"), 1U);
  EXPECT_EQ(count_of(page, "<th scope=\"col\""), 14U);
  EXPECT_EQ(count_of(page, "<td"), 26U);  // of each joint robot, day and ID too
  EXPECT_EQ(count_of(page, "<td></td>"), 2U);
  EXPECT_EQ(count_of(page, "<td class=\"doubt\" data-name=\"Coulomb torque [N·m]\">"), 1U);
  const std::string first = page.substr(page.find("<tr><td class=\"of\">"));
  const std::string row = first.substr(0, first.find("</tr>"));
  // A quantity that one joint alone has comes behind those of the first joint.
  EXPECT_LT(row.find("data-name=\"Bristle damping ["), row.find("data-name=\"Coulomb torque ["));
  EXPECT_EQ(row.find("data-name=\"Inertia ["), std::string::npos);
}

TEST(FleetPage, HostileNamesAreText) {
  std::vector<calibration::Measured> all = one_worn({8, 1, 5});
  for (std::size_t k = 0; k < 5; ++k) {
    all[k].entry.facts.of = {"<script>alert(1)</script>{{ROBOT}}", "\"><img src=x>\xe2\x80\xae",
                             "../../" + std::string(10000, 'J')};
    all[k].quantities[7].words = "' onmouseover='x";
    all[k].quantities[7].unit = "</style><script>";
  }
  const std::string page = page_of(all);
  EXPECT_EQ(count_of(page, "<script"), 1U);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("' onmouseover="), std::string::npos);
  EXPECT_EQ(page.find("\xe2\x80\xae"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(1)&lt;/script&gt;{{ROBOT}}"), std::string::npos);
  EXPECT_NE(page.find("[U+202E]"), std::string::npos);
}

TEST(FleetPage, IsWellFormed) {
  const test::TemporaryDirectory directory;
  const std::string page = directory.file("page.html", page_of(one_worn({8, 2, 5})));
  const std::string script = directory.file("check.py", R"(
import sys
from html.parser import HTMLParser
void = {'meta', 'br', 'path', 'link', 'img', 'circle', 'input'}
class Check(HTMLParser):
    stack = []
    def handle_starttag(self, tag, attributes):
        if tag not in void: self.stack.append(tag)
    def handle_startendtag(self, tag, attributes): pass
    def handle_endtag(self, tag):
        assert self.stack and self.stack.pop() == tag, (tag, self.getpos())
check = Check()
check.feed(open(sys.argv[1], encoding='utf-8').read())
assert not check.stack, check.stack
)");
  const auto run = test::run_shell("python3 '" + script + "' '" + page + "'");
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST(Sparkline, ShowsWhereTheLatestLies) {
  const history::Fleet fleet = history::fleet_of(one_worn({8, 1, 5}));
  const history::FleetCell& worn = fleet.robots[0].joints[0].cells[7];
  const report::timeline::Sparkline line = report::timeline::sparkline_of(worn, fleet);
  int x = 0;
  int y = 0;
  ASSERT_EQ(std::sscanf(line.latest.c_str(), "M%d %dh0", &x, &y), 2);
  int top = 0;
  int height = 0;
  ASSERT_EQ(std::sscanf(line.band.c_str(), "M0 %dh184v%dH0z", &top, &height), 2) << line.band;
  EXPECT_LT(y, top);  // above the band
  EXPECT_GT(height, 0);
  EXPECT_LE(top + height, report::timeline::sparkline_height);
  const history::FleetCell& calm = fleet.robots[1].joints[0].cells[7];
  const report::timeline::Sparkline quiet = report::timeline::sparkline_of(calm, fleet);
  ASSERT_EQ(std::sscanf(quiet.latest.c_str(), "M%d %dh0", &x, &y), 2);
  ASSERT_EQ(std::sscanf(quiet.band.c_str(), "M0 %dh184v%d", &top, &height), 2);
  EXPECT_GT(y, top);
  EXPECT_LT(y, top + height);
}

}  // namespace
}  // namespace tribolog::archive::fleet_page_test
