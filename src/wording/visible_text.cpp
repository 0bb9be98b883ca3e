#include "wording/visible_text.h"

#include <cstddef>

#include <fmt/format.h>

#include "base/utf8.h"

namespace tribolog::wording {
namespace {

bool is_control(char32_t c) { return is_control_character(c) && c != '\t' && c != '\n'; }

}  // namespace

std::string visible_text(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Utf8Character c = first_utf8_character(text.substr(at));
    const auto number = static_cast<unsigned>(c.code_point);
    if (c.bytes == 0) {
      shown +=
          fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(text[at])));
      ++at;
      continue;
    }
    if (is_control(c.code_point)) {
      shown += fmt::format("\\x{:02x}", number);
    } else if (is_hidden_character(c.code_point)) {
      shown += fmt::format("[U+{:04X}]", number);
    } else {
      shown.append(text.substr(at, c.bytes));
    }
    at += c.bytes;
  }
  return shown;
}

}  // namespace tribolog::wording
