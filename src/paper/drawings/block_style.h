#pragma once
// What the block of a node looks like: its kind, text and colours.

#include <string>

#include "paper/drawings/signal_graph.h"
#include "render/figure/diagram.h"

namespace tribolog::paper {

/// Light grounds that tell the parts of a model apart, also in grey.
namespace ground {
inline constexpr render::Colour signal{255, 255, 255};
inline constexpr render::Colour element{226, 240, 250};  ///< Blue: gains and characteristics.
inline constexpr render::Colour state{253, 236, 205};    ///< Orange: what has a memory.
inline constexpr render::Colour outside{240, 240, 240};  ///< Grey: inputs and outputs.
}  // namespace ground

/// Without place, size and signs.
inline render::Block block_of(const SignalNode& node) {
  using render::BlockKind;
  render::Block block;
  block.fill = ground::element;
  if (!node.symbol.empty()) block.lines = {node.symbol};
  switch (node.operation) {
    case Operation::input:
    case Operation::output:
      block.kind = BlockKind::terminal;
      block.fill = ground::outside;
      break;
    case Operation::gain:
      block.kind = BlockKind::gain;
      break;
    case Operation::sum:
      block.kind = BlockKind::summing_junction;
      block.fill = ground::signal;
      break;
    case Operation::integrator:
      block.kind = BlockKind::integrator;
      block.fill = ground::state;
      break;
    case Operation::selector:
      block.kind = BlockKind::selector;
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

}  // namespace tribolog::paper
