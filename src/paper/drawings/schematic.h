#pragma once
// A signal graph on paper: every node becomes a block and every edge a wire, and nothing else does.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "paper/drawings/signal_graph.h"
#include "render/figure/diagram.h"

namespace tribolog::paper {

/// Where a node is drawn, in millimetres of the canvas. Its kind, text and signs follow from the
/// graph.
struct NodePlace {
  render::DiagramPoint centre;
  double width{};
  double height{};
  render::BlockSide faces{render::BlockSide::right};  ///< Where its output is.
  std::vector<std::string> lines{};  ///< Instead of the node's symbol: longer words.
};

/// Where a wire leaves or enters: the middle of a side, or beside it.
struct Port {
  render::BlockSide side{};
  double offset{};  ///< Rightwards or downwards.
};

/// How the edge from one node to another runs: along the axes. It leaves its port and turns at
/// each coordinate of `bends` (x and y in turn; the first is the one along which it leaves), and
/// once more, if needed, to enter straight.
struct WireRoute {
  std::string from;
  std::string to;
  Port leave{render::BlockSide::right, 0};
  Port enter{render::BlockSide::left, 0};
  std::vector<double> bends{};
  std::optional<render::DiagramPoint> branch{};  ///< It starts here, on another wire of `from`.
  std::string label{};
  render::DiagramPoint label_at{};
  render::TextPlace label_place{render::TextPlace::above};
};

/// @throw std::invalid_argument if a node has no place, an edge no route, a place or route nothing
/// that it is for, or a wire cannot be led by its
/// bends; the text names it.
render::Diagram draw_schematic(const SignalGraph& graph,
                               const std::map<std::string, NodePlace>& places,
                               const std::vector<WireRoute>& routes);

}  // namespace tribolog::paper
