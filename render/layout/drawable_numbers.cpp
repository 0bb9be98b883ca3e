#include <algorithm>
#include <cmath>

#include "render/layout/diagram_checks.h"

namespace tribolog::render {
namespace {

constexpr double largest = 1e4;

bool drawable(double number) { return std::isfinite(number) && std::abs(number) <= largest; }

bool drawable(const DiagramPoint& point) { return drawable(point.x) && drawable(point.y); }

bool drawable(const DiagramText& text) { return drawable(text.at); }

bool drawable(const PortSign& sign) { return drawable(sign.offset); }

template <class Item>
bool all_drawable(const std::vector<Item>& items) {
  return std::all_of(items.begin(), items.end(), [](const Item& one) { return drawable(one); });
}

bool drawable_block(const Block& block) {
  return drawable(block.centre) && drawable(block.width) && drawable(block.height) &&
         all_drawable(block.signs);
}

bool drawable_wire(const Wire& wire) {
  return all_drawable(wire.points) && all_drawable(wire.branch_dots) &&
         (!wire.label || drawable(*wire.label));
}

bool drawable_arc(const Arc& arc) {
  return drawable(arc.centre) && drawable(arc.radius) && arc.radius > 0 && drawable(arc.from_deg) &&
         drawable(arc.to_deg) && drawable(arc.width_px);
}

}  // namespace

bool has_drawable_numbers(const Diagram& diagram) {
  const auto all = [](const auto& items, auto holds) {
    return std::all_of(items.begin(), items.end(), holds);
  };
  return drawable(diagram.width) && drawable(diagram.height) &&
         all(diagram.areas, [](const Area& one) { return all_drawable(one.outline); }) &&
         all(diagram.blocks, drawable_block) && all(diagram.wires, drawable_wire) &&
         all(diagram.strokes,
             [](const Stroke& one) {
               return all_drawable(one.points) && drawable(one.width_px);
             }) &&
         all(diagram.arcs, drawable_arc) &&
         all(diagram.dimensions,
             [](const Dimension& one) { return drawable(one.from) && drawable(one.to); }) &&
         all_drawable(diagram.texts);
}

}  // namespace tribolog::render
