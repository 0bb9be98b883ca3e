#include "render/vector/true_type_subset.h"

#include <algorithm>

#include "base/error.h"
#include "render/vector/subset_glyphs.h"
#include "render/vector/subset_tables.h"

namespace tribolog::render {
namespace {

using Bytes = std::string;

std::uint32_t checksum(const Bytes& table) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    sum += static_cast<std::uint32_t>(static_cast<std::uint8_t>(table[i])) << (24U - 8U * (i % 4));
  }
  return sum;
}

/// The directory, then the tables, each padded to four bytes.
Bytes font_file(const std::map<std::string, Bytes>& tables) {
  const auto count = static_cast<std::uint16_t>(tables.size());
  std::uint16_t power = 1;
  std::uint16_t exponent = 0;
  while (power * 2 <= count) {
    power = static_cast<std::uint16_t>(power * 2);
    ++exponent;
  }
  Bytes out;
  put_u32(out, 0x00010000);
  put_u16(out, count);
  put_u16(out, static_cast<std::uint16_t>(power * 16));
  put_u16(out, exponent);
  put_u16(out, static_cast<std::uint16_t>((count - power) * 16));
  std::size_t offset = out.size() + 16UL * count;
  std::size_t head_at = 0;
  for (const auto& [tag, table] : tables) {
    if (tag == "head") head_at = offset;
    out += tag;
    put_u32(out, checksum(table));
    put_u32(out, static_cast<std::uint32_t>(offset));
    put_u32(out, static_cast<std::uint32_t>(table.size()));
    offset += (table.size() + 3) / 4 * 4;
  }
  for (const auto& [tag, table] : tables) {
    out += table;
    out.resize((out.size() + 3) / 4 * 4, '\0');
  }
  constexpr std::uint32_t wanted_sum = 0xB1B0AFBA;
  constexpr std::size_t adjustment = 8;
  Bytes difference;
  put_u32(difference, wanted_sum - checksum(out));
  out.replace(head_at + adjustment, 4, difference);
  return out;
}

}  // namespace

TrueTypeSubset true_type_subset(const TrueTypeFile& font,
                                const std::map<char32_t, unsigned>& characters,
                                const std::string& family) {
  TrueTypeSubset out;
  SubsetGlyphs glyphs(font);
  for (const auto& [character, id] : characters) {
    out.glyphs.emplace(character, glyphs.add(id));
  }
  const GlyphTables outlines = glyphs.tables();
  std::map<std::string, Bytes> tables;
  tables["glyf"] = outlines.glyf;
  tables["loca"] = outlines.loca;
  tables["hmtx"] = outlines.hmtx;
  tables["head"] = head_table(font);
  tables["hhea"] = hhea_table(font, glyphs.count());
  tables["maxp"] = maxp_table(font, glyphs.count());
  tables["cmap"] = cmap_table(out.glyphs);
  tables["name"] = name_table(font, family);
  tables["OS/2"] = os2_table(font, out.glyphs);
  tables["post"] = post_table(font);
  const Bytes kern = kern_table(font, glyphs.originals(), out.glyphs.size());
  if (!kern.empty()) tables["kern"] = kern;
  out.bytes = font_file(tables);
  return out;
}

}  // namespace tribolog::render
