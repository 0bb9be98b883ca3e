// What stands in a field: 14, 15, 27 to 29, 39.

#include <array>
#include <cstddef>

#include "cli/input_cases/case_log.h"
#include "cli/input_cases/input_case.h"
#include "cli/small_dataset.h"

namespace tribolog::test {
namespace {

const std::string damaged_number =
    "; hint: damaged rows? [log] skip_bad_rows = true (--skip-bad-rows) leaves them out, up to 1 % "
    "of all";

std::string with_torque(const std::string& field) {
  return with_line_301("14.95,0.695000000," + field);
}

InputCase no_number(const std::string& id, const std::string& name, const std::string& field,
                    const std::string& hint = damaged_number) {
  return refused(id, name, with_torque(field),
                 "log.csv:301:19: column 'tau', found '" + field + "', expected a number" + hint);
}

/// One sample of many, and a little off.
InputCase other_sample(InputCase one) {
  one.numbers = Numbers::any;
  return one;
}

std::string with_gaps(int every, const std::vector<std::string>& words) {
  return case_log([&](int i, Row& row) {
    if (i % every == every / 2) row[2] = words[static_cast<std::size_t>(i / every) % words.size()];
  });
}

InputCase with_left_out(InputCase one, const std::string& left_out) {
  one.left_out = left_out;
  one.numbers = Numbers::close;
  return one;
}

InputCase impossible(const std::string& id, const std::string& name, const std::string& log,
                     const std::string& says) {
  return refused(id, name, log,
                 says +
                     "; hint: another unit? where only this row is damaged, write nan, or [log] "
                     "skip_bad_rows = true leaves it out, up to 1 % of all");
}

}  // namespace

std::vector<InputCase> number_cases() {
  const std::string thousands = "; hint: thousands separators? write numbers without";
  InputCase german = accepted("15", "GermanLocale", case_log());
  german.environment = "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8";
  return {
      refused("14a", "ThousandsCommas",
              replaced(case_log({}, "t;q;tau", ";"), ";3.500000000", ";3,500.000"),
              "log.csv:202:19: column 'tau', found '3,500.000', expected a number" + thousands),
      no_number("14b", "ThousandsBlanks", "1 234.5", thousands),
      no_number("14c", "ThousandsNarrowBlanks", "1\u00a0234.5", thousands),
      no_number("14d", "ThousandsApostrophes", "1'234.5", thousands),
      german,
      with_left_out(accepted("27a", "GapsInAllTheirSpellings",
                             with_gaps(10, {"nan", "NaN", "-nan(ind)", "inf", "-inf", "1.#QNAN", "",
                                            "NULL", "N/A", "NA", "none"})),
                    "80: gap (nan) in column 'tau'"),
      with_left_out(accepted("27b", "AThirdIsGaps", with_gaps(3, {"nan"}),
                             "log.csv: column 'tau': 33 % of the rows are gaps (nan)"),
                    "267: gap (nan) in column 'tau'"),
      refused("27c", "AllIsGaps", with_gaps(1, {"nan"}),
              "log.csv: column 'tau' holds no number, only gaps (empty or nan)"),
      refused("28a", "Overflow", with_torque("1e400"),
              "log.csv:301:19: column 'tau': number is too large, found '1e400'" + damaged_number),
      other_sample(accepted("28b", "Underflow", with_torque("1e-400"))),
      no_number("28c", "Hexadecimal", "0x1p3"),
      no_number("28d", "FortranExponent", "1d3"),
      no_number("28e", "ArabicDigits", "٣"),
      other_sample(accepted("28f", "PlusSign", with_torque("+3.1"))),
      other_sample(accepted("28g", "PointAtTheEnd", with_torque("3."))),
      other_sample(accepted("28h", "PointAtTheStart", with_torque(".5"))),
      no_number("29a", "True", "true"),
      no_number("29b", "Word", "fault"),
      no_number("29c", "NumberWithItsUnit", "3.1 Nm"),
      refused(
          "29d", "TerminalEscape", with_torque("\x1b[31mred"),
          "log.csv:301:19: column 'tau', found '\\x1b[31mred', expected a number" + damaged_number),
      impossible("39a", "HugeTorque", with_torque("1e300"),
                 "log.csv:301: column 'tau': no joint has a torque of this size, found 1e+300 Nm, "
                 "expected at most 1e+07 Nm"),
      impossible("39b", "HugeAngle", with_line_301("14.95,-1e300,3.1"),
                 "log.csv:301: column 'q': no joint has an angle of this size, found -1e+300 rad, "
                 "expected at most 1e+06 rad"),
      impossible("39c", "AngleWithAnOffsetOfABillion",
                 case_log([](int, Row& row) { row[1] = scaled(row[1], 1, 1e9); }),
                 "log.csv:2: column 'q': no joint has an angle of this size, found 1e+09 rad, "
                 "expected at most 1e+06 rad"),
      other_sample(
          accepted("39d", "Denormals", case_log([](int, Row& row) { row[2] = "4e-320"; }))),
      [] {
        InputCase one = accepted(
            "39e", "ClockWithAnOffsetOfABillion",
            case_log([](int, Row& row) { row[0] = scaled(row[0], 1, 1e9, 2); }),
            "log.csv: its clock counts from 1970; here, and in from_s and to_s, time counts from "
            "its first reading, in whole units");
        one.numbers = Numbers::close;
        return one;
      }(),
  };
}

}  // namespace tribolog::test
