#include "render/vector/pdf_font.h"

#include <cmath>

#include <fmt/format.h>

#include "render/text/utf8.h"

namespace tribolog::render {
namespace {

constexpr double per_em = 1000.0;  // PDF counts in thousandths

int scaled(const DocumentFace& face, int font_units) {
  return static_cast<int>(std::lround(per_em * font_units / face.file().units_per_em()));
}

/// Above the baseline: the top of a capital, as its outline states it.
int capital_height(const DocumentFace& face) {
  constexpr int of_the_usual_font = 729;
  const auto letter = face.subset().glyphs.find(U'H');
  if (letter == face.subset().glyphs.end()) return of_the_usual_font;
  constexpr std::size_t highest = 8;
  return scaled(face, i16_at(face.file().glyph(face.original(U'H')), highest));
}

int add_descriptor(PdfFile& file, const DocumentFace& face) {
  constexpr int symbolic = 4;
  const std::string_view head = face.file().table("head");
  const std::string_view hhea = face.file().table("hhea");
  const std::string& bytes = face.subset().bytes;
  const int program = file.add_stream(bytes, fmt::format("/Length1 {}", bytes.size()));
  const auto of_head = [&](std::size_t at) { return scaled(face, i16_at(head, at)); };
  const auto of_hhea = [&](std::size_t at) { return scaled(face, i16_at(hhea, at)); };
  return file.add(fmt::format(
      "<< /Type /FontDescriptor /FontName /{} /Flags {} /FontBBox [{} {} {} {}] /ItalicAngle 0 "
      "/Ascent {} /Descent {} /CapHeight {} /StemV {} /FontFile2 {} >>",
      face.name(), symbolic, of_head(36), of_head(38), of_head(40), of_head(42), of_hhea(4),
      of_hhea(6), capital_height(face), face.weight() == Weight::bold ? 150 : 80,
      pdf_reference(program)));
}

std::string widths(const DocumentFace& face) {
  std::string out = "[1 [";
  for (const auto& [character, glyph] : face.subset().glyphs) {
    out += fmt::format("{:.0f} ", per_em * face.advance_em(character));
  }
  out.back() = ']';
  return out + "]";
}

/// The codes of a character in UTF-16, without the mark at the front.
std::string utf16_digits(char32_t c) {
  const std::string text = pdf_text(encode_utf8(std::u32string(1, c)));
  return text.substr(5, text.size() - 6);
}

std::string unicode_map(const DocumentFace& face) {
  constexpr std::size_t most_at_once = 100;
  std::string out =
      "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n"
      "/CIDSystemInfo << /Registry (Adobe) /Ordering (UCS) /Supplement 0 >> def\n"
      "/CMapName /Adobe-Identity-UCS def\n/CMapType 2 def\n"
      "1 begincodespacerange\n<0000> <FFFF>\nendcodespacerange\n";
  std::size_t left = face.subset().glyphs.size();
  std::size_t in_block = 0;
  for (const auto& [character, glyph] : face.subset().glyphs) {
    if (in_block == 0) {
      in_block = std::min(left, most_at_once);
      out += fmt::format("{} beginbfchar\n", in_block);
    }
    out += fmt::format("<{:04X}> <{}>\n", glyph, utf16_digits(character));
    --left;
    if (--in_block == 0) out += "endbfchar\n";
  }
  return out + "endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n";
}

}  // namespace

int add_font(PdfFile& file, const DocumentFace& face) {
  const int glyphs = file.add(fmt::format(
      "<< /Type /Font /Subtype /CIDFontType2 /BaseFont /{} /CIDSystemInfo << /Registry (Adobe) "
      "/Ordering (Identity) /Supplement 0 >> /FontDescriptor {} /DW 600 /W {} /CIDToGIDMap "
      "/Identity >>",
      face.name(), pdf_reference(add_descriptor(file, face)), widths(face)));
  return file.add(fmt::format(
      "<< /Type /Font /Subtype /Type0 /BaseFont /{} /Encoding /Identity-H /DescendantFonts [{}] "
      "/ToUnicode {} >>",
      face.name(), pdf_reference(glyphs), pdf_reference(file.add_stream(unicode_map(face)))));
}

}  // namespace tribolog::render
