#pragma once
// Numbers as they stand on axes: exact decimals, a true minus sign, no exponent letter.

#include <string>
#include <vector>

namespace tribolog::render {

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

}  // namespace tribolog::render
