#include "paper/drawings/signal_graph.h"

#include <set>
#include <stdexcept>

namespace tribolog::paper::drawings {
namespace {

struct Inflow {
  std::string from;
  char sign{};
};

class Evaluation {
 public:
  Evaluation(const SignalGraph& graph, const SignalValues& inputs, const SignalValues& states)
      : inputs_(inputs), states_(states) {
    for (const SignalNode& node : graph.nodes) {
      if (!nodes_.emplace(node.name, &node).second) refuse(node.name, "is there twice");
    }
    for (const SignalEdge& edge : graph.edges) {
      for (const std::string& end : {edge.from, edge.to}) {
        if (nodes_.count(end) == 0) refuse(end, "is named by an edge and does not exist");
      }
      inflows_[edge.to].push_back({edge.from, edge.sign});
    }
    check_given(inputs, Operation::input);
    check_given(states, Operation::integrator);
    for (const SignalNode& node : graph.nodes) check_shape(node);
  }

  SignalValues run() {
    for (const auto& [name, node] : nodes_) value(name);
    return values_;
  }

 private:
  [[noreturn]] static void refuse(const std::string& name, const std::string& why) {
    throw std::invalid_argument("signal '" + name + "' " + why);
  }

  void check_given(const SignalValues& given, Operation kind) const {
    for (const auto& [name, number] : given) {
      const auto node = nodes_.find(name);
      if (node == nodes_.end() || node->second->operation != kind) {
        refuse(name, "is given a value that it cannot take");
      }
    }
  }

  void check_shape(const SignalNode& node) {
    const auto& inflows = inflows_[node.name];
    const bool merges = node.operation == Operation::sum || node.operation == Operation::product ||
                        node.operation == Operation::selector;
    const bool right_count = node.operation == Operation::input ? inflows.empty()
                             : merges                           ? inflows.size() >= 2
                                                                : inflows.size() == 1;
    if (!right_count) refuse(node.name, "has the wrong number of inputs");
    for (const Inflow& one : inflows) {
      const bool known = node.operation == Operation::sum       ? one.sign == '+' || one.sign == '-'
                         : node.operation == Operation::product ? one.sign == '*' || one.sign == '/'
                                                                : one.sign == '+';
      if (!known) refuse(node.name, std::string("has an input with the sign '") + one.sign + "'");
    }
    if (node.operation == Operation::function && !node.function) {
      refuse(node.name, "has no function");
    }
    if (node.operation == Operation::selector && node.selected >= inflows.size()) {
      refuse(node.name, "selects an input that it does not have");
    }
  }

  static double given(const SignalValues& values, const std::string& name) {
    const auto found = values.find(name);
    if (found == values.end()) refuse(name, "has no value");
    return found->second;
  }

  double value(const std::string& name) {
    const auto known = values_.find(name);
    if (known != values_.end()) return known->second;
    if (!under_way_.insert(name).second) refuse(name, "depends on itself without an integrator");
    const double result = compute(*nodes_.at(name));
    under_way_.erase(name);
    values_[name] = result;
    return result;
  }

  double compute(const SignalNode& node) {
    const auto& inflows = inflows_[node.name];
    switch (node.operation) {
      case Operation::input:
        return given(inputs_, node.name);
      case Operation::integrator:
        return given(states_, node.name);
      case Operation::gain:
        return node.gain * value(inflows.front().from);
      case Operation::function:
        return node.function(value(inflows.front().from));
      case Operation::selector:
        return value(inflows[node.selected].from);
      case Operation::output:
        return value(inflows.front().from);
      case Operation::sum: {
        double sum = 0;
        for (const Inflow& one : inflows) sum += (one.sign == '-' ? -1.0 : 1.0) * value(one.from);
        return sum;
      }
      case Operation::product: {
        double product = 1;
        for (const Inflow& one : inflows) {
          product = one.sign == '/' ? product / value(one.from) : product * value(one.from);
        }
        return product;
      }
    }
    return 0;
  }

  const SignalValues& inputs_;
  const SignalValues& states_;
  std::map<std::string, const SignalNode*> nodes_;
  std::map<std::string, std::vector<Inflow>> inflows_;
  std::set<std::string> under_way_;
  SignalValues values_;
};

}  // namespace

SignalValues evaluate(const SignalGraph& graph, const SignalValues& inputs,
                      const SignalValues& states) {
  return Evaluation(graph, inputs, states).run();
}

}  // namespace tribolog::paper::drawings
