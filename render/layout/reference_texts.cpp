#include <algorithm>
#include <cmath>
#include <limits>

#include "render/layout/label_placement.h"
#include "render/layout/text_backing.h"

namespace tribolog::render {
namespace {

constexpr int places_along = 12;
constexpr double mark_cost = 40.0;
constexpr double text_cost = 50.0;

struct Candidate {
  PixelPoint start;
  PixelBox box;
  double cost{};
};

/// Start of the baseline so that the line's box has this top left corner.
PixelPoint start_for(const TextLine& line, double left, double top) {
  return {left, top + line.ascent};
}

}  // namespace

void draw_reference_texts(DrawList& list, const PanelFrame& frame, const Panel& panel,
                          const Font& font, const FigureStyle& style, int index, Occupancy& taken,
                          DiscreteMarks& marks, TextFaults& faults) {
  std::vector<PixelBox> placed;
  const PixelBox room = frame.plot.grown(-0.6 * style.gap);
  for (std::size_t i = 0; i < panel.reference_lines.size(); ++i) {
    const ReferenceLine& reference = panel.reference_lines[i];
    const bool vertical = reference.direction == ReferenceLine::Direction::vertical;
    const AxisMap& axis = vertical ? frame.x : frame.y;
    if (reference.text.empty() || !drawable(reference.at, axis.logarithmic())) continue;
    const double at = axis.pixel(reference.at);
    if (vertical ? at < frame.plot.left || at > frame.plot.right
                 : at < frame.plot.top || at > frame.plot.bottom) {
      continue;
    }
    bool cut = false;
    const TextLine line =
        wrap_lines(font, reference.text, style.reference, room.width(), 1, faults, cut).front();
    Candidate best;
    best.cost = std::numeric_limits<double>::max();
    const auto offer = [&](double left, double top, double handicap) {
      left = std::clamp(left, room.left, std::max(room.left, room.right - line.width));
      top = std::clamp(top, room.top, std::max(room.top, room.bottom - line.height()));
      Candidate one{start_for(line, left, top), {}, handicap};
      one.box = box_of_line(line, one.start, true);
      one.cost += 10.0 * taken.share_taken(one.box.grown(3));
      for (const PixelBox& other : placed)
        one.cost += overlap_area(one.box, other) > 0 ? text_cost : 0;
      if (marks.touched_by(one.box.grown(3 * style.unit))) one.cost += mark_cost;
      if (one.cost < best.cost) best = one;
    };
    for (int k = 0; k <= places_along; ++k) {
      const double share = static_cast<double>(k) / places_along;
      const double handicap = 1.5 * share;  // near the end of the line if possible
      if (vertical) {
        const double top = room.top + share * (room.height() - line.height());
        offer(at + style.gap, top, handicap);
        offer(at - style.gap - line.width, top, handicap + 0.05);
      } else {
        const double left = room.right - line.width - share * (room.width() - line.width);
        offer(left, at - style.gap - line.height(), handicap);
        offer(left, at + style.gap, handicap + 0.05);
      }
    }
    draw_backing(list, best.box.grown(3 * style.unit), index, static_cast<int>(i));
    TextLine coloured = line;
    coloured.style.colour = ink::text;
    place_line(list, coloured, best.start, true,
               {Role::reference_text, index, static_cast<int>(i)});
    placed.push_back(best.box);
    taken.mark(best.box);
    marks.add(best.box.grown(3 * style.unit));
  }
}

}  // namespace tribolog::render
