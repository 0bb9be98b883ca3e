#pragma once
// A model as the graph that its block diagram shows: what is drawn can be computed.

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace tribolog::paper::drawings {

enum class Operation {
  input,       ///< Given from outside.
  gain,        ///< gain * the one input.
  function,    ///< function(the one input), a static characteristic.
  sum,         ///< Inputs with their signs.
  product,     ///< Product of the inputs; those with sign '/' divide.
  integrator,  ///< Its value is the state; what flows in is the state's rate.
  selector,    ///< One of its inputs, the first or a later one.
  output,      ///< Passes its one input to the outside.
};

struct SignalNode {
  std::string name;    ///< Unique in the graph: "rate".
  std::string symbol;  ///< As the block shows it, in the markup of figures: "σ_{0}".
  Operation operation{};
  double gain{};                             ///< Of Operation::gain.
  std::function<double(double)> function{};  ///< Of Operation::function.
  std::size_t selected{};                    ///< Of Operation::selector, counted from 0.
};

struct SignalEdge {
  std::string from;
  std::string to;
  char sign{'+'};  ///< '+' or '-' into a sum, '*' or '/' into a product; '+' elsewhere.
};

struct SignalGraph {
  std::vector<SignalNode> nodes;
  std::vector<SignalEdge> edges;  ///< The order of those into one node is that of its inputs.
};

/// Values by the name of the node. That of an integrator is its state; its rate is the value of
/// the node that feeds it.
using SignalValues = std::map<std::string, double>;

/// Computes every node.
/// @param inputs a value for each Operation::input @param states one for each integrator
/// @throw std::invalid_argument if a value is missing or is for no such node, a name is used twice,
/// an edge names no node, a node has too few or too many inputs or a sign that it does not know, or
/// a loop has no integrator in it; the text names the node.
SignalValues evaluate(const SignalGraph& graph, const SignalValues& inputs,
                      const SignalValues& states = {});

}  // namespace tribolog::paper::drawings
