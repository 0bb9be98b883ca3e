#pragma once
// Texts beside points and at reference lines, where they hide as little as possible.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"
#include "render/layout/occupancy.h"
#include "render/layout/panel_drawing.h"
#include "render/text/text_line.h"

namespace tribolog::render::layout {

/// 0 inside of the box.
inline double distance_to(const figure::PixelBox& box, figure::PixelPoint p) {
  const double dx = std::max({box.left - p.x, 0.0, p.x - box.right});
  const double dy = std::max({box.top - p.y, 0.0, p.y - box.bottom});
  return std::hypot(dx, dy);
}

/// Where a line starts (left end, on the baseline) so that the edge of its box lies `distance_px`
/// from the point in direction `k` of so many around it, the first up right. A box that would stick
/// out is pulled into the room.
inline figure::PixelPoint start_beside(figure::PixelPoint point, const text::TextLine& line,
                                       double distance_px, int k, int directions,
                                       const figure::PixelBox& room) {
  const double angle = std::numbers::pi * (2.0 * k / directions + 0.25);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double half_width = line.width / 2;
  const double half_height = line.height() / 2;
  // From the point to the centre of the box: the distance plus the box's own reach that way.
  const double x =
      point.x + cosine * distance_px + std::clamp(cosine * 1.5, -1.0, 1.0) * half_width;
  const double y = point.y - sine * distance_px - std::clamp(sine * 1.5, -1.0, 1.0) * half_height;
  const double left =
      std::clamp(x - half_width, room.left, std::max(room.left, room.right - line.width));
  const double top =
      std::clamp(y - half_height, room.top, std::max(room.top, room.bottom - line.height()));
  return {left, top + line.ascent};
}

// Marks that a reader looks at one by one: no text may hide any of them, however few pixels they
// take of a panel.

class DiscreteMarks {
 public:
  /// Takes up markers and intervals. Of a cloud of markers no single one matters; curves stay
  /// readable under a text.
  void add(const figure::Primitive& primitive);
  void add(const figure::PixelBox& box) { boxes_.push_back(box); }

  [[nodiscard]] bool touched_by(const figure::PixelBox& box) const;

 private:
  std::vector<figure::PixelBox> boxes_;
};

/// Places the texts of a panel's reference lines, then its point labels, and marks both in
/// `taken`. Point labels avoid each other, each other's points, the data and the panel's border;
/// one that ends up away from its point gets a leader line. Neither hides one of `marks` where
/// there is any other place; the texts of reference lines become marks for the labels.
void draw_reference_texts(figure::DrawList& list, const PanelFrame& frame,
                          const figure::Panel& panel, const text::Font& font,
                          const FigureStyle& style, int index, Occupancy& taken,
                          DiscreteMarks& marks, text::TextFaults& faults);
void draw_point_labels(figure::DrawList& list, const PanelFrame& frame, const figure::Panel& panel,
                       const text::Font& font, const FigureStyle& style, int index,
                       Occupancy& taken, const DiscreteMarks& marks, text::TextFaults& faults);

}  // namespace tribolog::render::layout
