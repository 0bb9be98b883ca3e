#include "paper/drawings/schematic.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"

namespace tribolog::paper::schematic_test {
namespace {

using render::figure::BlockKind;
using render::figure::BlockSide;
using render::figure::DiagramPoint;

drawings::SignalGraph sum_graph() {
  drawings::SignalGraph graph;
  graph.nodes = {{"a", "a", drawings::Operation::input},
                 {"twice", "2", drawings::Operation::gain, 2},
                 {"sum", "", drawings::Operation::sum},
                 {"out", "b", drawings::Operation::output}};
  graph.edges = {{"a", "twice"}, {"twice", "sum", '+'}, {"a", "sum", '-'}, {"sum", "out"}};
  return graph;
}

std::map<std::string, drawings::NodePlace> sum_places() {
  return {{"a", {{10, 20}, 10, 10}},
          {"twice", {{40, 20}, 15, 14}},
          {"sum", {{70, 20}, 10, 10}},
          {"out", {{100, 20}, 10, 10}}};
}

std::vector<drawings::WireRoute> sum_routes() {
  const drawings::Port left{render::figure::BlockSide::left, 0};
  const drawings::Port right{render::figure::BlockSide::right, 0};
  return {{"a", "twice", right, left},
          {"twice", "sum", right, left},
          {"a",
           "sum",
           {render::figure::BlockSide::bottom, 0},
           {render::figure::BlockSide::bottom, 0},
           {40},
           {{22, 20}}},
          {"sum", "out", right, left}};
}

std::string refusal(const drawings::SignalGraph& graph,
                    const std::map<std::string, drawings::NodePlace>& places,
                    const std::vector<drawings::WireRoute>& routes) {
  return test::refusal_of<std::invalid_argument>(
      [&] { return drawings::draw_schematic(graph, places, routes); });
}

TEST(Schematic, EveryNodeIsABlockAndEveryEdgeAWire) {
  const render::figure::Diagram drawn =
      drawings::draw_schematic(sum_graph(), sum_places(), sum_routes());
  ASSERT_EQ(drawn.blocks.size(), 4U);
  EXPECT_EQ(drawn.blocks[0].kind, render::figure::BlockKind::terminal);
  EXPECT_EQ(drawn.blocks[1].kind, render::figure::BlockKind::gain);
  EXPECT_EQ(drawn.blocks[1].lines, std::vector<std::string>{"2"});
  EXPECT_EQ(drawn.blocks[2].kind, render::figure::BlockKind::summing_junction);
  EXPECT_EQ(drawn.wires.size(), 4U);
}

TEST(Schematic, SignsStandWhereTheWireEnters) {
  const render::figure::Diagram drawn =
      drawings::draw_schematic(sum_graph(), sum_places(), sum_routes());
  const auto& signs = drawn.blocks[2].signs;
  ASSERT_EQ(signs.size(), 2U);
  EXPECT_EQ(signs[0].text, "+");
  EXPECT_EQ(signs[0].side, render::figure::BlockSide::left);
  EXPECT_EQ(signs[1].text, "−");
  EXPECT_EQ(signs[1].side, render::figure::BlockSide::bottom);
}

TEST(Schematic, WiresRunAlongTheAxesFromPortToPort) {
  const render::figure::Diagram drawn =
      drawings::draw_schematic(sum_graph(), sum_places(), sum_routes());
  EXPECT_EQ(drawn.wires[0].points,
            (std::vector<render::figure::DiagramPoint>{{15, 20}, {32.5, 20}}));
  EXPECT_EQ(drawn.wires[2].points,
            (std::vector<render::figure::DiagramPoint>{{22, 20}, {22, 40}, {70, 40}, {70, 25}}));
  EXPECT_EQ(drawn.wires[2].branch_dots, (std::vector<render::figure::DiagramPoint>{{22, 20}}));
}

TEST(Schematic, RefusesADrawingThatIsNotTheGraph) {
  auto places = sum_places();
  places.erase("out");
  EXPECT_EQ(refusal(sum_graph(), places, sum_routes()), "the signal 'out' has no place");
  places = sum_places();
  places["other"] = {};
  EXPECT_EQ(refusal(sum_graph(), places, sum_routes()),
            "there is a place for 'other' and no such signal");
  auto routes = sum_routes();
  routes.pop_back();
  EXPECT_EQ(refusal(sum_graph(), sum_places(), routes), "no route leads from sum to out");
  routes = sum_routes();
  routes.push_back({"a", "out"});
  EXPECT_EQ(refusal(sum_graph(), sum_places(), routes), "the route a -> out is for no edge");
  places = sum_places();
  places["twice"].centre.y = 21;
  EXPECT_EQ(refusal(sum_graph(), places, sum_routes()),
            "the wire a -> twice needs a bend to enter straight");
}

}  // namespace
}  // namespace tribolog::paper::schematic_test
