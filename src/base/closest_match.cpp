#include "base/closest_match.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "base/error.h"

namespace tribolog {
namespace {

constexpr std::size_t longest_compared = 64;

std::string lower(std::string_view text) {
  std::string result(text.substr(0, longest_compared));
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

/// Letters put in, left out, replaced, or swapped with their neighbour (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool is_swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

/// "q" in "q_rad" and "tau" in "measured_tau_3", but not "t" in "tau".
bool stands_in(const std::string& part, const std::string& whole) {
  constexpr std::size_t shortest_telling_part = 3;
  if (part.empty() || part.size() >= whole.size()) return false;
  if (part.size() >= shortest_telling_part) return whole.find(part) != std::string::npos;
  const char next = whole[part.size()];
  return whole.starts_with(part) && !(next >= 'a' && next <= 'z');
}

/// 0: the same but for case.
double distance(const std::string& word, const std::string& candidate) {
  constexpr double of_a_part = 0.5;  // closer than one slip
  if (stands_in(word, candidate) || stands_in(candidate, word)) return of_a_part;
  return static_cast<double>(edit_distance(word, candidate));
}

}  // namespace

std::string closest_match(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string wanted = lower(word);
  double best = std::max(1.0, 1.0 + static_cast<double>(wanted.size()) / 3.0);
  std::string match;
  for (const std::string& candidate : candidates) {
    const double d = distance(wanted, lower(candidate));
    if (d < best) {
      best = d;
      match = candidate;
    }
  }
  return match;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string match = closest_match(word, candidates);
  return match.empty() ? "" : "did you mean " + in_quotes(match) + "?";
}

std::string list_of_names(const std::vector<std::string>& names, std::size_t limit) {
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), limit); ++i) {
    if (i > 0) list += ", ";
    list += in_quotes(names[i]);
  }
  if (names.size() > limit) list += ", ... and " + std::to_string(names.size() - limit) + " more";
  return list;
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  result += printable(std::string(text.substr(0, 1000)));
  return result += "'";
}

}  // namespace tribolog
