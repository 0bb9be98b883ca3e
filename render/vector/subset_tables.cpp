#include <algorithm>
#include <iterator>
#include <limits>

#include "base/error.h"
#include "render/vector/true_type.h"

namespace tribolog::render::vector {
namespace {

void set_u16(std::string& table, std::size_t at, std::uint16_t value) {
  if (at + 2 > table.size()) throw FigureError({"drawing.font_table_too_short"});
  table[at] = static_cast<char>(value >> 8U);
  table[at + 1] = static_cast<char>(value & 0xFFU);
}

/// Three numbers for a binary search that every such table carries.
void put_search(std::string& out, unsigned count, unsigned size) {
  unsigned power = 1;
  std::uint16_t exponent = 0;
  while (power * 2 <= count) {
    power *= 2;
    ++exponent;
  }
  put_u16(out, static_cast<std::uint16_t>(power * size));
  put_u16(out, exponent);
  put_u16(out, static_cast<std::uint16_t>((count - power) * size));
}

std::string copy_of(const TrueTypeFile& font, const char* tag, std::size_t least) {
  std::string table(font.table(tag));
  if (table.size() < least) throw FigureError({"drawing.font_table_too_short"});
  return table;
}

/// Characters that follow each other, with their glyphs.
struct Stretch {
  char32_t first{};
  char32_t last{};
  std::uint16_t glyph{};
};

std::vector<Stretch> stretches(const GlyphNumbers& glyphs) {
  std::vector<Stretch> out;
  for (const auto& [character, glyph] : glyphs) {
    if (!out.empty() && out.back().last + 1 == character &&
        out.back().glyph + (character - out.back().first) == glyph) {
      out.back().last = character;
    } else {
      out.push_back({character, character, glyph});
    }
  }
  return out;
}

/// Format 4: the basic plane, in two bytes.
std::string short_map(const std::vector<Stretch>& all) {
  constexpr char32_t last_short = 0xFFFE;
  std::vector<Stretch> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [](const Stretch& one) { return one.last <= last_short; });
  some.push_back({0xFFFF, 0xFFFF, 0});
  const auto count = static_cast<unsigned>(some.size());
  std::string out;
  put_u16(out, 4);
  put_u16(out, static_cast<std::uint16_t>(16 + 8 * count));
  put_u16(out, 0);
  put_u16(out, static_cast<std::uint16_t>(2 * count));
  put_search(out, count, 2);
  for (const Stretch& one : some) put_u16(out, static_cast<std::uint16_t>(one.last));
  put_u16(out, 0);
  for (const Stretch& one : some) put_u16(out, static_cast<std::uint16_t>(one.first));
  for (const Stretch& one : some) put_u16(out, static_cast<std::uint16_t>(one.glyph - one.first));
  for (unsigned i = 0; i < count; ++i) put_u16(out, 0);
  return out;
}

/// Format 12: every plane.
std::string long_map(const std::vector<Stretch>& all) {
  std::string out;
  put_u16(out, 12);
  put_u16(out, 0);
  put_u32(out, static_cast<std::uint32_t>(16 + 12 * all.size()));
  put_u32(out, 0);
  put_u32(out, static_cast<std::uint32_t>(all.size()));
  for (const Stretch& one : all) {
    put_u32(out, one.first);
    put_u32(out, one.last);
    put_u32(out, one.glyph);
  }
  return out;
}

std::string utf16(const std::string& ascii) {
  std::string out;
  for (const char c : ascii) put_u16(out, static_cast<std::uint8_t>(c));
  return out;
}

constexpr std::uint16_t windows = 3;
constexpr std::uint16_t unicode = 1;
constexpr std::uint16_t english = 0x0409;

/// A name as the font has it for Windows, in UTF-16; empty if it has none.
std::string original_name(const TrueTypeFile& font, std::uint16_t wanted) {
  const std::string_view names = font.table("name");
  const unsigned count = u16_at(names, 2);
  const std::size_t texts = u16_at(names, 4);
  for (unsigned i = 0; i < count; ++i) {
    const std::size_t at = 6 + 12UL * i;
    if (u16_at(names, at) != windows || u16_at(names, at + 2) != unicode ||
        u16_at(names, at + 4) != english || u16_at(names, at + 6) != wanted) {
      continue;
    }
    const std::size_t length = u16_at(names, at + 8);
    const std::size_t start = texts + u16_at(names, at + 10);
    if (start > names.size() || length > names.size() - start) return {};
    return std::string(names.substr(start, length));
  }
  return {};
}

}  // namespace

void put_u16(std::string& out, std::uint16_t value) {
  out += static_cast<char>(value >> 8U);
  out += static_cast<char>(value & 0xFFU);
}

void put_u32(std::string& out, std::uint32_t value) {
  put_u16(out, static_cast<std::uint16_t>(value >> 16U));
  put_u16(out, static_cast<std::uint16_t>(value & 0xFFFFU));
}

