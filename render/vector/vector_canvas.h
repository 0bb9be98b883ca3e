#pragma once
// What a vector format can paint, and a draw list painted with it.

#include <string>
#include <vector>

#include "render/figure/draw_list.h"

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

}  // namespace tribolog::render::vector
