#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <locale>
#include <string>

#include <gtest/gtest.h>

#include "ingest/text/fields.h"

#if __has_include(<rapidcheck/gtest.h>)
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#endif

namespace tribolog::number_field_test {
namespace {

void expect_number(const std::string& field, double value) {
  const ingest::text::NumberField read = ingest::text::read_number(field);
  EXPECT_EQ(read.kind, ingest::text::FieldKind::number) << field;
  EXPECT_EQ(read.value, value) << field;
}

TEST(NumberField, ReadsDecimalNumbersInEveryUsualForm) {
  expect_number("3.14", 3.14);
  expect_number("+1", 1);
  expect_number("1.", 1);
  expect_number(".5", 0.5);
  expect_number("-.5e-3", -0.5e-3);
  expect_number("6E+2", 600);
  expect_number(" \t7 ", 7);
  expect_number("007", 7);
  EXPECT_TRUE(std::signbit(ingest::text::read_number("-0").value));
}

TEST(NumberField, TakesWordsForNothingAsGaps) {
  for (const char* gap : {"",          " ",       "nan",     "NaN",    "-nan", "-nan(ind)", "inf",
                          "-Infinity", "1.#QNAN", "-1.#IND", "1.#INF", "NULL", "N/A",       "NaT",
                          "None",      "-",       "--",      "#N/A",   "NA",   "#NA"}) {
    EXPECT_EQ(ingest::text::read_number(gap).kind, ingest::text::FieldKind::gap) << gap;
    EXPECT_TRUE(std::isnan(ingest::text::read_number(gap).value)) << gap;
  }
}

TEST(NumberField, RefusesEverythingElse) {
  for (const char* text : {"1,25", "1 234.5", "1\u00a0234", "0x1p3", "1d3", "1.2.3", "true", "--1",
                           "+-1", "++1", "1e", "e5", ".", "+", "٣", "12abc", "1_000"}) {
    EXPECT_EQ(ingest::text::read_number(text).kind, ingest::text::FieldKind::text) << text;
  }
}

TEST(NumberField, TellsTooLargeFromTooSmall) {
  const std::string zeros(400, '0');
  for (const std::string& large :
       {std::string("1e400"), std::string("-1e400"), "1" + zeros, std::string("0.0001e999"),
        std::string("1e99999999999999999999")}) {
    EXPECT_EQ(ingest::text::read_number(large).kind, ingest::text::FieldKind::overflow) << large;
  }
  for (const std::string& small :
       {std::string("1e-400"), "0." + zeros + "1", std::string("-1000e-999"),
        std::string("1e-99999999999999999999")}) {
    expect_number(small, 0.0);
  }
}

TEST(NumberField, RecognisesDecimalCommasAndCutNumbers) {
  EXPECT_TRUE(ingest::text::looks_like_decimal_comma("1,25"));
  EXPECT_TRUE(ingest::text::looks_like_decimal_comma("-0,5e3"));
  EXPECT_FALSE(ingest::text::looks_like_decimal_comma("1,2,3"));
  EXPECT_FALSE(ingest::text::looks_like_decimal_comma(",5"));
  EXPECT_FALSE(ingest::text::looks_like_decimal_comma("a,b"));
  EXPECT_TRUE(ingest::text::looks_like_cut_number("-"));
  EXPECT_TRUE(ingest::text::looks_like_cut_number("1.5e-"));
  EXPECT_TRUE(ingest::text::looks_like_cut_number("na"));
  EXPECT_FALSE(ingest::text::looks_like_cut_number("abc"));
}

/// Decimal comma and thousands dot, as in de_DE, whether that locale is installed or not.
class German : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(NumberField, IsTheSameUnderEveryLocale) {
  const std::locale cpp_before =
      std::locale::global(std::locale(std::locale::classic(), new German));
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed
  expect_number("3.14", 3.14);
  expect_number("1234567.5", 1234567.5);
  EXPECT_EQ(ingest::text::read_number("3,14").kind, ingest::text::FieldKind::text);
  EXPECT_EQ(ingest::text::read_number("1e400").kind, ingest::text::FieldKind::overflow);
  std::setlocale(LC_ALL, c_before.c_str());
  std::locale::global(cpp_before);
}

#if __has_include(<rapidcheck/gtest.h>)
RC_GTEST_PROP(NumberFieldProperty, ReadsBackWhatToCharsWrites, (double value)) {
  RC_PRE(std::isfinite(value));
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value);
  const ingest::text::NumberField read =
      ingest::text::read_number({text, static_cast<std::size_t>(written.ptr - text)});
  RC_ASSERT(read.kind == ingest::text::FieldKind::number);
  RC_ASSERT(read.value == value);
}
#endif

TEST(Thousands, AreGroupsOfThreeDigits) {
  for (const char* text :
       {"1,234.5", "1 234.5", "1'234", "1\u00a0234", "-1,234,567", "12\u202f345.6"}) {
    EXPECT_TRUE(ingest::text::looks_like_thousands(text)) << text;
  }
  for (const char* text : {"1234.5", "1,25", "1,2345", "1.234", "a 123", "", ",", " 1 "}) {
    EXPECT_FALSE(ingest::text::looks_like_thousands(text)) << text;
  }
  EXPECT_TRUE(ingest::text::looks_like_thousands("1.234,5", ingest::text::DecimalMark::comma));
  EXPECT_FALSE(ingest::text::looks_like_thousands("1.25", ingest::text::DecimalMark::comma));
}

}  // namespace
}  // namespace tribolog::number_field_test
