#include "ingest/manifest/toml_document.h"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "base/shown_text.h"
#include "base/utf8.h"

namespace tribolog::ingest::manifest {

const TomlNode* TomlNode::member(std::string_view key) const {
  const auto* members = as<TomlMembers>();
  if (members == nullptr) return nullptr;
  const auto at = members->find(key);
  return at == members->end() ? nullptr : &at->second;
}

std::string iso_offset(int minutes) {
  if (minutes == 0) return "Z";
  const int size = std::abs(minutes);
  return fmt::format("{}{:02}:{:02}", minutes < 0 ? '-' : '+', size / 60, size % 60);
}

std::string toml_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  while (!text.empty()) {
    const Utf8Character c = first_utf8_character(text);
    if (c.bytes == 0) throw std::invalid_argument("a text for TOML is not UTF-8");
    if (c.code_point == '"' || c.code_point == '\\') {
      quoted += '\\';
      quoted += text.front();
    } else if (is_control_character(c.code_point) || is_hidden_character(c.code_point)) {
      quoted += fmt::format("\\U{:08X}", static_cast<std::uint32_t>(c.code_point));
    } else {
      quoted += text.substr(0, c.bytes);
    }
    text.remove_prefix(c.bytes);
  }
  return quoted += '"';
}

}  // namespace tribolog::ingest::manifest
