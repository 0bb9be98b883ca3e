// `tribolog show` and `tribolog review`, as a user would call them.

#include <cstddef>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"

namespace tribolog::test::review_test {
namespace {

using nlohmann::json;

class ReviewCommands : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramRun made =
        run("report dataset.toml -o r.html --truth-runs 0 --no-figures --archive "
            "a.tribolog");
    ASSERT_EQ(made.status, 0) << made.err;
    original_ = read_text(dataset_.file("r.html"));
    id_ = json::parse(run("archive list --json --archive a.tribolog").out)["calibrations"][0]["id"];
  }
  [[nodiscard]] ProgramRun run(const std::string& command) const {
    return run_shell("cd '" + dataset_.scratch().path() + "' && " + program + command);
  }
  [[nodiscard]] ProgramRun review(const std::string& what) const {
    return run("review " + what + " --archive a.tribolog");
  }
  [[nodiscard]] json reviews() const {
    return json::parse(run("archive show " + id_ + " --json --archive a.tribolog").out)["reviews"];
  }
  SmallDataset dataset_;
  std::string original_;
  std::string id_;
};

TEST_F(ReviewCommands, AReportIsSignedAndItsOriginalStays) {
  const ProgramRun rejected =
      review("r.html --reject --reviewer 'A. Reviewer' --note 'gearbox was cold'");
  ASSERT_EQ(rejected.status, 0) << rejected.err;
  EXPECT_EQ(rejected.out, id_.substr(0, 10) + " rejected by A. Reviewer\nreport: r.html\n");
  const std::string once = read_text(dataset_.file("r.html"));
  EXPECT_NE(once.find("gearbox was cold"), std::string::npos);
  // The signed report is the same report.
  ASSERT_EQ(review("r.html --approve --reviewer B").status, 0);
  ASSERT_EQ(reviews().size(), 2U);
  EXPECT_EQ(reviews()[0]["note"], "gearbox was cold");
  EXPECT_EQ(reviews()[1]["decision"], "approved");
  const auto listed = [this](const std::string& how) {
    return run("archive list --archive a.tribolog" + how).out;
  };
  EXPECT_EQ(json::parse(listed(" --json"))["calibrations"][0]["decision"], "approved");
  EXPECT_NE(listed("").find("approved"), std::string::npos);
  const json fleet = json::parse(run("archive fleet --json --archive a.tribolog -o f.html").out);
  EXPECT_EQ(fleet["robots"][0]["joints"][0]["decision"], "approved");
  EXPECT_NE(read_text(dataset_.file("f.html")).find("approved"), std::string::npos);
  const std::string twice = read_text(dataset_.file("r.html"));
  EXPECT_NE(twice.find("Earlier decisions: 1"), std::string::npos);

  const std::string from_archive = "archive report " + id_ + " --archive a.tribolog -o ";
  ASSERT_EQ(run(from_archive + "signed.html").status, 0);
  EXPECT_TRUE(read_text(dataset_.file("signed.html")) == twice);
  ASSERT_EQ(run(from_archive + "original.html --original").status, 0);
  EXPECT_TRUE(read_text(dataset_.file("original.html")) == original_);
  const ProgramRun verified = run("archive verify --archive a.tribolog");
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
}

class Remarks : public ReviewCommands {
 protected:
  void SetUp() override {
    const ProgramRun made =
        run("simulate " TRIBOLOG_SOURCE_DIR "/examples/paper/scenario.toml -o d && " + program +
            "report d/dataset.toml -o r.html --no-figures --archive a.tribolog");
    ASSERT_EQ(made.status, 0) << made.err;
    original_ = read_text(dataset_.file("r.html"));
    id_ = json::parse(run("archive list --json --archive a.tribolog").out)["calibrations"][0]["id"];
    const std::string opening = R"(id="tribolog-loops">)";
    const std::size_t from = original_.find(opening) + opening.size();
    number_ =
        json::parse(original_.substr(from, original_.find("</script>", from) - from))["report"];
  }
  /// As the viewer saves them.
  void save(const std::string& report, const std::string& text) const {
    const json remarks{{{"place", "loop.csv, t 0.3 s, T 0.2 N·m"}, {"text", text}}};
    dataset_.scratch().write("remarks.json", json{{"report", report}, {"remarks", remarks}}.dump());
  }
  [[nodiscard]] ProgramRun approve() const {
    return review("r.html --approve --reviewer B --note 'once more' --remarks remarks.json");
  }
  std::string number_;
};

