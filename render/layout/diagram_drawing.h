#pragma once
// The sheet on which a diagram is laid out (millimetres to pixels, and a record of its texts), and
// what is drawn on it.

#include <string>
#include <utility>
#include <vector>

#include "render/figure/diagram.h"
#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"

namespace tribolog::render::layout {

/// A text as it was placed, for the checks.
struct PlacedText {
  std::string text;
  figure::PixelBox box;
  int block{-1};  ///< The block that it belongs to; -1: free-standing.
};

class DiagramCanvas {
 public:
  /// The canvas is fitted into `room`, as large as possible but for `most_px_per_mm`, and in its
  /// middle.
  DiagramCanvas(figure::DrawList& list, const figure::Diagram& diagram,
                const figure::PixelBox& room, const text::Font& font, double most_px_per_mm);

  [[nodiscard]] figure::PixelPoint pixel(figure::DiagramPoint p) const;
  [[nodiscard]] std::vector<figure::PixelPoint> pixels(
      const std::vector<figure::DiagramPoint>& points) const;
  [[nodiscard]] figure::PixelBox box(figure::DiagramPoint centre, double width,
                                     double height) const;
  /// Pixels of so many millimetres.
  [[nodiscard]] double length(double millimetres) const { return millimetres * px_per_mm_; }
  /// Pixels of so many pixels of the 1600 px picture.
  [[nodiscard]] double line_width(double designed_px) const;
  [[nodiscard]] figure::PixelBox area() const { return area_; }
  [[nodiscard]] double picture_width() const { return list_.width; }

  void line(figure::Owner owner, std::vector<figure::PixelPoint> points, double designed_px,
            figure::Colour colour, figure::LineStyle style = figure::LineStyle::solid);
  void filled(figure::Owner owner, std::vector<figure::PixelPoint> outline, figure::Colour colour);
  /// An arrow head with its tip at the end of the line, which is shortened to end inside the head.
  void head(figure::Owner owner, figure::PixelPoint behind, figure::PixelPoint& tip,
            double designed_px, figure::Colour colour);
  [[nodiscard]] double head_length(double designed_px) const;

  [[nodiscard]] text::TextLine shape(const std::string& text, double size_mm, bool bold,
                                     figure::Colour colour);
  /// A line of text around or beside a point.
  void text(figure::Owner owner, const text::TextLine& line, figure::PixelPoint at,
            figure::TextPlace place, const std::string& markup, int block);

  [[nodiscard]] const std::vector<PlacedText>& texts() const { return texts_; }
  text::TextFaults& faults() { return faults_; }
  void warn(Statement what) { list_.warnings.push_back(std::move(what)); }

 private:
  figure::DrawList& list_;
  const text::Font& font_;
  double px_per_mm_;
  figure::PixelBox area_;
  std::vector<PlacedText> texts_;
  text::TextFaults faults_;
};

/// Heights of letters in a diagram, in millimetres per em.
namespace letter {
inline constexpr double block_mm = 3.1;
inline constexpr double label_mm = 2.9;
inline constexpr double sign_mm = 2.8;
}  // namespace letter

/// Width in designed pixels of blocks' outlines and wires: that of a curve in a chart.
inline constexpr double diagram_line_px = 2.5;

// Blocks of a diagram: what each kind looks like.

/// The outline that wires end on, in pixels and closed (the last point repeats the first); for a
/// fixed support the line of its surface.
std::vector<figure::PixelPoint> block_outline(const DiagramCanvas& canvas,
                                              const figure::Block& block);

/// Fills must lie below every line, so they are drawn by a call of their own, before the outlines.
void draw_block_fill(DiagramCanvas& canvas, const figure::Block& block, int index);
void draw_block(DiagramCanvas& canvas, const figure::Block& block, int index);

/// Text and port signs. Warns of text that does not fit into the block.
void draw_block_texts(DiagramCanvas& canvas, const figure::Block& block, int index);

// Wires and the free shapes of a sketch.

/// The arc as a line of short steps.
std::vector<figure::PixelPoint> arc_points(const DiagramCanvas& canvas, const figure::Arc& arc);

void draw_wire(DiagramCanvas& canvas, const figure::Wire& wire, int index);

/// Areas and discs lie below every line.
void draw_shape_fills(DiagramCanvas& canvas, const figure::Diagram& diagram);
/// Strokes, arcs and dimension arrows, numbered on in this order.
void draw_shapes(DiagramCanvas& canvas, const figure::Diagram& diagram);
/// Labels of wires, texts of dimensions and free texts; `texts` of the diagram come last.
void draw_diagram_texts(DiagramCanvas& canvas, const figure::Diagram& diagram);

}  // namespace tribolog::render::layout
