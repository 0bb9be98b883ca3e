#include <cmath>

#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/schematic.h"
#include "wording/tr.h"

namespace tribolog::paper::drawings {
namespace {

using render::figure::BlockSide;
using render::figure::TextPlace;
using wording::tr;

constexpr double torque_row = 9;
constexpr double main_row = 28;
constexpr double product_row = 47;
constexpr double quotient_row = 63;
constexpr double viscous_row = 80;
constexpr double speed_column = 22;
constexpr double rate_column = 47;
constexpr double state_column = 80;
constexpr double gain_column = 114;
constexpr double torque_column = 137;

std::map<std::string, NodePlace> places() {
  return {{"speed", {{9, main_row}, 12, 10}},
          {"rate", {{rate_column, main_row}, 10, 10}},
          {"deflection", {{state_column, main_row}, 14, 13}},
          {"size of speed", {{36, quotient_row - 6.5}, 13, 10}},
          {"steady deflection", {{36, quotient_row + 6.5}, 13, 10}},
          {"decay", {{60, quotient_row}, 11, 23}},
          {"pull back", {{state_column, product_row}, 13, 12, render::figure::BlockSide::left}},
          {"stiffness", {{gain_column, main_row}, 15, 14}},
          {"damping", {{gain_column, torque_row}, 15, 14}},
          {"viscosity", {{gain_column, viscous_row}, 15, 14}},
          {"torque", {{torque_column, main_row}, 10, 10}},
          {"friction", {{152.5, main_row}, 11, 10}}};
}

std::vector<WireRoute> routes() {
  const Port left{render::figure::BlockSide::left, 0};
  const Port right{render::figure::BlockSide::right, 0};
  const Port top{render::figure::BlockSide::top, 0};
  const Port bottom{render::figure::BlockSide::bottom, 0};
  const double rate_branch = 60;
  const double state_branch = 95;
  return {
      {"speed", "rate", right, left},
      {"speed", "size of speed", bottom, left, {}, {{speed_column, main_row}}},
      {"speed", "steady deflection", bottom, left, {}, {{speed_column, quotient_row - 6.5}}},
      {"speed", "viscosity", bottom, left, {}, {{speed_column, quotient_row + 6.5}}},
      {"size of speed", "decay", right, {render::figure::BlockSide::left, -6.5}},
      {"steady deflection", "decay", right, {render::figure::BlockSide::left, 6.5}},
      {"decay", "pull back", right, bottom},
      {"deflection", "pull back", bottom, right, {}, {{state_branch, main_row}}},
      {"pull back", "rate", left, bottom, {}, {}, "(|ω| / g(ω)) z", {58.5, product_row}},
      {"rate", "deflection", right, left, {}, {}, "dz/dt", {66.5, main_row}},
      {"rate", "damping", top, left, {}, {{rate_branch, main_row}}},
      {"deflection", "stiffness", right, left, {}, {}, "z", {state_branch + 4, main_row}},
      {"damping", "torque", right, top, {}, {}, "σ_{1} dz/dt", {129, torque_row}},
      {"stiffness", "torque", right, left, {}, {}, "σ_{0} z", {126.5, main_row}},
      {"viscosity", "torque", right, bottom, {}, {}, "σ_{2} ω", {129, viscous_row}},
      {"torque", "friction", right, left},
  };
}

}  // namespace

SignalGraph lugre_graph(const friction::LuGreFriction& friction) {
  const friction::LuGreFriction::Parameters& p = friction.parameters();
  const auto size = [](double value) { return std::abs(value); };
  const auto steady = [friction](double speed) { return friction.steady_deflection_rad(speed); };
  SignalGraph graph;
  graph.nodes = {{"speed", "ω", Operation::input},
                 {"size of speed", "|ω|", Operation::function, 0, size},
                 {"steady deflection", "g(ω)", Operation::function, 0, steady},
                 {"decay", "", Operation::product},
                 {"pull back", "", Operation::product},
                 {"rate", "", Operation::sum},
                 {"deflection", "", Operation::integrator},
                 {"stiffness", "σ_{0}", Operation::gain, p.bristle_stiffness_Nm_rad},
                 {"damping", "σ_{1}", Operation::gain, p.bristle_damping_Nms_rad},
                 {"viscosity", "σ_{2}", Operation::gain, p.viscous_Nms_rad},
                 {"torque", "", Operation::sum},
                 {"friction", "T_{f}", Operation::output}};
  graph.edges = {{"speed", "size of speed"},
                 {"speed", "steady deflection"},
                 {"size of speed", "decay", '*'},
                 {"steady deflection", "decay", '/'},
                 {"decay", "pull back", '*'},
                 {"deflection", "pull back", '*'},
                 {"speed", "rate", '+'},
                 {"pull back", "rate", '-'},
                 {"rate", "deflection"},
                 {"deflection", "stiffness"},
                 {"rate", "damping"},
                 {"speed", "viscosity"},
                 {"damping", "torque", '+'},
                 {"stiffness", "torque", '+'},
                 {"viscosity", "torque", '+'},
                 {"torque", "friction"}};
  return graph;
}

figures::ReportFigure lugre_diagram_figure() {
  // The values do not show in the drawing.
  const friction::LuGreFriction any({1.0, 1.0, 1.0, 1.0, 1.0, 1.0});
  figures::ReportFigure out;
  out.paper_number = 4;
  out.id = "fig-04-lugre-diagram";
  out.title = tr("LuGre friction model as a block diagram");
  out.caption =
      tr("Equations (3) to (5): the speed ω stretches the bristles, sliding pulls them back at the "
         "rate |ω|/g(ω), and friction is the sum of stiffness σ₀, damping σ₁ and viscosity σ₂. The "
         "diagram is drawn from the graph that the program's tests evaluate.");
  out.how_to_read =
      tr("Signals run along the arrows; a dot is a branch; lines that cross without a dot do not "
         "connect. The integrator holds the only state, the mean bristle deflection z. At constant "
         "speed dz/dt is zero and z is g(ω) with the sign of the speed.");
  out.alt =
      tr("Block diagram. The speed ω, minus the product of z and |ω|/g(ω), gives dz/dt, which is "
         "integrated to z. σ₀ z, σ₁ dz/dt and σ₂ ω are added to the friction torque.");
  out.figure.diagram = draw_schematic(lugre_graph(any), places(), routes());
  out.figure.diagram->height = 89;
  out.figure.height_px = 970;
  out.figure.id = out.id;
  out.figure.title = out.title;
  return out;
}

}  // namespace tribolog::paper::drawings
