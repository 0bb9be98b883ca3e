#include "cli/close_texts.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include <fmt/format.h>

namespace tribolog::test {

std::string difference(const std::string& a, const std::string& b, double share) {
  std::size_t i = 0;
  std::size_t j = 0;
  const auto is_digit = [](const std::string& text, std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
  };
  while (i < a.size() && j < b.size()) {
    if (is_digit(a, i) && is_digit(b, j)) {
      char* end_a = nullptr;
      char* end_b = nullptr;
      const double x = std::strtod(a.c_str() + i, &end_a);
      const double y = std::strtod(b.c_str() + j, &end_b);
      if (std::abs(x - y) > share * std::max({1.0, std::abs(x), std::abs(y)})) break;
      i = static_cast<std::size_t>(end_a - a.c_str());
      j = static_cast<std::size_t>(end_b - b.c_str());
    } else if (a[i] == b[j]) {
      ++i;
      ++j;
    } else {
      break;
    }
  }
  if (i == a.size() && j == b.size()) return "";
  return fmt::format("'{}' instead of '{}'", a.substr(i, 60), b.substr(j, 60));
}

}  // namespace tribolog::test
