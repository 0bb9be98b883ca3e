#include "paper/drawings/signal_graph.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tribolog::paper {
namespace {

/// dx/dt = a - x², with an output.
SignalGraph falling_body() {
  SignalGraph graph;
  graph.nodes = {{"a", "a", Operation::input},
                 {"x", "", Operation::integrator},
                 {"square", "", Operation::function, 0, [](double x) { return x * x; }},
                 {"rate", "", Operation::sum},
                 {"out", "x", Operation::output}};
  graph.edges = {
      {"a", "rate"}, {"x", "square"}, {"square", "rate", '-'}, {"rate", "x"}, {"x", "out"}};
  return graph;
}

SignalGraph two_inputs(Operation operation, char first, char second) {
  SignalGraph graph;
  graph.nodes = {{"a", "a", Operation::input}, {"b", "b", Operation::input}, {"c", "c", operation}};
  graph.edges = {{"a", "c", first}, {"b", "c", second}};
  return graph;
}

std::string refusal(const SignalGraph& graph, const SignalValues& inputs,
                    const SignalValues& states = {}) {
  try {
    evaluate(graph, inputs, states);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

TEST(SignalGraph, ALoopThroughAnIntegratorHasAValue) {
  const SignalValues values = evaluate(falling_body(), {{"a", 10}}, {{"x", 3}});
  EXPECT_EQ(values.at("rate"), 1);
  EXPECT_EQ(values.at("x"), 3);
  EXPECT_EQ(values.at("out"), 3);
}

TEST(SignalGraph, OperationsDoWhatTheirSignsSay) {
  const SignalValues ab{{"a", 12}, {"b", 4}};
  EXPECT_EQ(evaluate(two_inputs(Operation::sum, '+', '-'), ab).at("c"), 8);
  EXPECT_EQ(evaluate(two_inputs(Operation::sum, '-', '-'), ab).at("c"), -16);
  EXPECT_EQ(evaluate(two_inputs(Operation::product, '*', '*'), ab).at("c"), 48);
  EXPECT_EQ(evaluate(two_inputs(Operation::product, '*', '/'), ab).at("c"), 3);
  SignalGraph choice = two_inputs(Operation::selector, '+', '+');
  EXPECT_EQ(evaluate(choice, ab).at("c"), 12);
  choice.nodes[2].selected = 1;
  EXPECT_EQ(evaluate(choice, ab).at("c"), 4);
}

TEST(SignalGraph, RefusesValuesThatAreMissingOrForNothing) {
  EXPECT_EQ(refusal(falling_body(), {}, {{"x", 3}}), "signal 'a' has no value");
  EXPECT_EQ(refusal(falling_body(), {{"a", 1}}), "signal 'x' has no value");
  EXPECT_EQ(refusal(falling_body(), {{"a", 1}, {"rate", 1}}, {{"x", 3}}),
            "signal 'rate' is given a value that it cannot take");
  EXPECT_NE(refusal(falling_body(), {{"a", 1}, {"other", 1}}, {{"x", 3}}), "");
}

TEST(SignalGraph, RefusesGraphsThatMakeNoSense) {
  const SignalValues ab{{"a", 1}, {"b", 1}};
  SignalGraph graph = falling_body();
  graph.nodes[1].operation = Operation::output;
  EXPECT_NE(refusal(graph, {{"a", 1}}).find("depends on itself"), std::string::npos);
  graph = falling_body();
  graph.nodes.push_back(graph.nodes.front());
  EXPECT_EQ(refusal(graph, {}), "signal 'a' is there twice");
  graph = falling_body();
  graph.edges.push_back({"y", "rate"});
  EXPECT_EQ(refusal(graph, {}), "signal 'y' is named by an edge and does not exist");
  graph = falling_body();
  graph.edges.pop_back();
  EXPECT_EQ(refusal(graph, {{"a", 1}}, {{"x", 1}}), "signal 'out' has the wrong number of inputs");
  graph = falling_body();
  graph.nodes[2].function = nullptr;
  EXPECT_EQ(refusal(graph, {{"a", 1}}, {{"x", 1}}), "signal 'square' has no function");
  EXPECT_EQ(refusal(two_inputs(Operation::sum, '+', '*'), ab),
            "signal 'c' has an input with the sign '*'");
  EXPECT_NE(refusal(two_inputs(Operation::product, '*', '-'), ab), "");
  graph = two_inputs(Operation::selector, '+', '+');
  graph.nodes[2].selected = 2;
  EXPECT_NE(refusal(graph, ab), "");
}

}  // namespace
}  // namespace tribolog::paper
