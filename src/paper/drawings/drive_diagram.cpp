#include <string>

#include <fmt/format.h>

#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/schematic.h"
#include "wording/tr.h"

namespace tribolog::paper::drawings {
namespace {

using render::figure::BlockKind;
using render::figure::BlockSide;
using wording::tr;

constexpr double inertia_row = 20;
constexpr double torque_row = 40;
constexpr double friction_row = 60;
constexpr double source_column = 25;
constexpr double element_column = 60;
constexpr double sum_column = 88;

std::map<std::string, NodePlace> places() {
  return {{"motor acceleration", {{source_column, inertia_row}, 12, 10}},
          {"motor torque", {{source_column, torque_row}, 12, 10}},
          {"motor speed", {{source_column, friction_row}, 12, 10}},
          {"inertia", {{element_column, inertia_row}, 15, 14}},
          {"friction",
           {{element_column, friction_row},
            24,
            14,
            render::figure::BlockSide::right,
            {tr("friction"), "T_{f}(φ\u0307)"}}},
          {"balance", {{sum_column, torque_row}, 10, 10}},
          {"gear", {{114, torque_row}, 15, 15}},
          {"arm torque", {{147, torque_row}, 18, 10}}};
}

std::vector<WireRoute> routes() {
  const Port left{render::figure::BlockSide::left, 0};
  const Port right{render::figure::BlockSide::right, 0};
  const Port top{render::figure::BlockSide::top, 0};
  const Port bottom{render::figure::BlockSide::bottom, 0};
  return {
      {"motor acceleration", "inertia", right, left},
      {"motor torque", "balance", right, left},
      {"motor speed", "friction", right, left},
      {"inertia", "balance", right, top, {}, {}, "J φ\u0308", {78.5, inertia_row}},
      {"friction", "balance", right, bottom, {}, {}, "T_{f}", {80, friction_row}},
      {"balance", "gear", right, left},
      {"gear", "arm torque", right, left},
  };
}

render::figure::Block source_frame() {
  render::figure::Block frame;
  frame.kind = render::figure::BlockKind::frame;
  frame.lines = in_lines(tr("ideal source\nof motion"));
  frame.centre = {18.5, 37};
  frame.width = 29;
  frame.height = 66;
  frame.colour = render::figure::palette::grey;
  frame.fill.alpha = 0;
  return frame;
}

}  // namespace

SignalGraph drive_graph(const DriveElements& drive) {
  SignalGraph graph;
  graph.nodes = {{"motor torque", "T", Operation::input},
                 {"motor speed", "φ\u0307", Operation::input},
                 {"motor acceleration", "φ\u0308", Operation::input},
                 {"inertia", "J", Operation::gain, drive.motor_inertia_kgm2},
                 {"friction", "T_{f}", Operation::function, 0, drive.friction_Nm},
                 {"balance", "", Operation::sum},
                 {"gear", "n", Operation::gain, drive.gear_ratio},
                 {"arm torque", "T_{ARM}", Operation::output}};
  graph.edges = {{"motor acceleration", "inertia"},
                 {"motor speed", "friction"},
                 {"motor torque", "balance", '+'},
                 {"inertia", "balance", '-'},
                 {"friction", "balance", '-'},
                 {"balance", "gear"},
                 {"gear", "arm torque"}};
  return graph;
}

figures::ReportFigure drive_diagram_figure(double gear_ratio) {
  figures::ReportFigure out;
  out.paper_number = 6;
  out.id = "fig-06-drive-diagram";
  out.title = tr("Inputs and outputs of the drive");
  out.caption =
      tr("Equation (8): what is left of the motor's torque T after the inertia J of rotor and gear "
         "and the friction of the motor shaft is multiplied by the gear ratio n = {gear_ratio:g} "
         "and drives "
         "the arm.",
         {{"gear_ratio", gear_ratio}});
  out.how_to_read =
      tr("The ideal source imposes the motion, so speed and acceleration of the motor shaft are "
         "known without a controller's delay. Friction acts before the gear: at the arm it is n "
         "times as large.");
  out.alt = tr(
      "Block diagram. An ideal source of motion gives torque, speed and acceleration of the motor "
      "shaft. J times the acceleration and the friction torque are taken from the torque; the "
      "rest times n = {gear_ratio:g} is the arm's torque.",
      {{"gear_ratio", gear_ratio}});
  render::figure::Diagram& diagram = out.figure.diagram.emplace(draw_schematic(
      drive_graph({gear_ratio, 0.0, [](double) { return 0.0; }}), places(), routes()));
  diagram.height = 74;
  diagram.blocks.insert(diagram.blocks.begin(), source_frame());
  diagram.strokes.push_back({{{129, 4}, {129, 70}},
                             render::figure::palette::grey,
                             2.0,
                             render::figure::LineStyle::dash_dot,
                             false,
                             false});
  diagram.texts.push_back({tr("motor side"), {128, 6}, render::figure::TextPlace::left});
  diagram.texts.push_back({tr("arm side"), {130, 6}, render::figure::TextPlace::right});
  diagram.texts.push_back(
      {fmt::format("n = {:g}", gear_ratio), {114, 49}, render::figure::TextPlace::below});
  out.figure.height_px = 820;
  out.figure.id = out.id;
  out.figure.title = out.title;
  return out;
}

}  // namespace tribolog::paper::drawings
