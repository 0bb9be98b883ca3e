#include "render/layout/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/figure/draw_list.h"
#include "render/figure/drawing_style.h"
#include "render/layout/figure_style.h"

namespace tribolog::render::layout {

namespace {

constexpr std::size_t cloud = 150;  // markers
constexpr double core = 0.8;        // of a marker's size: texts may come close

figure::PixelBox box_of(figure::PixelPoint a, figure::PixelPoint b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

}  // namespace

void DiscreteMarks::add(const figure::Primitive& primitive) {
  const figure::Role role = figure::owner_of(primitive).role;
  const auto* markers = std::get_if<figure::Markers>(&primitive);
  if (markers != nullptr && role == figure::Role::series_marker &&
      markers->centres.size() < cloud) {
    for (const figure::PixelPoint& c : markers->centres) {
      add(box_of(c, c).grown(core * markers->size / 2));
    }
  }
  const auto* line = std::get_if<figure::Polyline>(&primitive);
  if (line != nullptr && role == figure::Role::error_bar) {
    add(box_of(line->points.front(), line->points.back()).grown(line->width / 2));
  }
}

bool DiscreteMarks::touched_by(const figure::PixelBox& box) const {
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const figure::PixelBox& one) {
    return figure::overlap_area(one, box) > 0;
  });
}

// White, almost opaque ground behind a text that stands on data.

namespace {

inline void draw_backing(figure::DrawList& list, const figure::PixelBox& box, int panel,
                         int index) {
  list.primitives.emplace_back(figure::Polygon{
      {figure::Role::text_backing, panel, index},
      {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}},
      ink::backing});
}

constexpr int directions = 16;
constexpr std::array<double, 7> distances{10, 22, 40, 64, 96, 140, 190};  // point to box, in units
constexpr double leader_from = 18;  // a box farther away than this is tied to its point
constexpr double far_cost = 0.012;  // per unit of distance
constexpr double data_cost = 6.0;   // for a box wholly on data
constexpr double touch_cost = 2.0;  // for one that hides the least of a curve
constexpr double clash_cost = 100.0;
constexpr int rounds = 4;

struct Label {
  int index{};
  figure::PixelPoint point;
  text::TextLine line;
  figure::PixelPoint start;
  figure::PixelBox box;
};

figure::PixelPoint nearest_in(const figure::PixelBox& box, figure::PixelPoint p) {
  return {std::clamp(p.x, box.left, box.right), std::clamp(p.y, box.top, box.bottom)};
}

class Placer {
 public:
  Placer(std::vector<Label>& labels, const figure::PixelBox& plot, const Occupancy& taken,
         const DiscreteMarks& marks, const FigureStyle& style)
      : labels_(labels),
        room_(plot.grown(-0.4 * style.gap)),
        taken_(taken),
        marks_(marks),
        unit_(style.unit) {}

  void run() {
    for (int round = 0; round < rounds; ++round) {
      bool moved = false;
      for (std::size_t i = 0; i < labels_.size(); ++i) moved = improve(i, round == 0) || moved;
      if (!moved) break;
    }
  }

 private:
  bool improve(std::size_t i, bool first) {
    Label& label = labels_[i];
    const figure::PixelBox before = label.box;
    double best = first ? 1e300 : cost(i, label.box);
    for (const double distance : distances) {
      for (int k = 0; k < directions; ++k) {
        const figure::PixelPoint start =
            start_beside(label.point, label.line, distance * unit_, k, directions, room_);
        const figure::PixelBox box = text::box_of_line(label.line, start, true);
        const double candidate = cost(i, box);
        if (candidate < best - 1e-9) {
          best = candidate;
          label.start = start;
          label.box = box;
        }
      }
    }
    return !(label.box == before);
  }

  [[nodiscard]] double cost(std::size_t i, const figure::PixelBox& box) const {
    const Label& label = labels_[i];
    const double away = distance_to(box, label.point) / unit_;
    const double share = taken_.share_taken(box.grown(2 * unit_));
    double sum = far_cost * away + data_cost * share + (share > 0 ? touch_cost : 0);
    if (away < 5) sum += clash_cost / 2;  // on its own point
    if (marks_.touched_by(box.grown(unit_))) sum += clash_cost / 2;
    for (std::size_t j = 0; j < labels_.size(); ++j) {
      if (j == i) continue;
      const Label& other = labels_[j];
      if (other.box.width() > 0 && figure::overlap_area(box.grown(4 * unit_), other.box) > 0) {
        sum += clash_cost;
      }
      if (distance_to(box, other.point) < 9 * unit_) sum += clash_cost / 2;
      // A text nearer to another point than to its own misleads.
      if (distance_to(box, other.point) < distance_to(box, label.point)) sum += 1.0;
    }
    return sum;
  }

  std::vector<Label>& labels_;
  figure::PixelBox room_;
  const Occupancy& taken_;
  const DiscreteMarks& marks_;
  double unit_;
};

}  // namespace

