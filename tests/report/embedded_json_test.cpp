#include "report/engine/embedded_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "calibration/calibration_json.h"
#include "report/document/html_report.h"
#include "report/sample_calibration.h"

namespace tribolog::embedded_json_test {
namespace {

std::string page_of(const std::string& numbers) {
  return "<!DOCTYPE html>\n<html>\n<script type=\"application/json\" id=\"tribolog-result\">" +
         numbers + "</script></html>";
}

std::string refusal(const std::string& page) {
  return test::refusal_of<InputError>(
      [&] { return report::engine::embedded_json(page, "a.html"); });
}

TEST(EmbeddedJson, IsReadAgain) {
  const report::engine::EmbeddedJson found =
      report::engine::embedded_json(page_of(R"({"a": "\u003c/script>"})"), "a.html");
  EXPECT_EQ(found.element, "tribolog-result");
  EXPECT_EQ(found.json, R"({"a": "\u003c/script>"})");
}

TEST(EmbeddedJson, AReportGivesItsCalibrationBack) {
  calibration::Calibration calibration = test::complete_calibration();
  calibration.manifest.robot = "</script><script>alert(1)</script> & \u2028 end";
  const report::engine::EmbeddedJson found =
      report::engine::embedded_json(test::report_of(calibration), "report.html");
  EXPECT_EQ(found.element, "tribolog-result");
  EXPECT_EQ(nlohmann::json::parse(found.json), nlohmann::json::parse(calibration::calibration_json(
                                                   calibration, test::sample_provenance())));
}

TEST(EmbeddedJson, OtherPagesAreRefused) {
  EXPECT_EQ(refusal("<html></html>"),
            "a.html: no page of tribolog with its numbers; hint: `tribolog show` reads the reports "
            "and pages that tribolog writes, and calibrations");
  const std::string page = page_of("{}");
  EXPECT_EQ(refusal(page + page),
            "a.html:3: the page holds its numbers twice; hint: take the page as it was written");
  EXPECT_EQ(refusal(page.substr(0, page.size() - 12)),
            "a.html:3: the page is cut off inside its numbers; hint: copy it again");
  EXPECT_EQ(refusal(page_of("{")),
            "a.html:3: the numbers in the page are no JSON; hint: they were changed");
}

}  // namespace
}  // namespace tribolog::embedded_json_test
