#pragma once
// Round numbers on an axis and how to write them.

#include <string>
#include <vector>

#include "render/layout/axis.h"

namespace tribolog::render::layout {

/// Exact text of multiple * 10^exponent: decimal_text(-25, -1) is "−2.5".
std::string decimal_text(long long multiple, int exponent);

std::string integer_text(int value);

/// A positive number in as few digits as identify it, as markup: "1.7·10^{9}", "1700000123".
std::string magnitude_text(double value);

/// "0.01", "50", "10^{5}", "2·10^{−4}".
std::string logarithmic_text(int digit, int exponent);

/// digit * 10^exponent, correctly rounded.
double power_of_ten_multiple(int digit, int exponent);

/// The power of ten to take out of all labels so that they stay short; 0 for everyday numbers.
struct CommonPower {
  int exponent{};
};
CommonPower common_power(const std::vector<long long>& multiples, int exponent);

struct Tick {
  double value{};
  std::string label;  ///< Figure markup.
};

/// Labels are distinct. `scale_note` (markup, often empty) says what to do with every label:
/// "×10^{6}" to multiply, "+ 1.7·10^{9}" to add, or both in this order.
struct TickSet {
  std::vector<Tick> major;
  std::vector<double> minor;  ///< Logarithmic axes only.
  std::string scale_note;
};

/// Multiples of 1, 2 or 5 times a power of ten, at most `most` of them (at least 2 where the range
/// allows it), no closer than `least_step`. @pre range as AxisRange demands; most >= 2.
TickSet linear_ticks(const AxisRange& range, int most, double least_step = 0.0);

/// Decades; where the range is short also their 2- and 5-fold, or linear ticks.
TickSet logarithmic_ticks(const AxisRange& range, int most);

}  // namespace tribolog::render::layout
