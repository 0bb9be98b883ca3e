#pragma once
// A signal graph on paper: every node becomes a block and every edge a wire, and nothing else does.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "paper/drawings/signal_graph.h"
#include "render/figure/diagram.h"

namespace tribolog::paper::drawings {

/// Where a node is drawn, in millimetres of the canvas. Its kind, text and signs follow from the
/// graph.
struct NodePlace {
  render::figure::DiagramPoint centre;
  double width{};
  double height{};
  render::figure::BlockSide faces{render::figure::BlockSide::right};  ///< Where its output is.
  std::vector<std::string> lines{};  ///< Instead of the node's symbol: longer words.
};

/// Where a wire leaves or enters: the middle of a side, or beside it.
struct Port {
  render::figure::BlockSide side{};
  double offset{};  ///< Rightwards or downwards.
};

/// How the edge from one node to another runs: along the axes. It leaves its port and turns at
/// each coordinate of `bends` (x and y in turn; the first is the one along which it leaves), and
/// once more, if needed, to enter straight.
struct WireRoute {
  std::string from;
  std::string to;
  Port leave{render::figure::BlockSide::right, 0};
  Port enter{render::figure::BlockSide::left, 0};
  std::vector<double> bends{};
  std::optional<render::figure::DiagramPoint>
      branch{};  ///< It starts here, on another wire of `from`.
  std::string label{};
  render::figure::DiagramPoint label_at{};
  render::figure::TextPlace label_place{render::figure::TextPlace::above};
};

/// @throw std::invalid_argument if a node has no place, an edge no route, a place or route nothing
/// that it is for, or a wire cannot be led by its
/// bends; the text names it.
render::figure::Diagram draw_schematic(const SignalGraph& graph,
                                       const std::map<std::string, NodePlace>& places,
                                       const std::vector<WireRoute>& routes);

/// What a line feed divides: a block's lines, of one message.
std::vector<std::string> in_lines(const std::string& text);

// What the block of a node looks like: its kind, text and colours.

/// Light grounds that tell the parts of a model apart, also in grey.
namespace ground {
inline constexpr render::figure::Colour signal{255, 255, 255};
inline constexpr render::figure::Colour element{226, 240,
                                                250};          ///< Blue: gains and characteristics.
inline constexpr render::figure::Colour state{253, 236, 205};  ///< Orange: what has a memory.
inline constexpr render::figure::Colour outside{240, 240, 240};  ///< Grey: inputs and outputs.
}  // namespace ground

/// Without place, size and signs.
inline render::figure::Block block_of(const SignalNode& node) {
  using render::figure::BlockKind;
  render::figure::Block block;
  block.fill = ground::element;
  if (!node.symbol.empty()) block.lines = {node.symbol};
  switch (node.operation) {
    case Operation::input:
    case Operation::output:
      block.kind = render::figure::BlockKind::terminal;
      block.fill = ground::outside;
      break;
    case Operation::gain:
      block.kind = render::figure::BlockKind::gain;
      break;
    case Operation::sum:
      block.kind = render::figure::BlockKind::summing_junction;
      block.fill = ground::signal;
      break;
    case Operation::integrator:
      block.kind = render::figure::BlockKind::integrator;
      block.fill = ground::state;
      break;
    case Operation::selector:
      block.kind = render::figure::BlockKind::selector;
      block.fill = ground::signal;
      break;
    case Operation::product:
      block.fill = ground::signal;
      break;
    case Operation::function:
      break;
  }
  return block;
}

inline bool shows_signs(Operation operation) {
  return operation == Operation::sum || operation == Operation::product;
}

inline std::string sign_text(char sign) {
  switch (sign) {
    case '-':
      return "−";
    case '*':
      return "×";
    case '/':
      return "÷";
    default:
      return std::string(1, sign);
  }
}

}  // namespace tribolog::paper::drawings
