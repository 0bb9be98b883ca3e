#include "export/toml_text.h"

#include <fmt/format.h>

#include "export/shortest_number.h"

namespace tribolog {

std::string toml_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(byte));
    } else {
      quoted += c;
    }
  }
  return quoted += '"';
}

}  // namespace tribolog
