#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/figure/drawing_style.h"
#include "render/figure/figure.h"
#include "render/layout/label_placement.h"
#include "render/scene/annotations.h"

namespace tribolog::render::scene {
namespace {

constexpr int directions = 24;
constexpr std::array<double, 9> distances{8, 16, 28, 44, 64, 90, 120, 160, 210};  // in units
constexpr double leader_from = 20;   // a box farther away than this is tied to its anchor
constexpr double far_cost = 0.02;    // per unit of distance
constexpr double solid_cost = 14.0;  // for a box wholly on parts
constexpr double line_cost = 6.0;    // for a box that a line touches
constexpr double lines_cost = 12.0;  // and for one wholly covered by lines
constexpr double clash_cost = 100.0;
constexpr double crossing_cost = 15.0;
constexpr double misleading_cost = 2.0;
constexpr double widest_share = 0.4;  // of the room
constexpr int rounds = 6;

struct Placed {
  std::size_t index{};
  figure::PixelPoint anchor;
  text::TextLine line;
  figure::PixelPoint start;
  figure::PixelBox box;
  figure::PixelPoint leader_end;
  bool has_leader{false};
};

/// Where a leader ends: beside the middle of the text, or above or below its nearest letter.
figure::PixelPoint leader_end(const figure::PixelBox& box, figure::PixelPoint from) {
  if (from.x < box.left || from.x > box.right) {
    return {std::clamp(from.x, box.left, box.right), box.centre().y};
  }
  return {from.x, std::clamp(from.y, box.top, box.bottom)};
}

double side_of(figure::PixelPoint a, figure::PixelPoint b, figure::PixelPoint p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool cross_each_other(figure::PixelPoint a, figure::PixelPoint b, figure::PixelPoint c,
                      figure::PixelPoint d) {
  return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

bool meets(figure::PixelPoint a, figure::PixelPoint b, const figure::PixelBox& box) {
  const figure::PixelPoint corners[] = {
      {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}};
  if (box.contains(a) || box.contains(b)) return true;
  for (int i = 0; i < 4; ++i) {
    if (cross_each_other(a, b, corners[i], corners[(i + 1) % 4])) return true;
  }
  return false;
}

class Placer {
 public:
  Placer(std::vector<Placed>& all, const figure::PixelBox& room, const Obstacles& obstacles,
         double unit)
      : all_(all), room_(room), obstacles_(obstacles), unit_(unit) {}

  void run() {
    for (int round = 0; round < rounds; ++round) {
      bool moved = false;
      for (std::size_t i = 0; i < all_.size(); ++i) moved = improve(i, round == 0) || moved;
      if (!moved) break;
    }
  }

  [[nodiscard]] bool collide(const Placed& a, const Placed& b) const {
    return figure::overlap_area(a.box.grown(3 * unit_), b.box) > 0 ||
           (a.has_leader && meets(a.anchor, a.leader_end, b.box)) ||
           (b.has_leader && meets(b.anchor, b.leader_end, a.box));
  }

 private:
  bool improve(std::size_t i, bool first) {
    const Placed before = all_[i];
    double best = first ? 1e300 : cost(i, before);
    for (const double distance : distances) {
      for (int k = 0; k < directions; ++k) {
        const Placed candidate = at(before, distance * unit_, k);
        const double price = cost(i, candidate);
        if (price < best - 1e-9) {
          best = price;
          all_[i] = candidate;
        }
      }
    }
    return !(all_[i].box == before.box);
  }

  /// The caption `distance` from its anchor in direction `k`.
  [[nodiscard]] Placed at(const Placed& caption, double distance, int k) const {
    Placed moved = caption;
    moved.start =
        layout::start_beside(caption.anchor, caption.line, distance, k, directions, room_);
    moved.box = text::box_of_line(caption.line, moved.start, true);
    moved.has_leader = layout::distance_to(moved.box, moved.anchor) > leader_from * unit_;
    moved.leader_end = leader_end(moved.box.grown(3 * unit_), moved.anchor);
    return moved;
  }

  [[nodiscard]] double cost(std::size_t i, const Placed& one) const {
    const double away = layout::distance_to(one.box, one.anchor) / unit_;
    const figure::PixelBox box = one.box.grown(3 * unit_);
    double sum = far_cost * away + solid_cost * obstacles_.solid.share_taken(box);
    if (obstacles_.lines.taken(box) > 0) {
      sum += line_cost + lines_cost * obstacles_.lines.share_taken(box);
    }
    if (away < 4) sum += clash_cost / 4;  // on its own anchor
    for (std::size_t j = 0; j < all_.size(); ++j) {
      const Placed& other = all_[j];
      if (j == i) continue;
      const double to_other = layout::distance_to(one.box, other.anchor);
      if (to_other < 6 * unit_) sum += clash_cost / 4;
      if (to_other < away * unit_) sum += misleading_cost;
      if (other.box.width() <= 0) continue;
      if (collide(one, other)) sum += clash_cost;
      if (one.has_leader && other.has_leader &&
          cross_each_other(one.anchor, one.leader_end, other.anchor, other.leader_end)) {
        sum += crossing_cost;
      }
    }
    return sum;
  }

  std::vector<Placed>& all_;
  figure::PixelBox room_;
  const Obstacles& obstacles_;
  double unit_;
};

void draw_leader(figure::DrawList& list, const Placed& one, figure::Colour colour,
                 const layout::FigureStyle& style) {
  const figure::Owner owner{figure::Role::label_leader, 0, static_cast<int>(one.index)};
  const double width = std::max(1.0, 1.8 * style.unit);
  list.primitives.emplace_back(figure::Polyline{
      owner, {one.anchor, one.leader_end}, width + 3 * style.unit, layout::ink::white, {}});
  list.primitives.emplace_back(
      figure::Polyline{owner, {one.anchor, one.leader_end}, width, colour, {}});
  list.primitives.emplace_back(
      figure::Markers{owner, figure::Marker::circle, {one.anchor}, 9 * style.unit, colour});
}

void draw_with_halo(figure::DrawList& list, const Placed& one, const layout::FigureStyle& style) {
  text::TextLine halo = one.line;
  halo.style.colour = layout::ink::white;
  const double reach = std::max(1.0, std::round(2.5 * style.unit));
  for (const double dy : {-reach, 0.0, reach}) {
    for (const double dx : {-reach, 0.0, reach}) {
      if (dx == 0 && dy == 0) continue;
      text::place_line(list, halo, {one.start.x + dx, one.start.y + dy}, true,
                       {figure::Role::text_backing, 0, static_cast<int>(one.index)});
    }
  }
  text::place_line(list, one.line, one.start, true,
                   {figure::Role::label_text, 0, static_cast<int>(one.index)});
}

}  // namespace

void draw_captions(figure::DrawList& list, const std::vector<Caption>& captions,
                   const figure::PixelBox& room, const Obstacles& obstacles, const text::Font& font,
                   const layout::FigureStyle& style, text::TextFaults& faults) {
  std::vector<Placed> all;
  for (std::size_t i = 0; i < captions.size(); ++i) {
    const Caption& caption = captions[i];
    if (!room.contains(caption.anchor)) {
      list.warnings.push_back({"drawing.named_outside", {{"text", caption.text}}});
    }
    bool cut = false;
    const auto lines = text::wrap_lines(font, caption.text, style.label,
                                        widest_share * room.width(), 1, faults, cut);
    if (lines.empty() || lines.front().empty()) continue;
    if (cut) {
      list.warnings.push_back({"drawing.text_cut", {{"text", figure::name_of_text(caption.text)}}});
    }
    Placed one;
    one.index = i;
    one.anchor = caption.anchor;
    one.line = lines.front();
    one.line.style.colour = figure::readable_on_paper(caption.colour);
    all.push_back(std::move(one));
  }
  Placer placer(all, room, obstacles, style.unit);
  placer.run();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!placer.collide(all[i], all[j])) continue;
      list.warnings.push_back(
          {"drawing.no_room_between",
           {{"first", captions[all[j].index].text}, {"second", captions[all[i].index].text}}});
    }
  }
  for (const Placed& one : all) {
    if (one.has_leader) draw_leader(list, one, captions[one.index].colour, style);
  }
  for (const Placed& one : all) draw_with_halo(list, one, style);
}

}  // namespace tribolog::render::scene
