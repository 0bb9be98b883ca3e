#include "ingest/log/register.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace tribolog::ingest::log {
namespace {

constexpr std::string_view unsigned_word = "unsigned ";
constexpr std::string_view sign_word = "sign bit ";

/// Those that drives and servos have.
constexpr std::array<Register, 6> known = {{{65536.0, false},
                                            {4294967296.0, false},
                                            {256.0, false},
                                            {65536.0, true},
                                            {2048.0, true},
                                            {4096.0, true}}};

/// Largest step from one number to the next, and how many are as large as half the range.
struct Steps {
  double largest{};
  std::size_t wide{};
};

Steps steps_of(const std::vector<double>& values, double wide) {
  Steps steps;
  double before = NAN;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const double step = std::abs(value - before);
    if (step > steps.largest) steps.largest = step;
    if (step >= wide) ++steps.wide;
    before = value;
  }
  return steps;
}

}  // namespace

double Register::value_of(double logged) const {
  const double half = modulus / 2;
  const bool is_one = logged >= half && logged < modulus && logged == std::floor(logged);
  if (!is_one) return logged;
  return has_sign_bit ? half - logged : logged - modulus;
}

std::string to_string(const Register& of) {
  const int bits = static_cast<int>(std::lround(std::log2(of.modulus)));
  return of.has_sign_bit ? fmt::format("{}{}", sign_word, bits - 1)
                         : fmt::format("{}{}", unsigned_word, bits);
}

std::optional<Register> register_named(std::string_view name) {
  for (const Register& one : known) {
    if (to_string(one) == name) return one;
  }
  return std::nullopt;
}

std::string register_names() {
  std::string names;
  for (const Register& one : known) names += (names.empty() ? "" : ", ") + to_string(one);
  return names;
}

std::optional<Register> find_register(const std::vector<double>& values) {
  constexpr std::size_t fewest_jumps = 2;
  constexpr double least_jump = 0.4;     // of the modulus: from end to end, or over the sign bit
  constexpr double largest_left = 0.15;  // of the modulus: no jump is left as signed numbers
  double low = INFINITY;
  double high = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (value != std::floor(value)) return std::nullopt;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low >= 0)) return std::nullopt;
  for (const Register& one : known) {
    if (high >= one.modulus || high < one.modulus / 2) continue;
    const Steps logged = steps_of(values, least_jump * one.modulus);
    if (logged.wide < fewest_jumps) continue;
    std::vector<double> as_signed;
    as_signed.reserve(values.size());
    for (const double value : values) as_signed.push_back(one.value_of(value));
    const Steps left = steps_of(as_signed, least_jump * one.modulus);
    if (left.largest <= largest_left * one.modulus) return one;
  }
  return std::nullopt;
}

}  // namespace tribolog::ingest::log
