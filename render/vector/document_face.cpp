#include "render/vector/document_face.h"

#include <algorithm>

#include <fmt/format.h>
#include <libdeflate.h>

#include "base/error.h"
#include "render/text/utf8.h"

namespace tribolog::render::vector {
namespace {

text::Weight weight_of(const figure::TextRun& run) {
  return run.bold ? text::Weight::bold : text::Weight::regular;
}

std::map<char32_t, unsigned> glyphs_of(const text::Font& font, text::Weight weight,
                                       const std::set<char32_t>& characters) {
  std::map<char32_t, unsigned> out;
  for (const char32_t c : characters) out.emplace(c, font.glyph(weight, c));
  return out;
}

/// Six letters, as names of subsets in PDF have them.
std::string tag_of(const std::map<char32_t, unsigned>& glyphs) {
  std::uint32_t sum = 0;
  for (const auto& [character, glyph] : glyphs) {
    const std::uint32_t pair[] = {character, glyph};
    sum = libdeflate_crc32(sum, pair, sizeof pair);
  }
  std::string tag;
  for (int i = 0; i < 6; ++i) {
    tag += static_cast<char>('A' + sum % 26);
    sum /= 26;
  }
  return tag;
}

}  // namespace

DocumentFace::DocumentFace(const text::Font& font, text::Weight weight,
                           const std::set<char32_t>& characters)
    : weight_(weight),
      file_(std::make_unique<TrueTypeFile>(font.file(weight))),
      originals_(glyphs_of(font, weight, characters)) {
  name_ = fmt::format("{}+DejaVuSans{}", tag_of(originals_),
                      weight == text::Weight::bold ? "Bold" : "");
  subset_ = true_type_subset(*file_, originals_, name_);
}

double DocumentFace::advance_em(char32_t c) const {
  return static_cast<double>(file_->advance(original(c))) / file_->units_per_em();
}

std::vector<SetGlyph> DocumentFace::set(const figure::TextRun& run) const {
  std::vector<SetGlyph> out;
  unsigned previous = 0;
  for (const char32_t c : text::decode_utf8(run.text).text) {
    const unsigned glyph = original(c);
    const double kerning =
        out.empty() ? 0.0
                    : static_cast<double>(file_->kerning(previous, glyph)) / file_->units_per_em();
    out.push_back({subset_.glyphs.at(c), kerning});
    previous = glyph;
  }
  return out;
}

double DocumentFace::letter_spacing(const figure::TextRun& run) const {
  constexpr double most_em = 0.1;
  double natural_em = 0;
  const std::u32string text = text::decode_utf8(run.text).text;
  for (const char32_t c : text) natural_em += advance_em(c);
  for (const SetGlyph& one : set(run)) natural_em += one.kerning_em;
  if (text.empty()) return 0.0;
  const double length = run.upright ? run.box.width() : run.box.height();
  const double most = most_em * run.size;
  return std::clamp((length - natural_em * run.size) / static_cast<double>(text.size()), -most,
                    most);
}

std::vector<DocumentFace> document_faces(const figure::DrawList& list, const text::Font& font) {
  std::map<text::Weight, std::set<char32_t>> characters;
  for (const figure::Primitive& primitive : list.primitives) {
    const auto* run = std::get_if<figure::TextRun>(&primitive);
    if (run == nullptr) continue;
    for (const char32_t c : text::decode_utf8(run->text).text)
      characters[weight_of(*run)].insert(c);
  }
  std::vector<DocumentFace> faces;
  for (const auto& [weight, used] : characters) faces.emplace_back(font, weight, used);
  return faces;
}

const DocumentFace& face_of(const std::vector<DocumentFace>& faces, const figure::TextRun& run) {
  const auto found = std::find_if(faces.begin(), faces.end(), [&](const DocumentFace& face) {
    return face.weight() == weight_of(run);
  });
  if (found == faces.end()) throw FigureError({"drawing.text_without_font"});
  return *found;
}

}  // namespace tribolog::render::vector
