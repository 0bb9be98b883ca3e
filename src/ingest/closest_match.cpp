#include "ingest/closest_match.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "error.h"

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

/// Levenshtein's.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// 0: the same but for case; more than 2 plus a third of the word: not close.
double distance(const std::string& word, const std::string& candidate) {
  const bool contains = !word.empty() && !candidate.empty() &&
                        (candidate.find(word) != std::string::npos ||
                         word.find(candidate) != std::string::npos);
  const auto edits = static_cast<double>(edit_distance(word, candidate));
  return contains ? std::min(edits, 1.5) : edits;
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
