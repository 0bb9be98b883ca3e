#pragma once
// What a vector format can paint, a draw list painted with it, and the faces of the font that its
// texts are set in.

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/text/font.h"
#include "render/vector/true_type.h"

namespace tribolog::render::vector {

/// With up to `digits` digits behind the point (0 to 6) and no more than it takes: "12.5", "-0.07",
/// "3". The same in every locale. Not finite: "0".
std::string short_number(double value, int digits = 2);

/// "12.5 3"
std::string place_of(figure::PixelPoint p);

struct StrokeLook {
  double width{1.0};
  figure::Colour colour;
  std::vector<double> dashes;  ///< Ink and gap in turn; empty: solid.
};

/// Points and lengths in pixels of the draw list.
class VectorCanvas {
 public:
  using Points = std::vector<figure::PixelPoint>;

  virtual ~VectorCanvas() = default;
  /// Closed outlines, filled as one: where they overlap, the colour lies once.
  virtual void fill(const std::vector<Points>& outlines, figure::Colour colour) = 0;
  virtual void fill_discs(const Points& centres, double radius, figure::Colour colour) = 0;
  /// Round joins, butt ends. A line that returns to its first point is closed.
  virtual void stroke(const std::vector<Points>& lines, const StrokeLook& look) = 0;
  virtual void text(const figure::TextRun& run) = 0;
};

/// Paints in the order of the list what the painter of pictures would. Solid parts of a scene are
/// not painted.
void paint_on(VectorCanvas& canvas, const figure::DrawList& list);

/// Whether a stroked line ends where it began.
inline bool is_closed(const VectorCanvas::Points& line, const StrokeLook& look) {
  return look.dashes.empty() && line.size() > 3 && line.front() == line.back();
}

// The weights of the font that a document carries with it, and how its texts are set in them.

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
