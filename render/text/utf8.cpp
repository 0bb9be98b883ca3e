#include "render/text/utf8.h"

#include <cstdint>

namespace tribolog::render::text {
namespace {

struct Sequence {
  std::size_t length{1};
  char32_t value{};
  bool valid{false};
};

bool is_continuation(char byte) { return (static_cast<std::uint8_t>(byte) & 0xC0U) == 0x80U; }

Sequence read_sequence(std::string_view rest) {
  const auto first = static_cast<std::uint8_t>(rest.front());
  if (first < 0x80) return {1, first, true};
  std::size_t length = 0;
  if ((first & 0xE0U) == 0xC0U) length = 2;
  if ((first & 0xF0U) == 0xE0U) length = 3;
  if ((first & 0xF8U) == 0xF0U) length = 4;
  if (length == 0) return {};
  char32_t value = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (i >= rest.size() || !is_continuation(rest[i])) return {i, 0, false};
    value = (value << 6U) | (static_cast<std::uint8_t>(rest[i]) & 0x3FU);
  }
  constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  return {length, value, value >= smallest[length] && value <= 0x10FFFF && !surrogate};
}

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
         (c & 0xFFFEU) == 0xFFFE;
}

}  // namespace

DecodedText decode_utf8(std::string_view bytes) {
  DecodedText out;
  while (!bytes.empty()) {
    const Sequence one = read_sequence(bytes);
    bytes.remove_prefix(one.length);
    if (one.valid && (one.value == '\t' || one.value == '\n' || one.value == '\r')) {
      out.text += U' ';
    } else if (one.valid && !is_control(one.value)) {
      out.text += one.value;
    } else {
      out.text += U'?';
      ++out.replaced;
    }
  }
  return out;
}

std::string encode_utf8(std::u32string_view text) {
  std::string out;
  const auto put = [&out](char32_t bits) { out += static_cast<char>(bits); };
  for (const char32_t c : text) {
    if (c < 0x80) {
      put(c);
    } else if (c < 0x800) {
      put(0xC0U | (c >> 6U));
      put(0x80U | (c & 0x3FU));
    } else if (c < 0x10000) {
      put(0xE0U | (c >> 12U));
      put(0x80U | ((c >> 6U) & 0x3FU));
      put(0x80U | (c & 0x3FU));
    } else {
      put(0xF0U | (c >> 18U));
      put(0x80U | ((c >> 12U) & 0x3FU));
      put(0x80U | ((c >> 6U) & 0x3FU));
      put(0x80U | (c & 0x3FU));
    }
  }
  return out;
}

}  // namespace tribolog::render::text
