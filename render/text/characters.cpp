#include "render/text/characters.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

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

namespace {

constexpr char32_t dot_above = 0x0307;
constexpr char32_t diaeresis = 0x0308;
constexpr char32_t circumflex = 0x0302;
constexpr char32_t macron = 0x0304;
constexpr char32_t tilde = 0x0303;

struct Composition {
  char32_t letter;
  char32_t mark;
  char32_t whole;
};

constexpr Composition compositions[] = {
    {U'a', dot_above, 0x0227},  {U'b', dot_above, 0x1E03},  {U'c', dot_above, 0x010B},
    {U'd', dot_above, 0x1E0B},  {U'e', dot_above, 0x0117},  {U'f', dot_above, 0x1E1F},
    {U'g', dot_above, 0x0121},  {U'h', dot_above, 0x1E23},  {U'm', dot_above, 0x1E41},
    {U'n', dot_above, 0x1E45},  {U'o', dot_above, 0x022F},  {U'p', dot_above, 0x1E57},
    {U'r', dot_above, 0x1E59},  {U's', dot_above, 0x1E61},  {U't', dot_above, 0x1E6B},
    {U'w', dot_above, 0x1E87},  {U'x', dot_above, 0x1E8B},  {U'y', dot_above, 0x1E8F},
    {U'z', dot_above, 0x017C},  {U'T', dot_above, 0x1E6A},  {U'X', dot_above, 0x1E8A},
    {U'Z', dot_above, 0x017B},  {U'a', diaeresis, 0x00E4},  {U'e', diaeresis, 0x00EB},
    {U'o', diaeresis, 0x00F6},  {U'u', diaeresis, 0x00FC},  {U'x', diaeresis, 0x1E8D},
    {U'y', diaeresis, 0x00FF},  {U't', diaeresis, 0x1E97},  {U'A', diaeresis, 0x00C4},
    {U'O', diaeresis, 0x00D6},  {U'U', diaeresis, 0x00DC},  {U'a', circumflex, 0x00E2},
    {U'e', circumflex, 0x00EA}, {U'i', circumflex, 0x00EE}, {U'o', circumflex, 0x00F4},
    {U'u', circumflex, 0x00FB}, {U'z', circumflex, 0x1E91}, {U'a', tilde, 0x00E3},
    {U'n', tilde, 0x00F1},      {U'o', tilde, 0x00F5},
};

constexpr std::array<std::array<char32_t, 2>, 5> free_standing_signs{{{dot_above, 0x02D9},
                                                                      {diaeresis, 0x00A8},
                                                                      {circumflex, 0x02C6},
                                                                      {macron, 0x00AF},
                                                                      {tilde, 0x02DC}}};

}  // namespace

std::optional<char32_t> composed(char32_t letter, char32_t mark) {
  const auto found = std::find_if(
      std::begin(compositions), std::end(compositions),
      [&](const Composition& one) { return one.letter == letter && one.mark == mark; });
  if (found == std::end(compositions)) return std::nullopt;
  return found->whole;
}

std::optional<char32_t> free_standing(char32_t mark) {
  for (const auto& [combining, sign] : free_standing_signs) {
    if (combining == mark) return sign;
  }
  return std::nullopt;
}

}  // namespace tribolog::render::text
