#pragma once
// The weights of the font that a document carries with it, and how its texts are set in them.

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/text/font.h"
#include "render/vector/true_type_subset.h"

namespace tribolog::render::vector {

/// One character of a run, with what lies before it.
struct SetGlyph {
  std::uint16_t glyph{};  ///< In the subset.
  double kerning_em{};    ///< To add before it.
};

class DocumentFace {
 public:
  /// @param characters of which the font has a glyph
  /// @throw tribolog::FigureError if the font cannot be embedded.
  DocumentFace(const text::Font& font, text::Weight weight, const std::set<char32_t>& characters);

  [[nodiscard]] text::Weight weight() const { return weight_; }
  /// The same for the same characters, another one for others: two figures on one page do not take
  /// each other's glyphs.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const TrueTypeSubset& subset() const { return subset_; }
  [[nodiscard]] const TrueTypeFile& file() const { return *file_; }
  /// The glyph of a character in the whole font.
  [[nodiscard]] unsigned original(char32_t c) const { return originals_.at(c); }
  [[nodiscard]] double advance_em(char32_t c) const;

  [[nodiscard]] std::vector<SetGlyph> set(const figure::TextRun& run) const;
  /// What to add behind each character, in pixels, so that the run is as long as it was laid out:
  /// the layout counts in the whole pixels of hinted letters.
  [[nodiscard]] double letter_spacing(const figure::TextRun& run) const;

 private:
  text::Weight weight_;
  std::unique_ptr<TrueTypeFile> file_;
  std::map<char32_t, unsigned> originals_;
  TrueTypeSubset subset_;
  std::string name_;
};

/// The faces that the texts of a figure need: none, one or both.
std::vector<DocumentFace> document_faces(const figure::DrawList& list, const text::Font& font);

/// @pre the face is among them.
const DocumentFace& face_of(const std::vector<DocumentFace>& faces, const figure::TextRun& run);

}  // namespace tribolog::render::vector
