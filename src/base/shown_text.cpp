#include "base/shown_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/utf8.h"

namespace tribolog {

namespace {

bool is_obeyed(char32_t c) { return is_control_character(c) || is_hidden_character(c); }

/// Passes on what is shown as it is, and hands `escape` each other character and broken byte.
template <class Escape>
std::string escaped(std::string_view text, const Escape& escape) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character character = first_utf8_character(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(character.bytes, 1));
    const bool is_shown =
        character.bytes > 0 && (character.code_point == '\n' || !is_obeyed(character.code_point));
    if (is_shown) {
      out += bytes;
    } else {
      escape(out, bytes, character);
    }
    text.remove_prefix(bytes.size());
  }
  return out;
}

void append_code_unit(std::string& out, unsigned unit) { out += fmt::format("\\u{:04x}", unit); }

}  // namespace

std::string lines_for_terminal(std::string_view text) {
  return escaped(text, [](std::string& out, std::string_view bytes, const Utf8Character&) {
    for (const char byte : bytes) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(byte)));
    }
  });
}

std::string json_without_hidden(std::string json) {
  const bool is_plain = std::all_of(json.begin(), json.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x7f;  // a JSON writer escapes what is below U+0020
  });
  if (is_plain) return json;
  return escaped(json, [](std::string& out, std::string_view bytes, const Utf8Character& c) {
    constexpr unsigned first_pair = 0x10000;
    if (c.bytes == 0) {
      out += "\uFFFD";
    } else if (c.code_point < 0x20) {
      out += bytes;  // blanks between the texts
    } else if (c.code_point < first_pair) {
      append_code_unit(out, static_cast<unsigned>(c.code_point));
    } else {
      const unsigned rest = static_cast<unsigned>(c.code_point) - first_pair;
      append_code_unit(out, 0xD800U + (rest >> 10U));
      append_code_unit(out, 0xDC00U + (rest & 0x3FFU));
    }
  });
}

std::string quoted_for_shell(const std::string& word) {
  const char* const plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=./,:+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace tribolog
