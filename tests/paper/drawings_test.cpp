#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "paper/drawings/paper_drawings.h"
#include "paper/figure_checks.h"
#include "render/composition/figure_layout.h"

namespace tribolog::paper::drawings_test {
namespace {

render::figure::DrawList laid_out(const render::figure::Figure& figure) {
  static const render::text::Font font;
  return render::composition::lay_out(figure, font);
}

TEST(PaperDrawings, AreThePapersFigures) {
  std::vector<int> numbers;
  for (const figures::ReportFigure& one : drawings::paper_drawings())
    numbers.push_back(one.paper_number.value_or(0));
  EXPECT_EQ(numbers, (std::vector<int>{3, 4, 6, 7, 8}));
}

TEST(PaperDrawings, AreCompleteInWords) {
  test::expect_complete_in_words(drawings::paper_drawings());
}

TEST(PaperDrawings, ComeOutWholeAndWithoutAWarning) {
  test::expect_drawn_whole(drawings::paper_drawings());
}

TEST(PaperDrawings, FillTheWidthOfTheirPicture) {
  constexpr double least_share = 0.85;  // of the width, between the outermost lines
  for (const figures::ReportFigure& one : drawings::paper_drawings()) {
    const render::figure::DrawList list = laid_out(one.figure);
    double left = 1e9;
    double right = 0;
    for (const render::figure::Primitive& primitive : list.primitives) {
      const auto* line = std::get_if<render::figure::Polyline>(&primitive);
      if (line == nullptr) continue;
      for (const render::figure::PixelPoint& p : line->points) {
        EXPECT_TRUE(p.x > 0 && p.x < list.width && p.y > 0 && p.y < list.height) << one.id;
        left = std::min(left, p.x);
        right = std::max(right, p.x);
      }
    }
    EXPECT_GE((right - left) / list.width, least_share) << one.id;
  }
}

TEST(PaperDrawings, ShowEveryGearRatioThatFits) {
  for (const double ratio : {1.0, 50.0, 100.0, 160.25}) {
    for (const figures::ReportFigure& one : drawings::paper_drawings(ratio)) {
      EXPECT_TRUE(laid_out(one.figure).warnings.empty()) << one.id << " at " << ratio;
    }
  }
}

bool lies_on_border(const render::figure::Block& block, render::figure::DiagramPoint p) {
  constexpr double rounding_mm = 1e-9;
  const double dx = std::abs(p.x - block.centre.x) - block.width / 2;
  const double dy = std::abs(p.y - block.centre.y) - block.height / 2;
  return std::max(dx, dy) <= rounding_mm && std::max(dx, dy) >= -rounding_mm;
}

/// Blocks and wires of the graph come first, in its order; what is beside them is no signal.
void expect_graph_is_drawn(const figures::ReportFigure& figure, const drawings::SignalGraph& graph,
                           std::size_t wires_beside) {
  SCOPED_TRACE(figure.id);
  const render::figure::Diagram& drawing = *figure.figure.diagram;
  std::vector<render::figure::Block> blocks;
  for (const render::figure::Block& one : drawing.blocks) {
    if (one.kind != render::figure::BlockKind::frame) blocks.push_back(one);
  }
  EXPECT_EQ(blocks.size(), graph.nodes.size() + wires_beside);
  ASSERT_EQ(drawing.wires.size(), graph.edges.size() + wires_beside);
  std::map<std::string, render::figure::Block> block_of_node;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    block_of_node[graph.nodes[i].name] = blocks[i];
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const drawings::SignalEdge& edge = graph.edges[i];
    const render::figure::Wire& wire = drawing.wires[i];
    EXPECT_TRUE(wire.arrow);
    EXPECT_TRUE(lies_on_border(block_of_node[edge.to], wire.points.back())) << edge.to;
    const bool branches = wire.branch_dots == std::vector{wire.points.front()};
    EXPECT_TRUE(branches || lies_on_border(block_of_node[edge.from], wire.points.front()))
        << edge.from;
    for (std::size_t k = 1; k < wire.points.size(); ++k) {
      EXPECT_TRUE(wire.points[k].x == wire.points[k - 1].x ||
                  wire.points[k].y == wire.points[k - 1].y);
    }
  }
}

/// A branch must lie on a wire that carries the same signal.
void expect_branches_carry_their_signal(const figures::ReportFigure& figure,
                                        const drawings::SignalGraph& graph) {
  const auto& wires = figure.figure.diagram->wires;
  const auto passes = [](const render::figure::Wire& wire, render::figure::DiagramPoint p) {
    for (std::size_t k = 1; k < wire.points.size(); ++k) {
      const auto [low_x, high_x] = std::minmax(wire.points[k - 1].x, wire.points[k].x);
      const auto [low_y, high_y] = std::minmax(wire.points[k - 1].y, wire.points[k].y);
      if (p.x >= low_x && p.x <= high_x && p.y >= low_y && p.y <= high_y) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    for (const render::figure::DiagramPoint& dot : wires[i].branch_dots) {
      for (std::size_t k = 0; k < graph.edges.size(); ++k) {
        if (!passes(wires[k], dot)) continue;
        EXPECT_EQ(graph.edges[k].from, graph.edges[i].from) << figure.id;
      }
    }
  }
}

TEST(PaperDrawings, ShowTheirGraphsEdgeByEdge) {
  const auto zero = [](double) { return 0.0; };
  drawings::JointElements joint;
  joint.drive = {1.0, 0.0, zero};
  joint.dynamic_friction_Nm = zero;
  struct Pair {
    figures::ReportFigure figure;
    drawings::SignalGraph graph;
    std::size_t wires_beside;
  };
  const Pair pairs[] = {
      {drawings::lugre_diagram_figure(),
       drawings::lugre_graph(friction::LuGreFriction({1, 1, 1, 1, 1, 1})), 0},
      {drawings::drive_diagram_figure(100), drawings::drive_graph(joint.drive), 0},
      {drawings::joint_diagram_figure(), drawings::joint_graph(joint), 1},  // the reference signal
      {drawings::gear_diagram_figure(100), drawings::gear_graph(100, 0), 0}};
  for (const auto& [figure, graph, wires_beside] : pairs) {
    expect_graph_is_drawn(figure, graph, wires_beside);
    expect_branches_carry_their_signal(figure, graph);
  }
}

}  // namespace
}  // namespace tribolog::paper::drawings_test
