#include "inspect/survey/text_table.h"

#include <algorithm>

namespace tribolog::inspect::survey {
namespace {

constexpr std::size_t between = 2;
constexpr std::size_t narrowest = 20;  // of the last column: narrower is no use

std::vector<std::string> broken(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const bool fits = lines.back().empty() || places(lines.back()) + 1 + places(word) <= width;
    if (!fits) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

}  // namespace

std::string plural(std::size_t n, const std::string& word) {
  return std::to_string(n) + ' ' + word + (n == 1 ? "" : "s");
}

std::size_t places(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // not the rest of a character
  }));
}

std::string TextTable::text(std::size_t width) const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k) {
      if (widths.size() <= k) widths.resize(k + 1, 0);
      widths[k] = std::max(widths[k], places(row[k]));
    }
  }
  std::size_t before = indent_;
  for (const std::size_t w : widths) before += w + between;
  const std::size_t rest = std::max(narrowest, width > before ? width - before : 0);
  std::string out;
  for (const auto& row : rows_) {
    std::string start(indent_, ' ');
    for (std::size_t k = 0; k + 1 < row.size(); ++k) {
      start += row[k] + std::string(widths[k] - places(row[k]) + between, ' ');
    }
    if (row.empty()) continue;
    for (const std::string& piece : broken(row.back(), rest)) {
      std::string line = start + piece;
      line.erase(line.find_last_not_of(' ') + 1);
      out += line + "\n";
      start.assign(places(start), ' ');
    }
  }
  return out;
}

}  // namespace tribolog::inspect::survey
