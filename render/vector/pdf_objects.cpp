#include "render/vector/pdf_objects.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "render/png/png_encoder.h"
#include "render/text/characters.h"
#include "render/vector/true_type.h"

namespace tribolog::render::vector {

int PdfFile::reserve() {
  objects_.emplace_back();
  return static_cast<int>(objects_.size());
}

void PdfFile::write(int number, const std::string& body) {
  objects_.at(static_cast<std::size_t>(number) - 1) = body;
}

int PdfFile::add(const std::string& body) {
  objects_.push_back(body);
  return static_cast<int>(objects_.size());
}

int PdfFile::add_stream(const std::string& data, const std::string& entries) {
  const std::vector<std::uint8_t> packed = png::zlib_compressed({data.begin(), data.end()});
  return add_compressed(std::string(packed.begin(), packed.end()), entries);
}

int PdfFile::add_compressed(const std::string& data, const std::string& entries) {
  return add(fmt::format("<< {} /Filter /FlateDecode /Length {} >>\nstream\n{}\nendstream", entries,
                         data.size(), data));
}

std::string PdfFile::finish(int catalogue, int information) {
  // Bytes above 127 in the second line tell programs that the file is not text.
  std::string out = "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n";
  std::string table = fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects_.size() + 1);
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", out.size());
    out += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects_[i]);
  }
  const std::size_t table_at = out.size();
  return out + table +
         fmt::format("trailer\n<< /Size {} /Root {} /Info {} >>\nstartxref\n{}\n%%EOF\n",
                     objects_.size() + 1, pdf_reference(catalogue), pdf_reference(information),
                     table_at);
}

std::string pdf_reference(int number) { return fmt::format("{} 0 R", number); }

std::string pdf_text(const std::string& utf8) {
  constexpr char32_t first_of_pairs = 0x10000;
  std::string out = "<FEFF";
  for (char32_t c : text::decode_utf8(utf8).text) {
    if (c < first_of_pairs) {
      out += fmt::format("{:04X}", static_cast<std::uint32_t>(c));
      continue;
    }
    c -= first_of_pairs;
    out += fmt::format("{:04X}{:04X}", 0xD800U + (static_cast<std::uint32_t>(c) >> 10U),
                       0xDC00U + (static_cast<std::uint32_t>(c) & 0x3FFU));
  }
  return out + ">";
}

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
      of_hhea(6), capital_height(face), face.weight() == text::Weight::bold ? 150 : 80,
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
  const std::string text = pdf_text(text::encode_utf8(std::u32string(1, c)));
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

namespace {

struct PngParts {
  std::uint32_t width{};
  std::uint32_t height{};
  bool indexed{};
  std::string palette;
  std::string pixels;
};

PngParts parts_of(std::string_view png) {
  constexpr std::size_t signature = 8;
  constexpr std::uint8_t indexed = 3;
  PngParts parts;
  for (std::size_t at = signature; at + 12 <= png.size();) {
    const std::size_t size = u32_at(png, at);
    if (size > png.size() - at - 12) break;
    const std::string_view name = png.substr(at + 4, 4);
    const std::string_view data = png.substr(at + 8, size);
    if (name == "IHDR") {
      parts.width = u32_at(data, 0);
      parts.height = u32_at(data, 4);
      parts.indexed = data.size() > 9 && static_cast<std::uint8_t>(data[9]) == indexed;
    } else if (name == "PLTE") {
      parts.palette = data;
    } else if (name == "IDAT") {
      parts.pixels += data;
    }
    at += size + 12;
  }
  if (parts.width == 0 || parts.pixels.empty()) {
    throw FigureError({"drawing.solid_parts_damaged"});
  }
  return parts;
}

std::string hexadecimal(const std::string& bytes) {
  std::string out;
  for (const char c : bytes) out += fmt::format("{:02X}", static_cast<std::uint8_t>(c));
  return out;
}

}  // namespace

int add_picture(PdfFile& file, const std::vector<std::byte>& png) {
  const PngParts parts = parts_of({reinterpret_cast<const char*>(png.data()), png.size()});
  const std::string colours =
      parts.indexed ? fmt::format("[/Indexed /DeviceRGB {} <{}>]", parts.palette.size() / 3 - 1,
                                  hexadecimal(parts.palette))
                    : "/DeviceRGB";
  constexpr int filters_of_png = 15;
  return file.add_compressed(
      parts.pixels,
      fmt::format("/Type /XObject /Subtype /Image /Width {} /Height {} /BitsPerComponent 8 "
                  "/ColorSpace {} /DecodeParms << /Predictor {} /Colors {} /BitsPerComponent 8 "
                  "/Columns {} >>",
                  parts.width, parts.height, colours, filters_of_png, parts.indexed ? 1 : 3,
                  parts.width));
}

}  // namespace tribolog::render::vector
