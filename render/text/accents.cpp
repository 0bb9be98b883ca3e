#include "render/text/accents.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace tribolog::render::text {
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
