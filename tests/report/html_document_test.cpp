// The document as an independent parser sees it.

#include <gtest/gtest.h>

#include "report/document_checks.h"
#include "report/run_python.h"
#include "report/sample_calibration.h"

namespace tribolog::test::html_document_test {
namespace {

void expect_sound(const calibration::Calibration& c) {
  if (!has_python_module("html.parser")) GTEST_SKIP() << "python3 is not installed";
  EXPECT_TRUE(run_python(checks, report_of(c)));
}

TEST(HtmlDocument, IsSoundWhenComplete) { expect_sound(complete_calibration()); }

TEST(HtmlDocument, IsSoundWhenHalfIsMissing) { expect_sound(sweep_only()); }

TEST(HtmlDocument, IsSoundWhenEmpty) { expect_sound(calibration::Calibration{}); }

}  // namespace
}  // namespace tribolog::test::html_document_test