TEST_F(Remarks, OnPointsBecomePartOfTheNote) {
  save(number_, "a step <here>");
  const ProgramRun done = approve();
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(reviews()[0]["note"], "once more\n[1] loop.csv, t 0.3 s, T 0.2 N·m: a step <here>");
  EXPECT_NE(read_text(dataset_.file("r.html")).find("a step &lt;here&gt;"), std::string::npos);
}

TEST_F(Remarks, ThatAreNotThisReportsAreRefused) {
  const auto expect_refused = [&](const std::string& why) {
    const ProgramRun refused = approve();
    EXPECT_EQ(refused.status, 3) << refused.err;
    EXPECT_NE(refused.err.find("remarks.json: " + why), std::string::npos) << refused.err;
  };
  save("tribolog-000000000000", "a step");
  expect_refused("these remarks are on another report, found tribolog-000000000000");
  save(number_, "");
  expect_refused("a remark without place or text");
  for (const char* text : {"{", "[1]", R"({"remarks": []})"}) {
    dataset_.scratch().write("remarks.json", text);
    expect_refused("no remarks");
  }
  EXPECT_EQ(review("r.html --approve --reviewer B --remarks no.json").status, 3);
  EXPECT_EQ(review("r.html --approve --reviewer B --remarks r.html").status, 2);
  EXPECT_TRUE(reviews().empty());
  EXPECT_TRUE(read_text(dataset_.file("r.html")) == original_);
}

TEST_F(ReviewCommands, AnIdIsReviewedWithoutAFile) {
  ASSERT_EQ(review(id_.substr(0, 8) + " --approve --reviewer B").status, 0);
  EXPECT_EQ(reviews().size(), 1U);
  EXPECT_TRUE(read_text(dataset_.file("r.html")) == original_);
  ASSERT_EQ(review(id_ + " --approve --reviewer B -o new.html").status, 0);
  EXPECT_NE(read_text(dataset_.file("new.html")).find("Earlier decisions: 1"), std::string::npos);
}

TEST_F(ReviewCommands, WhatIsNotTheArchivedReportIsRefused) {
  dataset_.scratch().write("other.html", original_ + " ");
  const ProgramRun changed = review("other.html --approve --reviewer B");
  EXPECT_EQ(changed.status, 3);
  EXPECT_EQ(changed.err,
            "tribolog: error: other.html: this report is not in the archive, expected one that it "
            "contains, unchanged; hint: the archive has another report of these inputs: tribolog "
            "archive report " +
                id_.substr(0, 10) + " -o FILE gives it, tribolog review " + id_.substr(0, 10) +
                " decides on it\n");
  dataset_.scratch().write("page.html", "<html></html>");
  EXPECT_EQ(review("page.html --approve --reviewer B").status, 3);
  EXPECT_EQ(review("r.html --approve --reviewer ' '").status, 2);
  EXPECT_EQ(review("r.html --reviewer B").status, 2);
  EXPECT_EQ(review("r.html --approve --reject --reviewer B").status, 2);
  EXPECT_EQ(review(id_ + " --approve --reviewer B -o nowhere/x.html").status, 4);
  EXPECT_EQ(review(id_ + " --approve --reviewer B -o a.tribolog").status, 2);
  EXPECT_TRUE(reviews().empty()) << "nothing was decided";
  EXPECT_TRUE(read_text(dataset_.file("r.html")) == original_);
}

TEST_F(ReviewCommands, ShowReadsTheNumbersOfAReport) {
  const ProgramRun of_report = run("show r.html");
  ASSERT_EQ(of_report.status, 0) << of_report.err;
  EXPECT_NE(of_report.out.find("test robot"), std::string::npos);
  EXPECT_NE(of_report.out.find("quantity"), std::string::npos);
  EXPECT_EQ(run("show r.calibration.json").out, of_report.out);
  json numbers = json::parse(run("show r.html --json").out);
  json written = json::parse(read_text(dataset_.file("r.calibration.json")));
  EXPECT_EQ(numbers["provenance"]["inputs"], written["provenance"]["inputs"]);
  numbers.erase("provenance");  // the report's says what drew it, and its id in the archive
  written.erase("provenance");
  EXPECT_TRUE(numbers == written);
  dataset_.scratch().write("page.html", "<html></html>");
  const ProgramRun refused = run("show page.html");
  EXPECT_EQ(refused.status, 3);
  EXPECT_EQ(
      refused.err,
      "tribolog: error: page.html: no page of tribolog with its numbers; hint: `tribolog show` "
      "reads the reports and pages that tribolog writes, and calibrations\n");
}

}  // namespace
}  // namespace tribolog::test::review_test
