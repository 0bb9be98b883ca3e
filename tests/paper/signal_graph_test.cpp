#include "paper/drawings/signal_graph.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"

namespace tribolog::paper::signal_graph_test {
namespace {

/// dx/dt = a - x², with an output.
drawings::SignalGraph falling_body() {
  drawings::SignalGraph graph;
  graph.nodes = {{"a", "a", drawings::Operation::input},
                 {"x", "", drawings::Operation::integrator},
                 {"square", "", drawings::Operation::function, 0, [](double x) { return x * x; }},
                 {"rate", "", drawings::Operation::sum},
                 {"out", "x", drawings::Operation::output}};
  graph.edges = {
      {"a", "rate"}, {"x", "square"}, {"square", "rate", '-'}, {"rate", "x"}, {"x", "out"}};
  return graph;
}

drawings::SignalGraph two_inputs(drawings::Operation operation, char first, char second) {
  drawings::SignalGraph graph;
  graph.nodes = {{"a", "a", drawings::Operation::input},
                 {"b", "b", drawings::Operation::input},
                 {"c", "c", operation}};
  graph.edges = {{"a", "c", first}, {"b", "c", second}};
  return graph;
}

std::string refusal(const drawings::SignalGraph& graph, const drawings::SignalValues& inputs,
                    const drawings::SignalValues& states = {}) {
  return test::refusal_of<std::invalid_argument>(
      [&] { return drawings::evaluate(graph, inputs, states); });
}

TEST(SignalGraph, ALoopThroughAnIntegratorHasAValue) {
  const drawings::SignalValues values = drawings::evaluate(falling_body(), {{"a", 10}}, {{"x", 3}});
  EXPECT_EQ(values.at("rate"), 1);
  EXPECT_EQ(values.at("x"), 3);
  EXPECT_EQ(values.at("out"), 3);
}

TEST(SignalGraph, OperationsDoWhatTheirSignsSay) {
  const drawings::SignalValues ab{{"a", 12}, {"b", 4}};
  EXPECT_EQ(drawings::evaluate(two_inputs(drawings::Operation::sum, '+', '-'), ab).at("c"), 8);
  EXPECT_EQ(drawings::evaluate(two_inputs(drawings::Operation::sum, '-', '-'), ab).at("c"), -16);
  EXPECT_EQ(drawings::evaluate(two_inputs(drawings::Operation::product, '*', '*'), ab).at("c"), 48);
  EXPECT_EQ(drawings::evaluate(two_inputs(drawings::Operation::product, '*', '/'), ab).at("c"), 3);
  drawings::SignalGraph choice = two_inputs(drawings::Operation::selector, '+', '+');
  EXPECT_EQ(drawings::evaluate(choice, ab).at("c"), 12);
  choice.nodes[2].selected = 1;
  EXPECT_EQ(drawings::evaluate(choice, ab).at("c"), 4);
}

TEST(SignalGraph, RefusesValuesThatAreMissingOrForNothing) {
  EXPECT_EQ(refusal(falling_body(), {}, {{"x", 3}}), "signal 'a' has no value");
  EXPECT_EQ(refusal(falling_body(), {{"a", 1}}), "signal 'x' has no value");
  EXPECT_EQ(refusal(falling_body(), {{"a", 1}, {"rate", 1}}, {{"x", 3}}),
            "signal 'rate' is given a value that it cannot take");
  EXPECT_NE(refusal(falling_body(), {{"a", 1}, {"other", 1}}, {{"x", 3}}), "");
}

TEST(SignalGraph, RefusesGraphsThatMakeNoSense) {
  const drawings::SignalValues ab{{"a", 1}, {"b", 1}};
  drawings::SignalGraph graph = falling_body();
  graph.nodes[1].operation = drawings::Operation::output;
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
  EXPECT_EQ(refusal(two_inputs(drawings::Operation::sum, '+', '*'), ab),
            "signal 'c' has an input with the sign '*'");
  EXPECT_NE(refusal(two_inputs(drawings::Operation::product, '*', '-'), ab), "");
  graph = two_inputs(drawings::Operation::selector, '+', '+');
  graph.nodes[2].selected = 2;
  EXPECT_NE(refusal(graph, ab), "");
}

}  // namespace
}  // namespace tribolog::paper::signal_graph_test