void draw_point_labels(figure::DrawList& list, const PanelFrame& frame, const figure::Panel& panel,
                       const text::Font& font, const FigureStyle& style, int index,
                       Occupancy& taken, const DiscreteMarks& marks, text::TextFaults& faults) {
  std::vector<Label> labels;
  for (std::size_t i = 0; i < panel.point_labels.size(); ++i) {
    const figure::PointLabel& point = panel.point_labels[i];
    if (!drawable(point.x, frame.x.logarithmic()) || !drawable(point.y, frame.y.logarithmic())) {
      list.warnings.push_back({"drawing.point_not_finite", {{"label", point.text}}});
      continue;
    }
    Label label{static_cast<int>(i), {frame.x.pixel(point.x), frame.y.pixel(point.y)}, {}, {}, {}};
    if (!frame.plot.grown(1).contains(label.point)) {
      list.warnings.push_back({"drawing.point_outside_axes", {{"label", point.text}}});
      continue;
    }
    bool cut = false;
    label.line =
        text::wrap_lines(font, point.text, style.label, 0.6 * frame.plot.width(), 1, faults, cut)
            .front();
    label.line.style.colour = figure::readable_on_paper(point.colour);
    labels.push_back(std::move(label));
  }
  Placer(labels, frame.plot, taken, marks, style).run();

  const double marker_size = 15 * style.marker;
  for (const Label& label : labels) {
    const figure::PointLabel& point = panel.point_labels[static_cast<std::size_t>(label.index)];
    if (distance_to(label.box, label.point) > leader_from * style.unit && !label.line.empty()) {
      list.primitives.emplace_back(
          figure::Polyline{{figure::Role::label_leader, index, label.index},
                           {label.point, nearest_in(label.box.grown(2 * style.unit), label.point)},
                           std::max(1.0, 1.8 * style.stroke),
                           point.colour,
                           {}});
      taken.mark(list.primitives.back());
    }
  }
  for (const Label& label : labels) {
    const figure::PointLabel& point = panel.point_labels[static_cast<std::size_t>(label.index)];
    if (point.marker != figure::Marker::none) {
      list.primitives.emplace_back(figure::Markers{{figure::Role::label_marker, index, label.index},
                                                   point.marker,
                                                   {label.point},
                                                   marker_size,
                                                   point.colour});
      taken.mark(list.primitives.back());
    }
    if (label.line.empty()) continue;
    draw_backing(list, label.box.grown(2 * style.unit), index, label.index);
    text::place_line(list, label.line, label.start, true,
                     {figure::Role::label_text, index, label.index});
    taken.mark(label.box.grown(2 * style.unit));
  }
}

namespace {

constexpr int places_along = 100;
constexpr double curve_cost = 2.0;  // more than the way along the whole line
constexpr double mark_cost = 40.0;
constexpr double text_cost = 50.0;

struct Candidate {
  figure::PixelPoint start;
  figure::PixelBox box;
  double cost{};
};

/// Start of the baseline so that the line's box has this top left corner.
figure::PixelPoint start_for(const text::TextLine& line, double left, double top) {
  return {left, top + line.ascent};
}

}  // namespace

void draw_reference_texts(figure::DrawList& list, const PanelFrame& frame,
                          const figure::Panel& panel, const text::Font& font,
                          const FigureStyle& style, int index, Occupancy& taken,
                          DiscreteMarks& marks, text::TextFaults& faults) {
  std::vector<figure::PixelBox> placed;
  const figure::PixelBox room = frame.plot.grown(-0.6 * style.gap);
  for (std::size_t i = 0; i < panel.reference_lines.size(); ++i) {
    const figure::ReferenceLine& reference = panel.reference_lines[i];
    const bool vertical = reference.direction == figure::ReferenceLine::Direction::vertical;
    const AxisMap& axis = vertical ? frame.x : frame.y;
    if (reference.text.empty() || !drawable(reference.at, axis.logarithmic())) continue;
    const double at = axis.pixel(reference.at);
    if (vertical ? at < frame.plot.left || at > frame.plot.right
                 : at < frame.plot.top || at > frame.plot.bottom) {
      continue;
    }
    bool cut = false;
    const text::TextLine line =
        text::wrap_lines(font, reference.text, style.reference, room.width(), 1, faults, cut)
            .front();
    Candidate best;
    best.cost = std::numeric_limits<double>::max();
    const auto offer = [&](double left, double top, double handicap) {
      left = std::clamp(left, room.left, std::max(room.left, room.right - line.width));
      top = std::clamp(top, room.top, std::max(room.top, room.bottom - line.height()));
      Candidate one{start_for(line, left, top), {}, handicap};
      one.box = text::box_of_line(line, one.start, true);
      const double share = taken.share_taken(one.box.grown(3));
      one.cost += 10.0 * share + (share > 0 ? curve_cost : 0);
      for (const figure::PixelBox& other : placed)
        one.cost += figure::overlap_area(one.box, other) > 0 ? text_cost : 0;
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
    text::TextLine coloured = line;
    coloured.style.colour = ink::text;
    text::place_line(list, coloured, best.start, true,
                     {figure::Role::reference_text, index, static_cast<int>(i)});
    placed.push_back(best.box);
    taken.mark(best.box);
    marks.add(best.box.grown(3 * style.unit));
  }
}

}  // namespace tribolog::render::layout
