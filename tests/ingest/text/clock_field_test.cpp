// Time stamps to the nanosecond.

#include <gtest/gtest.h>

#include "ingest/text/fields.h"

namespace tribolog::clock_field_test {
namespace {

double between(std::string_view from, std::string_view to,
               std::optional<ingest::text::ClockReading> (*read)(std::string_view)) {
  const auto a = read(from);
  const auto b = read(to);
  EXPECT_TRUE(a && b) << from << " " << to;
  return a && b ? b->since(*a) : 0;
}

double iso(std::string_view from, std::string_view to) {
  return between(from, to, ingest::text::read_iso_time);
}

double number(std::string_view from, std::string_view to) {
  return between(from, to, [](std::string_view f) { return ingest::text::read_clock_number(f); });
}

TEST(ClockField, KeepsNanosecondsOfNumbersThatNoDoubleHolds) {
  EXPECT_EQ(number("1700000000123456789", "1700000000123456790"), 1);
  EXPECT_NEAR(number("1700000000.123456789", "1700000000.123456790"), 1e-9, 1e-17);
  EXPECT_NEAR(number("-1.25", "1.5"), 2.75, 1e-15);
  EXPECT_EQ(number(" -3 ", "+0"), 3) << "a sign in front";
}

TEST(ClockField, ReadsIsoTimesInTheirUsualSpellings) {
  const char* const start = "1970-01-01T00:00:00Z";
  EXPECT_EQ(iso(start, "1970-01-02T00:00:01Z"), 86401);
  EXPECT_EQ(iso(start, "2000-03-01 00:00:00"), 951868800);  // a leap year of the century
  EXPECT_NEAR(iso("2026-03-01T08:15:00.000000001Z", "2026-03-01T08:15:00,000000003Z"), 2e-9, 1e-17);
  EXPECT_EQ(iso("2026-03-01T08:15:00Z", "2026-03-01T09:15:00+01:00"), 0);
  EXPECT_EQ(iso("2026-03-01T08:15:00Z", "2026-03-01T07:45:00-0030"), 0);
  EXPECT_EQ(iso("2026-12-31T23:59:59.5Z", "2027-01-01T00:00:00.25Z"), 0.75);
}

TEST(ClockField, TakesNothingElse) {
  for (const char* field : {"", "2026-03-01", "2026-02-30T00:00:00Z", "2026-03-01T24:00:00Z",
                            "2026-03-01T08:15:00.Z", "2026-03-01T08:15:00Zulu", "08:15:00",
                            "2026-03-01T08:15:00+1", "26-03-01T08:15:00", "\xff\xfe"}) {
    EXPECT_FALSE(ingest::text::read_iso_time(field)) << field;
  }
  for (const char* field :
       {"", "-", "1e9", "1.5.5", "1,5", "0x10", "12345678901234567890", "nan"}) {
    EXPECT_FALSE(ingest::text::read_clock_number(field)) << field;
  }
  EXPECT_TRUE(ingest::text::read_clock_number("1,5", ingest::text::DecimalMark::comma));
  EXPECT_FALSE(ingest::text::read_clock_number("1.5", ingest::text::DecimalMark::comma));
}

TEST(ClockField, ReadsTimesOfDayAndDates) {
  const auto of_day = [](std::string_view field) {
    const auto read = ingest::text::read_time_of_day(field);
    return read ? static_cast<double>(read->whole) + read->rest : -1;
  };
  EXPECT_EQ(of_day("08:15:00.25"), 29700.25);
  EXPECT_EQ(of_day(" 8:15:00,25 "), 29700.25);
  EXPECT_EQ(of_day("00:00:00"), 0);
  for (const char* none :
       {"24:00:00", "08:60:00", "08:15", "08:15:0", "8.15.00", "08:15:00Z", ""}) {
    EXPECT_EQ(of_day(none), -1) << none;
  }
  const auto day = [](std::string_view field) {
    const auto read = ingest::text::read_date(field);
    return read ? read->whole / 86400 : -1;
  };
  EXPECT_EQ(day("1970-01-02"), 1);
  EXPECT_EQ(day("2000/03/01"), 11017);
  EXPECT_EQ(day("01.03.2000"), 11017);
  for (const char* none : {"2026-02-29", "01/03/2026", "26-03-01", "2026-3-1", "2026-03/01"}) {
    EXPECT_EQ(day(none), -1) << none;
  }
}

}  // namespace
}  // namespace tribolog::clock_field_test
