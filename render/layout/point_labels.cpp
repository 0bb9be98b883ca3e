#include <algorithm>
#include <array>
#include <cmath>

#include "render/figure/contrast_ratio.h"
#include "render/layout/beside_point.h"
#include "render/layout/label_placement.h"
#include "render/layout/text_backing.h"

namespace tribolog::render {
namespace {

constexpr int directions = 16;
constexpr std::array<double, 6> distances{10, 22, 40, 64, 96, 140};  // point to box, in units
constexpr double leader_from = 18;  // a box farther away than this is tied to its point
constexpr double far_cost = 0.012;  // per unit of distance
constexpr double data_cost = 6.0;   // for a box wholly on data
constexpr double clash_cost = 100.0;
constexpr int rounds = 4;

struct Label {
  int index{};
  PixelPoint point;
  TextLine line;
  PixelPoint start;
  PixelBox box;
};

PixelPoint nearest_in(const PixelBox& box, PixelPoint p) {
  return {std::clamp(p.x, box.left, box.right), std::clamp(p.y, box.top, box.bottom)};
}

class Placer {
 public:
  Placer(std::vector<Label>& labels, const PixelBox& plot, const Occupancy& taken,
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
    const PixelBox before = label.box;
    double best = first ? 1e300 : cost(i, label.box);
    for (const double distance : distances) {
      for (int k = 0; k < directions; ++k) {
        const PixelPoint start =
            start_beside(label.point, label.line, distance * unit_, k, directions, room_);
        const PixelBox box = box_of_line(label.line, start, true);
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

  [[nodiscard]] double cost(std::size_t i, const PixelBox& box) const {
    const Label& label = labels_[i];
    const double away = distance_to(box, label.point) / unit_;
    double sum = far_cost * away + data_cost * taken_.share_taken(box.grown(2 * unit_));
    if (away < 5) sum += clash_cost / 2;  // on its own point
    if (marks_.touched_by(box.grown(unit_))) sum += clash_cost / 2;
    for (std::size_t j = 0; j < labels_.size(); ++j) {
      if (j == i) continue;
      const Label& other = labels_[j];
      if (other.box.width() > 0 && overlap_area(box.grown(4 * unit_), other.box) > 0) {
        sum += clash_cost;
      }
      if (distance_to(box, other.point) < 9 * unit_) sum += clash_cost / 2;
      // A text nearer to another point than to its own misleads.
      if (distance_to(box, other.point) < distance_to(box, label.point)) sum += 1.0;
    }
    return sum;
  }

  std::vector<Label>& labels_;
  PixelBox room_;
  const Occupancy& taken_;
  const DiscreteMarks& marks_;
  double unit_;
};

}  // namespace

void draw_point_labels(DrawList& list, const PanelFrame& frame, const Panel& panel,
                       const Font& font, const FigureStyle& style, int index, Occupancy& taken,
                       const DiscreteMarks& marks, TextFaults& faults) {
  std::vector<Label> labels;
  for (std::size_t i = 0; i < panel.point_labels.size(); ++i) {
    const PointLabel& point = panel.point_labels[i];
    if (!drawable(point.x, frame.x.logarithmic()) || !drawable(point.y, frame.y.logarithmic())) {
      list.warnings.push_back("point '" + point.text + "' is not finite; it was left out");
      continue;
    }
    Label label{static_cast<int>(i), {frame.x.pixel(point.x), frame.y.pixel(point.y)}, {}, {}, {}};
    if (!frame.plot.grown(1).contains(label.point)) {
      list.warnings.push_back("point '" + point.text + "' lies outside its axes; it was left out");
      continue;
    }
    bool cut = false;
    label.line =
        wrap_lines(font, point.text, style.label, 0.6 * frame.plot.width(), 1, faults, cut).front();
    label.line.style.colour = readable_on_paper(point.colour);
    labels.push_back(std::move(label));
  }
  Placer(labels, frame.plot, taken, marks, style).run();

  const double marker_size = 15 * style.marker;
  for (const Label& label : labels) {
    const PointLabel& point = panel.point_labels[static_cast<std::size_t>(label.index)];
    if (distance_to(label.box, label.point) > leader_from * style.unit && !label.line.empty()) {
      list.primitives.emplace_back(
          Polyline{{Role::label_leader, index, label.index},
                   {label.point, nearest_in(label.box.grown(2 * style.unit), label.point)},
                   std::max(1.0, 1.8 * style.stroke),
                   point.colour,
                   {}});
      taken.mark(list.primitives.back());
    }
  }
  for (const Label& label : labels) {
    const PointLabel& point = panel.point_labels[static_cast<std::size_t>(label.index)];
    if (point.marker != Marker::none) {
      list.primitives.emplace_back(Markers{{Role::label_marker, index, label.index},
                                           point.marker,
                                           {label.point},
                                           marker_size,
                                           point.colour});
      taken.mark(list.primitives.back());
    }
    if (label.line.empty()) continue;
    draw_backing(list, label.box.grown(2 * style.unit), index, label.index);
    place_line(list, label.line, label.start, true, {Role::label_text, index, label.index});
    taken.mark(label.box.grown(2 * style.unit));
  }
}

}  // namespace tribolog::render
