#include "render/layout/tick_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace tribolog::render {
namespace {

constexpr const char* minus = "\u2212";
constexpr int largest_plain = 5;  // digits before the point
constexpr int most_decimals = 4;  // digits behind it

int digits_of(long long value) {
  return static_cast<int>(std::to_string(std::llabs(value)).size());
}

}  // namespace

std::string decimal_text(long long multiple, int exponent) {
  if (multiple == 0) return "0";
  std::string digits = std::to_string(std::llabs(multiple));
  if (exponent >= 0) {
    digits.append(static_cast<std::size_t>(exponent), '0');
  } else {
    const auto decimals = static_cast<std::size_t>(-exponent);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, 1, '.');
  }
  std::string signed_text;
  if (multiple < 0) signed_text += minus;
  return signed_text += digits;
}

std::string integer_text(int value) { return decimal_text(value, 0); }

std::string magnitude_text(double value) {
  char buffer[64];
  const auto plain = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
  if (plain.ec == std::errc() && plain.ptr - buffer <= 7 && value >= 1e-3) {
    return {buffer, plain.ptr};
  }
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
  const std::string text(buffer, end.ptr);
  const std::size_t split = text.find('e');
  const int power = std::atoi(text.c_str() + split + 1);
  return text.substr(0, split) + "·10^{" + integer_text(power) + "}";
}

std::string logarithmic_text(int digit, int exponent) {
  if (exponent >= -3 && exponent <= 4) return decimal_text(digit, exponent);
  const std::string power = "10^{" + integer_text(exponent) + "}";
  if (digit == 1) return power;
  return integer_text(digit) + "·" + power;
}

double power_of_ten_multiple(int digit, int exponent) {
  return std::strtod((std::to_string(digit) + "e" + std::to_string(exponent)).c_str(), nullptr);
}

CommonPower common_power(const std::vector<long long>& multiples, int exponent) {
  long long largest = 0;
  for (const long long one : multiples) largest = std::max(largest, std::llabs(one));
  if (largest == 0) return {};
  const int leading = digits_of(largest) - 1 + exponent;  // decimal exponent of the largest label
  if (leading < largest_plain && -exponent <= most_decimals) return {};
  return {leading >= 0 ? leading / 3 * 3 : -((-leading + 2) / 3 * 3)};
}

}  // namespace tribolog::render