std::string head_table(const TrueTypeFile& font) {
  constexpr std::uint16_t about_hinting = 0x001C;
  std::string head = copy_of(font, "head", 54);
  set_u16(head, 8, 0);  // the sum over the file, filled in at the end
  set_u16(head, 10, 0);
  set_u16(head, 16, static_cast<std::uint16_t>(u16_at(head, 16) & ~about_hinting));
  set_u16(head, 50, 1);  // long offsets
  return head;
}

std::string hhea_table(const TrueTypeFile& font, std::uint16_t glyphs) {
  std::string hhea = copy_of(font, "hhea", 36);
  set_u16(hhea, 34, glyphs);
  return hhea;
}

std::string maxp_table(const TrueTypeFile& font, std::uint16_t glyphs) {
  std::string maxp = copy_of(font, "maxp", 32);
  set_u16(maxp, 4, glyphs);
  for (const std::size_t about_hinting : {16U, 18U, 20U, 22U, 24U, 26U}) {
    set_u16(maxp, about_hinting, 0);
  }
  return maxp;
}

std::string cmap_table(const GlyphNumbers& glyphs) {
  constexpr std::uint16_t all_planes = 10;
  const std::vector<Stretch> all = stretches(glyphs);
  const std::string basic = short_map(all);
  std::string out;
  put_u16(out, 0);
  put_u16(out, 2);
  constexpr std::uint32_t header = 4 + 2 * 8;
  put_u16(out, windows);
  put_u16(out, unicode);
  put_u32(out, header);
  put_u16(out, windows);
  put_u16(out, all_planes);
  put_u32(out, header + static_cast<std::uint32_t>(basic.size()));
  return out + basic + long_map(all);
}

std::string name_table(const TrueTypeFile& font, const std::string& family) {
  constexpr std::uint16_t copyright = 0;
  constexpr std::uint16_t licence_address = 14;
  const std::map<std::uint16_t, std::string> names{
      {copyright, original_name(font, copyright)},
      {1, utf16(family)},
      {2, utf16("Regular")},
      {4, utf16(family)},
      {6, utf16(family)},
      {licence_address, original_name(font, licence_address)}};
  std::string records;
  std::string texts;
  for (const auto& [kind, text] : names) {
    for (const std::uint16_t value : {windows, unicode, english, kind}) put_u16(records, value);
    put_u16(records, static_cast<std::uint16_t>(text.size()));
    put_u16(records, static_cast<std::uint16_t>(texts.size()));
    texts += text;
  }
  std::string out;
  put_u16(out, 0);
  put_u16(out, static_cast<std::uint16_t>(names.size()));
  put_u16(out, static_cast<std::uint16_t>(6 + records.size()));
  return out + records + texts;
}

std::string os2_table(const TrueTypeFile& font, const GlyphNumbers& glyphs) {
  std::string out = copy_of(font, "OS/2", 78);
  if (glyphs.empty()) return out;
  const auto short_code = [](char32_t c) {
    return static_cast<std::uint16_t>(std::min<char32_t>(c, 0xFFFF));
  };
  set_u16(out, 64, short_code(glyphs.begin()->first));
  set_u16(out, 66, short_code(glyphs.rbegin()->first));
  return out;
}

/// Format 3: glyphs have no names.
std::string post_table(const TrueTypeFile& font) {
  std::string post = copy_of(font, "post", 32).substr(0, 32);
  set_u16(post, 0, 3);
  set_u16(post, 2, 0);
  return post;
}

std::string kern_table(const TrueTypeFile& font, const std::vector<unsigned>& originals,
                       std::size_t characters) {
  std::string pairs;
  unsigned count = 0;
  const std::size_t last = std::min(characters, originals.size() - 1);
  for (std::size_t left = 1; left <= last; ++left) {
    for (std::size_t right = 1; right <= last; ++right) {
      const int value = font.kerning(originals[left], originals[right]);
      if (value == 0) continue;
      put_u16(pairs, static_cast<std::uint16_t>(left));
      put_u16(pairs, static_cast<std::uint16_t>(right));
      put_u16(pairs, static_cast<std::uint16_t>(value));
      ++count;
    }
  }
  constexpr unsigned most = (std::numeric_limits<std::uint16_t>::max() - 14) / 6;
  if (count == 0 || count > most) return {};
  std::string out;
  put_u16(out, 0);
  put_u16(out, 1);
  put_u16(out, 0);
  put_u16(out, static_cast<std::uint16_t>(14 + 6 * count));
  put_u16(out, 1);  // horizontal, pairs
  put_u16(out, static_cast<std::uint16_t>(count));
  put_search(out, count, 6);
  return out + pairs;
}

}  // namespace tribolog::render::vector
