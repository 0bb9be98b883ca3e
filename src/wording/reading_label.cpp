#include "wording/reading_label.h"

#include <algorithm>

#include <fmt/format.h>

#include "wording/words.h"

namespace tribolog::wording {

std::string reading_label(const std::string& reading) {
  const std::string words = words_for("reading", reading);
  const std::size_t mark = words.find('_');
  if (mark == std::string::npos) return words;
  const std::size_t end = std::min(words.find(' ', mark), words.size());
  return fmt::format("{}{{{}}}{}", words.substr(0, mark + 1),
                     words.substr(mark + 1, end - mark - 1), words.substr(end));
}

}  // namespace tribolog::wording
