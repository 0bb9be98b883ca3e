#include "paper/drawings/schematic.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tribolog::paper::drawings {

namespace {

using render::figure::Block;
using render::figure::BlockSide;
using render::figure::Diagram;
using render::figure::DiagramPoint;
using render::figure::Wire;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument(what); }

bool is_level(render::figure::BlockSide side) {
  return side == render::figure::BlockSide::left || side == render::figure::BlockSide::right;
}

render::figure::DiagramPoint port_point(const NodePlace& place, const Port& port) {
  const render::figure::DiagramPoint& c = place.centre;
  switch (port.side) {
    case render::figure::BlockSide::left:
      return {c.x - place.width / 2, c.y + port.offset};
    case render::figure::BlockSide::right:
      return {c.x + place.width / 2, c.y + port.offset};
    case render::figure::BlockSide::top:
      return {c.x + port.offset, c.y - place.height / 2};
    case render::figure::BlockSide::bottom:
      break;
  }
  return {c.x + port.offset, c.y + place.height / 2};
}

std::string name_of(const WireRoute& route) { return route.from + " -> " + route.to; }

std::vector<render::figure::DiagramPoint> lead(const WireRoute& route,
                                               render::figure::DiagramPoint start,
                                               render::figure::DiagramPoint end) {
  constexpr double aligned_mm = 1e-9;
  std::vector<render::figure::DiagramPoint> points{start};
  bool level = is_level(route.leave.side);
  for (const double bend : route.bends) {
    points.push_back(level ? render::figure::DiagramPoint{bend, points.back().y}
                           : render::figure::DiagramPoint{points.back().x, bend});
    level = !level;
  }
  const render::figure::DiagramPoint pen = points.back();
  if (level != is_level(route.enter.side)) {
    points.push_back(level ? render::figure::DiagramPoint{end.x, pen.y}
                           : render::figure::DiagramPoint{pen.x, end.y});
  } else if (std::abs(level ? pen.y - end.y : pen.x - end.x) > aligned_mm) {
    refuse("the wire " + name_of(route) + " needs a bend to enter straight");
  }
  points.push_back(end);
  return points;
}

class Draughtsman {
 public:
  Draughtsman(const SignalGraph& graph, const std::map<std::string, NodePlace>& places)
      : graph_(graph), places_(places) {}

  render::figure::Diagram draw(const std::vector<WireRoute>& routes) {
    std::set<std::string> names;
    for (const SignalNode& node : graph_.nodes) {
      names.insert(node.name);
      add_block(node);
    }
    for (const auto& [name, place] : places_) {
      if (names.count(name) == 0) refuse("there is a place for '" + name + "' and no such signal");
    }
    std::vector<bool> drawn(routes.size(), false);
    for (const SignalEdge& edge : graph_.edges) {
      const auto route = std::find_if(routes.begin(), routes.end(), [&](const WireRoute& one) {
        return one.from == edge.from && one.to == edge.to;
      });
      if (route == routes.end()) refuse("no route leads from " + edge.from + " to " + edge.to);
      drawn[static_cast<std::size_t>(route - routes.begin())] = true;
      add_wire(edge, *route);
    }
    for (std::size_t i = 0; i < routes.size(); ++i) {
      if (!drawn[i]) refuse("the route " + name_of(routes[i]) + " is for no edge");
    }
    return std::move(out_);
  }

 private:
  void add_block(const SignalNode& node) {
    const auto place = places_.find(node.name);
    if (place == places_.end()) refuse("the signal '" + node.name + "' has no place");
    render::figure::Block block = block_of(node);
    block.centre = place->second.centre;
    block.width = place->second.width;
    block.height = place->second.height;
    block.faces = place->second.faces;
    if (!place->second.lines.empty()) block.lines = place->second.lines;
    block_index_[node.name] = out_.blocks.size();
    out_.blocks.push_back(std::move(block));
  }

  void add_wire(const SignalEdge& edge, const WireRoute& route) {
    const render::figure::DiagramPoint start =
        route.branch.value_or(port_point(places_.at(route.from), route.leave));
    render::figure::Wire wire;
    wire.points = lead(route, start, port_point(places_.at(route.to), route.enter));
    if (route.branch) wire.branch_dots.push_back(*route.branch);
    if (!route.label.empty()) {
      wire.label = render::figure::DiagramText{route.label, route.label_at, route.label_place};
    }
    out_.wires.push_back(std::move(wire));
    const std::string sign = sign_text(edge.sign);
    render::figure::Block& block = out_.blocks[block_index_.at(edge.to)];
    if (shows_signs(block_operation(edge.to))) {
      block.signs.push_back({route.enter.side, route.enter.offset, sign});
    }
  }

  [[nodiscard]] Operation block_operation(const std::string& name) const {
    return std::find_if(graph_.nodes.begin(), graph_.nodes.end(),
                        [&](const SignalNode& node) { return node.name == name; })
        ->operation;
  }

  const SignalGraph& graph_;
  const std::map<std::string, NodePlace>& places_;
  std::map<std::string, std::size_t> block_index_;
  render::figure::Diagram out_;
};

}  // namespace

render::figure::Diagram draw_schematic(const SignalGraph& graph,
                                       const std::map<std::string, NodePlace>& places,
                                       const std::vector<WireRoute>& routes) {
  return Draughtsman(graph, places).draw(routes);
}

std::vector<std::string> in_lines(const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(words, line);) lines.push_back(line);
  return lines;
}

}  // namespace tribolog::paper::drawings
