// The clock: 30 to 34.

#include <fmt/format.h>

#include "cli/input_cases/case_log.h"
#include "cli/input_cases/input_case.h"

namespace tribolog::test {
namespace {

const std::string from_1970 =
    "log.csv: its clock counts from 1970; here, and in from_s and to_s, time counts from its first "
    "reading, in whole units";
const std::string if_right = "if this is right, state any_rate = true beside the unit";
const std::string split_it = "two logs concatenated? split the file, or correct the unit of time";

using Clock = std::function<std::string(int row, const std::string& t_s)>;

std::string with_clock(const Clock& clock) {
  return case_log([&](int i, Row& row) { row[0] = clock(i, row[0]); });
}

std::string in_units(double per_second, int decimals = 0) {
  return with_clock([&](int, const std::string& t) { return scaled(t, per_second, 0, decimals); });
}

std::string read_in(const std::string& unit) {
  return case_manifest("\"t\", unit = \"s\"", "\"t\", unit = \"" + unit + "\"");
}

std::string iso(int /*row*/, const std::string& t) {
  return "2026-03-01T08:15:" + fmt::format("{:05.2f}", std::stod(t)) + "Z";
}

InputCase close(InputCase one, const std::string& left_out = "") {
  one.left_out = left_out;
  one.numbers = Numbers::close;
  return one;
}

InputCase finding(InputCase one, const std::string& line) {
  one.finds = line;
  return one;
}

InputCase of_rate(const std::string& id, const std::string& name, double per_second,
                  const std::string& unit, const std::string& found, const std::string& likelier) {
  return with_manifest(
      refused(id, name, in_units(per_second, per_second == 1 ? 2 : 0),
              "log.csv: column 't': " + found + " samples per second, read in " + unit +
                  ", expected 5 to 100000; hint: another unit of time? in " + likelier +
                  " they would be 20; " + if_right),
      read_in(unit));
}

}  // namespace

std::vector<InputCase> time_cases() {
  const Clock six_digits = [](int, const std::string& t) {
    return fmt::format("{:.6g}", 1.7e6 + std::stod(t));
  };
  const Clock stuck = [](int i, const std::string& t) {
    return i % 40 == 39 ? scaled(t, 1, -0.05, 2) : t;
  };
  const Clock set_back = [](int i, const std::string& t) {
    return i == 300 || i == 301 ? scaled(t, 1, -0.12, 2) : t;
  };
  const Clock restarted = [](int i, const std::string& t) {
    return i > 400 ? scaled(t, 1, -5, 2) : t;
  };
  const Clock gap = [](int i, const std::string& t) { return i > 300 ? scaled(t, 1, 7, 2) : t; };
  const Clock mixed = [](int i, const std::string& t) {
    return i < 300 ? scaled(t, 1, 1.7e9, 2) : scaled(t, 1e3, 1.7e12, 0);
  };
  const Clock not_a_time = [](int i, const std::string& t) {
    return i % 50 == 25 ? (i % 100 == 25 ? "NaT" : "") : iso(i, t);
  };
  const Clock uneven = [](int i, const std::string& t) {
    return scaled(t, 1, i % 2 == 0 ? 0 : 0.04, 2);
  };
  return {
      refused("30a", "StampsOfSixDigits", with_clock(six_digits),
              "log.csv: column 't': 796 of 801 time stamps repeat an earlier one, expected no more "
              "than 5 %; hint: time column has too few digits?"),
      close(accepted("30b", "ClockThatSticksAtTimes", with_clock(stuck)),
            "20: repeated time stamp"),
      refused("30c", "ClockThatStands", with_clock([](int, const std::string&) { return "5"; }),
              "log.csv: column 't': 800 of 801 time stamps repeat an earlier one, expected no more "
              "than 5 %; hint: time column has too few digits?"),
      close(accepted("31a", "ClockSetBackALittle", with_clock(set_back),
                     "log.csv: time runs backwards in 2 rows (first in line 302); sorted by time")),
      close(accepted("31b", "ClockSetBackBySeconds", with_clock(restarted),
                     "log.csv: the clock was set back 1 time while it was logged; it goes on from "
                     "the row before by the usual step")),
      refused("31c", "TwoLogsWithoutASecondHeader", case_log() + case_log().substr(8),
              "log.csv:803: time runs back by 40 s; hint: " + split_it),
      close(with_manifest(accepted("32a", "Milliseconds", in_units(1e3)), read_in("ms"))),
      close(with_manifest(accepted("32b", "Microseconds", in_units(1e6)), read_in("us"))),
      close(with_manifest(
          accepted("32c", "NanosecondsSince1970", with_clock([](int, const std::string& t) {
                     return "17000000" + fmt::format("{:02}", std::stoi(t)) +
                            t.substr(t.find('.') + 1) + "0000000";
                   }),
                   from_1970),
          read_in("ns"))),
      close(with_manifest(accepted("32d", "Iso8601", with_clock(iso), from_1970),
                          read_in("iso8601"))),
      of_rate("32e", "MillisecondsReadAsSeconds", 1e3, "s", "0.02", "ms"),
      of_rate("32f", "NanosecondsReadAsSeconds", 1e9, "s", "2e-08", "ns"),
      of_rate("32g", "SecondsReadAsMicroseconds", 1, "us", "2e+07", "s"),
      refused("32h", "Iso8601ReadAsSeconds", with_clock(iso),
              "log.csv:2:1: column 't', found '2026-03-01T08:15:00.00Z', expected a number; hint: "
              "date and time? state unit = \"iso8601\""),
      with_manifest(refused("32i", "SecondsReadAsIso8601", case_log(),
                            "log.csv:2:1: column 't', found '0.00', expected a time such as "
                            "2026-03-01T08:15:00.25Z; hint: a row of units under the header? put "
                            "'#' in front of it"),
                    read_in("iso8601")),
      refused("32j", "SecondsAndMillisecondsMixed", with_clock(mixed),
              "log.csv: column 't': 0.02 samples per second, read in s, expected 5 to 100000; "
              "hint: another unit of time? in ms they would be 20; " +
                  if_right),
      with_manifest(
          [] {
            InputCase one = accepted("32k", "AnyRateAsStated", in_units(1e3));
            one.numbers = Numbers::any;
            return one;
          }(),
          case_manifest("unit = \"s\"", "unit = \"s\", any_rate = true")),
      close(with_manifest(accepted("33", "NoTimeInARow", with_clock(not_a_time), from_1970),
                          read_in("iso8601")),
            "16: gap (nan) in column 't'"),
      finding(close(accepted("34a", "GapOfSevenSeconds", with_clock(gap))),
              "check fails: No gaps in time: 1 gap, the longest 7.05 s"),
      finding(close(accepted("34b", "UnevenClock", with_clock(uneven))),
              "check fails: Regular sampling: the sampling interval of 90 ms scatters by 62.9 %"),
  };
}

}  // namespace tribolog::test
