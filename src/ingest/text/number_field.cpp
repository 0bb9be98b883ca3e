#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "ingest/text/fields.h"

namespace tribolog::ingest::text {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string_view without_plus(std::string_view field) {
  if (field.size() > 1 && field[0] == '+' && field[1] != '-' && field[1] != '+') {
    field.remove_prefix(1);
  }
  return field;
}

bool is_gap_word(std::string_view field) {
  constexpr std::array<std::string_view, 9> words = {"nan", "null", "n/a",  "na", "none",
                                                     "nat", "inf",  "#n/a", "#na"};
  constexpr std::size_t longest_word = 12;
  if (field.size() > longest_word) return false;
  std::string lower(field);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  std::string_view word = lower;
  if (word == "-" || word == "--" || word == "---") return true;
  if (word.starts_with('-')) word.remove_prefix(1);
  // 1.#QNAN, 1.#IND, 1.#INF: how an old C run-time prints them
  return word.starts_with("1.#") || std::find(words.begin(), words.end(), word) != words.end();
}

/// Whether a number out of the range of double is too large; else it is too small.
bool is_too_large(std::string_view number) {
  if (number.starts_with('-')) number.remove_prefix(1);
  const std::size_t e = number.find_first_of("eE");
  long exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (read.ec == std::errc::result_out_of_range) return !digits.starts_with('-');
  }
  const std::string_view mantissa = number.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  return static_cast<long>(point) - static_cast<long>(first) + exponent > 0;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

NumberField read_number(std::string_view field, DecimalMark mark) {
  if (mark == DecimalMark::comma && field.find_first_of(".,") != std::string_view::npos) {
    std::string with_point(trimmed(field));
    // A point would be a thousands separator; "1.#QNAN" is a gap under both.
    if (with_point.find('.') != std::string::npos) {
      return is_gap_word(with_point) ? NumberField{FieldKind::gap, not_a_number}
                                     : NumberField{FieldKind::text, 0.0};
    }
    with_point[with_point.find(',')] = '.';
    return read_number(with_point);
  }
  const std::string_view number = without_plus(trimmed(field));
  const char* end = number.data() + number.size();
  double value = 0;
  const auto read = std::from_chars(number.data(), end, value);
  const bool is_whole = read.ptr == end && !number.empty();
  if (is_whole && read.ec == std::errc()) {
    if (std::isfinite(value)) return {FieldKind::number, value};
    return {FieldKind::gap, not_a_number};
  }
  if (is_whole && read.ec == std::errc::result_out_of_range) {
    if (is_too_large(number)) return {FieldKind::overflow, 0.0};
    return {FieldKind::number, 0.0};
  }
  if (number.empty() || is_gap_word(number)) return {FieldKind::gap, not_a_number};
  return {FieldKind::text, 0.0};
}

bool looks_like_decimal_comma(std::string_view field) {
  const std::string_view number = trimmed(field);
  const std::size_t comma = number.find(',');
  if (comma == std::string_view::npos || comma == 0 || comma + 1 >= number.size()) return false;
  if (!is_digit(number[comma - 1]) || !is_digit(number[comma + 1])) return false;
  std::string with_point(number);
  with_point[comma] = '.';
  return read_number(with_point).kind == FieldKind::number;
}

bool looks_like_thousands(std::string_view field, DecimalMark mark) {
  const std::string_view mark_of_others = mark == DecimalMark::point ? "," : ".";
  const std::array<std::string_view, 5> separators = {mark_of_others, " ", "'", "\u00a0", "\u202f"};
  constexpr std::size_t group = 3;
  const std::string_view number = trimmed(field);
  std::string without;
  for (std::string_view rest = number; !rest.empty();) {
    const auto separator =
        std::find_if(separators.begin(), separators.end(),
                     [rest](std::string_view one) { return rest.starts_with(one); });
    if (separator == separators.end()) {
      without += rest.front();
      rest.remove_prefix(1);
      continue;
    }
    rest.remove_prefix(separator->size());
    const auto digits = std::find_if_not(rest.begin(), rest.end(), is_digit) - rest.begin();
    if (digits != group) return false;
  }
  return without.size() < number.size() && read_number(without, mark).kind == FieldKind::number;
}

bool looks_like_cut_number(std::string_view field, DecimalMark mark) {
  const std::string_view number = trimmed(field);
  if (read_number(std::string(number) + "0", mark).kind == FieldKind::number) return true;
  constexpr std::array<std::string_view, 6> starts = {"n", "na", "i", "in", "-n", "-i"};
  return std::find(starts.begin(), starts.end(), number) != starts.end();
}

}  // namespace tribolog::ingest::text
