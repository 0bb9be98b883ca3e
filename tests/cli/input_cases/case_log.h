#pragma once
// The log behind all cases: a sweep there and back over a gravity peak at 0.2 rad, 20 Hz, 40 s.

#include <functional>
#include <string>
#include <vector>

namespace tribolog::test {

inline constexpr int case_rows = 801;

/// One row's fields, to be changed: t, q, tau.
using Row = std::vector<std::string>;
using Change = std::function<void(int row, Row& fields)>;

/// "t,q,tau" and its rows; every row changed and its fields joined by the delimiter.
std::string case_log(const Change& change = {}, const std::string& header = "t,q,tau",
                     const std::string& delimiter = ",", int rows = case_rows);

/// Line 301 of the log, at 14.95 s, as another line or several.
std::string with_line_301(const std::string& line);

/// The same manifest for all: columns t in s, q in rad, tau in Nm of `log.csv`.
std::string case_manifest();
/// With one piece replaced.
std::string case_manifest(const std::string& from, const std::string& to);

/// A number as the log has it, times a factor, plus an offset.
std::string scaled(const std::string& number, double factor, double offset = 0, int decimals = 9);

}  // namespace tribolog::test
