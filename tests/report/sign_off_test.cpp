#include "report/document/sign_off.h"

#include <cstddef>

#include <gtest/gtest.h>

#include "base/error.h"
#include "report/sample_calibration.h"

namespace tribolog::sign_off_test {
namespace {

const report::document::SignOff rejected{"2026-12-24T12:00:00Z", "A. Reviewer", false, "too warm"};
const report::document::SignOff approved{"2027-01-08T08:30:00Z", "B", true, ""};

class SignedReport : public testing::Test {
 protected:
  const std::string report_ = test::report_of(test::complete_calibration());
};

TEST_F(SignedReport, ShowsTheLastDecisionAheadOfTheVerdict) {
  const std::string page =
      report::document::with_sign_off(report_, "abc", {rejected, approved}, "r.html");
  const std::size_t at = page.find("id=\"sign-off\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(at, page.find("id=\"verdict\""));
  EXPECT_NE(page.find("Approved by <bdi>B</bdi>, 2027-01-08 08:30 UTC."), std::string::npos);
  EXPECT_NE(page.find("<summary>Earlier decisions: 1</summary>"), std::string::npos);
  EXPECT_NE(
      page.find("<li>Rejected by <bdi>A. Reviewer</bdi>, 2026-12-24 12:00 UTC. <bdi>too warm"),
      std::string::npos);
}

TEST_F(SignedReport, LosesNoByteOfTheReport) {
  const std::string once = report::document::with_sign_off(report_, "abc", {rejected}, "r.html");
  EXPECT_TRUE(report::document::without_sign_off(once) == report_);
  EXPECT_TRUE(report::document::with_sign_off(once, "abc", {rejected, approved}, "r.html") ==
              report::document::with_sign_off(report_, "abc", {rejected, approved}, "r.html"));
  EXPECT_TRUE(report::document::without_sign_off(report_) == report_);
}

TEST_F(SignedReport, TextsOfReviewersAreText) {
  const report::document::SignOff hostile{
      "2026-12-24T12:00:00Z", "<script>alert(1)</script>", true,
      "<!-- end of sign-off -->\n<img src=x onerror=alert(1)>\xff"};
  const std::string page = report::document::with_sign_off(report_, "<b>", {hostile}, "r.html");
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
  EXPECT_NE(page.find("<code>&lt;b&gt;</code>"), std::string::npos);
  EXPECT_TRUE(report::document::without_sign_off(page) == report_);
}

TEST(SignOff, NeedsAReport) {
  EXPECT_THROW((void)report::document::with_sign_off("<html></html>", "abc", {approved}, "r.html"),
               InputError);
}

}  // namespace
}  // namespace tribolog::sign_off_test
