#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "render/vector/true_type.h"

namespace tribolog::render::vector {
namespace {

constexpr std::uint32_t true_type_outlines = 0x00010000;
constexpr std::uint16_t restricted_licence = 0x0002;  // of OS/2's fsType
constexpr std::uint16_t bitmaps_only = 0x0200;

void require(bool inside) {
  if (!inside) throw FigureError({"drawing.font_number_beyond_table"});
}

std::string bytes_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (bytes.empty()) throw FigureError({"drawing.font_file_not_readable", {{"file", path}}});
  return bytes;
}

}  // namespace

std::uint16_t u16_at(std::string_view bytes, std::size_t at) {
  require(at + 2 <= bytes.size());
  return static_cast<std::uint16_t>((static_cast<std::uint8_t>(bytes[at]) << 8U) |
                                    static_cast<std::uint8_t>(bytes[at + 1]));
}

std::int16_t i16_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::int16_t>(u16_at(bytes, at));
}

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  return (static_cast<std::uint32_t>(u16_at(bytes, at)) << 16U) | u16_at(bytes, at + 2);
}

TrueTypeFile::TrueTypeFile(const std::string& path) : path_(path), bytes_(bytes_of_file(path)) {
  read_directory();
  const std::string_view head = table("head");
  units_per_em_ = u16_at(head, 18);
  long_offsets_ = u16_at(head, 50) != 0;
  glyph_count_ = u16_at(table("maxp"), 4);
  metric_count_ = u16_at(table("hhea"), 34);
  if (units_per_em_ == 0 || metric_count_ == 0) {
    throw FigureError({"drawing.font_file_damaged", {{"file", path_}}});
  }
  const std::uint16_t embedding = u16_at(table("OS/2"), 8);
  if ((embedding & (restricted_licence | bitmaps_only)) != 0) {
    throw FigureError({"drawing.font_not_embeddable", {{"file", path_}}});
  }
  read_kerning();
}

void TrueTypeFile::read_directory() {
  constexpr std::size_t header = 12;
  constexpr std::size_t entry = 16;
  if (bytes_.size() < header || u32_at(bytes_, 0) != true_type_outlines) {
    throw FigureError({"drawing.font_without_outlines", {{"file", path_}}});
  }
  const unsigned count = u16_at(bytes_, 4);
  for (unsigned i = 0; i < count; ++i) {
    const std::size_t at = header + i * entry;
    const std::size_t offset = u32_at(bytes_, at + 8);
    const std::size_t length = u32_at(bytes_, at + 12);
    if (offset > bytes_.size() || length > bytes_.size() - offset) {
      throw FigureError({"drawing.font_file_cut_off", {{"file", path_}}});
    }
    tables_.emplace(bytes_.substr(at, 4), std::string_view(bytes_).substr(offset, length));
  }
}

std::string_view TrueTypeFile::table(const std::string& tag) const {
  const auto found = tables_.find(tag);
  if (found == tables_.end()) {
    throw FigureError({"drawing.font_without_table", {{"file", path_}, {"table", tag}}});
  }
  return found->second;
}

std::string_view TrueTypeFile::glyph(unsigned id) const {
  if (id >= glyph_count_) {
    throw FigureError({"drawing.font_without_glyph", {{"file", path_}, {"glyph", id}}});
  }
  const std::string_view offsets = table("loca");
  const auto offset = [&](unsigned i) -> std::size_t {
    return long_offsets_ ? u32_at(offsets, 4UL * i) : 2UL * u16_at(offsets, 2UL * i);
  };
  const std::string_view outlines = table("glyf");
  const std::size_t from = offset(id);
  const std::size_t to = offset(id + 1);
  require(from <= to && to <= outlines.size());
  return outlines.substr(from, to - from);
}

std::uint16_t TrueTypeFile::advance(unsigned id) const {
  return u16_at(table("hmtx"), 4UL * std::min(id, metric_count_ - 1));
}

std::int16_t TrueTypeFile::left_side_bearing(unsigned id) const {
  const std::size_t at =
      id < metric_count_ ? 4UL * id + 2 : 4UL * metric_count_ + 2UL * (id - metric_count_);
  return i16_at(table("hmtx"), at);
}

int TrueTypeFile::kerning(unsigned left, unsigned right) const {
  const auto found = kerning_.find((left << 16U) | right);
  return found == kerning_.end() ? 0 : found->second;
}

/// The table of pairs, format 0; other formats are not used by the fonts that are drawn with.
void TrueTypeFile::read_kerning() {
  constexpr std::uint16_t horizontal_pairs = 0x0001;
  constexpr std::uint16_t direction_and_format = 0xFF05;
  if (!has("kern")) return;
  const std::string_view kern = table("kern");
  if (u16_at(kern, 0) != 0 || u16_at(kern, 2) == 0) return;
  if ((u16_at(kern, 8) & direction_and_format) != horizontal_pairs) return;
  const unsigned count = u16_at(kern, 10);
  for (unsigned i = 0; i < count; ++i) {
    const std::size_t at = 18 + 6UL * i;
    kerning_.emplace(u32_at(kern, at), i16_at(kern, at + 4));
  }
}

}  // namespace tribolog::render::vector
