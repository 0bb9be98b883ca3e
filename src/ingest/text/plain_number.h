#pragma once
// The numbers of a large log, as fast as they can be read to the last bit.
//
// A decimal of at most 2^53 with at most 22 digits behind its mark is the quotient of two numbers
// that a double holds exactly, so that one division rounds it rightly (W. D. Clinger, PLDI 1990).
// Eight digits at a time are turned into a number by three multiplications.

#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tribolog::ingest::text {

static_assert(std::endian::native == std::endian::little, "eight digits are read as one word");

/// How many of eight bytes, from the first in memory on, are digits.
[[gnu::always_inline]] inline unsigned leading_digits(std::uint64_t bytes) {
  // A digit less '0' stays below 0x80 with 0x76 added. What a byte carries over concerns those
  // behind the first that is no digit alone.
  const std::uint64_t less_zero = bytes ^ 0x3030303030303030U;
  const std::uint64_t others =
      ((less_zero + 0x7676767676767676U) | less_zero) & 0x8080808080808080U;
  return static_cast<unsigned>(std::countr_zero(others)) / 8;
}

/// The number of eight digits less '0' each, the first byte in memory being the largest.
[[gnu::always_inline]] inline std::uint32_t eight_digits(std::uint64_t bytes) {
  constexpr std::uint64_t mask = 0x000000FF000000FFU;
  constexpr std::uint64_t by_100_and_1e6 = 0x000F424000000064U;
  constexpr std::uint64_t by_1_and_1e4 = 0x0000271000000001U;
  bytes = bytes * 10 + (bytes >> 8);
  bytes = ((bytes & mask) * by_100_and_1e6 + ((bytes >> 16) & mask) * by_1_and_1e4) >> 32;
  return static_cast<std::uint32_t>(bytes);
}

/// One digit at p is added to `value`. @return false where there is none.
[[gnu::always_inline]] inline bool read_digit(const char*& p, const char* end,
                                              std::uint64_t& value) {
  const auto digit = p != end ? static_cast<unsigned>(*p - '0') : 10U;
  if (digit > 9) return false;
  value = value * 10 + digit;
  ++p;
  return true;
}

/// Digits from p on are added to `value`, many at a time. @return behind the last one.
[[gnu::always_inline]] inline const char* read_many_digits(const char* p, const char* end,
                                                           std::uint64_t& value) {
  static constexpr std::uint32_t powers[] = {1,       10,        100,        1'000,      10'000,
                                             100'000, 1'000'000, 10'000'000, 100'000'000};
  while (end - p >= 8) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, p, sizeof bytes);
    const unsigned count = leading_digits(bytes);
    if (count == 0) return p;
    // Fewer than eight: zeros in front.
    bytes = (bytes - 0x3030303030303030U) << (64 - 8 * count);
    value = value * powers[count] + eight_digits(bytes);
    p += count;
    // Nine digits are frequent, and a digit is read sooner than a word.
    if (count < 8 || !read_digit(p, end, value)) return p;
  }
  while (read_digit(p, end, value)) {
  }
  return p;
}

/// Digits in front of the mark: mostly few.
[[gnu::always_inline]] inline const char* read_few_digits(const char* p, const char* end,
                                                          std::uint64_t& value) {
  constexpr int few = 4;
  for (int k = 0; k < few; ++k) {
    if (!read_digit(p, end, value)) return p;
  }
  return read_many_digits(p, end, value);
}

/// A finite decimal number at p, the same to the last bit as std::from_chars reads it.
/// @param mark '.' or ','
/// @return behind the number; p where there is none, or one that needs a closer look.
[[gnu::always_inline]] inline const char* read_plain_number(const char* p, const char* end,
                                                            char mark, double& value) {
  static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                      1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::ptrdiff_t most_digits = 19;  // that cannot overflow 64 bits
  constexpr std::uint64_t largest_exact = std::uint64_t{1} << 53;
  const char* const start = p;
  const bool is_negative = p != end && *p == '-';
  p += is_negative ? 1 : 0;
  const char* const first = p;
  std::uint64_t digits = 0;
  p = read_few_digits(p, end, digits);
  std::ptrdiff_t count = p - first;
  std::ptrdiff_t behind = 0;
  if (p != end && *p == mark) {
    const char* const fraction = ++p;
    p = read_many_digits(p, end, digits);
    behind = p - fraction;
    count += behind;
  }
  const bool goes_on = p != end && (*p == 'e' || *p == 'E');
  if (count > 0 && count <= most_digits && digits <= largest_exact && !goes_on) {
    const double size = static_cast<double>(digits) / powers[behind];
    // No branch: signs change as they please.
    value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) |
                                  (static_cast<std::uint64_t>(is_negative) << 63));
    return p;
  }
  if (mark != '.') return start;
  const auto read = std::from_chars(start, end, value);
  return read.ec == std::errc() && std::isfinite(value) ? read.ptr : start;
}

}  // namespace tribolog::ingest::text
