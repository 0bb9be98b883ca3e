#include <string>

#include <fmt/format.h>

#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/schematic.h"
#include "wording/tr.h"

namespace tribolog::paper::drawings {
namespace {

using render::figure::Arc;
using render::figure::BlockSide;
using render::figure::TextPlace;
using wording::tr;

constexpr double sketch_row = 26;
constexpr double inertia_row = 59;
constexpr double torque_row = 77;
constexpr double angle_row = 96;
constexpr double input_column = 18;
constexpr double inertia_column = 50;
constexpr double sum_column = 76;
constexpr double gear_column = 104;
constexpr double output_column = 142;

std::map<std::string, NodePlace> places() {
  return {{"motor acceleration", {{input_column, inertia_row}, 18, 10}},
          {"shaft torque", {{input_column, torque_row}, 18, 10}},
          {"motor angle", {{input_column, angle_row}, 18, 10}},
          {"inertia", {{inertia_column, inertia_row}, 15, 14}},
          {"balance", {{sum_column, torque_row}, 10, 10}},
          {"gear", {{gear_column, torque_row}, 15, 15}},
          {"reduction", {{gear_column, angle_row}, 15, 15}},
          {"arm torque", {{output_column, torque_row}, 18, 10}},
          {"arm angle", {{output_column, angle_row}, 18, 10}}};
}

std::vector<WireRoute> routes() {
  const Port left{render::figure::BlockSide::left, 0};
  const Port right{render::figure::BlockSide::right, 0};
  const Port top{render::figure::BlockSide::top, 0};
  return {
      {"motor acceleration", "inertia", right, left},
      {"inertia", "balance", right, top, {}, {}, "J φ\u0308", {67, inertia_row}},
      {"shaft torque", "balance", right, left},
      {"balance", "gear", right, left},
      {"gear", "arm torque", right, left},
      {"motor angle", "reduction", right, left},
      {"reduction", "arm angle", right, left},
  };
}

render::figure::Arc circle(render::figure::DiagramPoint centre, double radius) {
  render::figure::Arc arc;
  arc.centre = centre;
  arc.radius = radius;
  return arc;
}

render::figure::Arc turning(render::figure::DiagramPoint centre, double radius, double from_deg,
                            double to_deg, render::figure::Colour colour) {
  render::figure::Arc arc = circle(centre, radius);
  arc.from_deg = from_deg;
  arc.to_deg = to_deg;
  arc.colour = colour;
  arc.width_px = 3.5;
  arc.arrow_at_end = true;
  return arc;
}

/// Pinion and wheel as seen along their axes.
void add_sketch(render::figure::Diagram& diagram, double gear_ratio) {
  const render::figure::DiagramPoint pinion{58, sketch_row};
  const render::figure::DiagramPoint wheel{86, sketch_row};
  const double pinion_radius = 8;
  const double wheel_radius = 20;
  render::figure::Arc small = circle(pinion, pinion_radius);
  small.fill = ground::state;
  render::figure::Arc large = circle(wheel, wheel_radius);
  large.fill = ground::element;
  diagram.arcs = {small, large, circle(wheel, 1.0)};
  diagram.arcs.back().fill = render::figure::palette::black;
  diagram.arcs.push_back(turning(pinion, 11.5, 130, 240, render::figure::palette::vermilion));
  diagram.arcs.push_back(turning(wheel, 23.5, 50, -50, render::figure::palette::blue));
  diagram.texts.push_back({"J", pinion, render::figure::TextPlace::centre});
  diagram.texts.push_back({fmt::format("n = {:g}", gear_ratio),
                           {wheel.x, wheel.y + 8},
                           render::figure::TextPlace::centre});
  diagram.texts.push_back(
      {tr("motor shaft"), {44, sketch_row - 6}, render::figure::TextPlace::left, true});
  diagram.texts.push_back({"T − T_{f},  φ", {44, sketch_row}, render::figure::TextPlace::left});
  diagram.texts.push_back(
      {tr("arm"), {112, sketch_row - 6}, render::figure::TextPlace::right, true});
  diagram.texts.push_back({"T_{ARM},  q", {112, sketch_row}, render::figure::TextPlace::right});
}

}  // namespace

SignalGraph gear_graph(double gear_ratio, double inertia_kgm2) {
  SignalGraph graph;
  graph.nodes = {{"shaft torque", "T − T_{f}", Operation::input},
                 {"motor angle", "φ", Operation::input},
                 {"motor acceleration", "φ\u0308", Operation::input},
                 {"inertia", "J", Operation::gain, inertia_kgm2},
                 {"balance", "", Operation::sum},
                 {"gear", "n", Operation::gain, gear_ratio},
                 {"reduction", "1/n", Operation::gain, 1.0 / gear_ratio},
                 {"arm torque", "T_{ARM}", Operation::output},
                 {"arm angle", "q", Operation::output}};
  graph.edges = {{"motor acceleration", "inertia"},
                 {"shaft torque", "balance", '+'},
                 {"inertia", "balance", '-'},
                 {"balance", "gear"},
                 {"gear", "arm torque"},
                 {"motor angle", "reduction"},
                 {"reduction", "arm angle"}};
  return graph;
}

figures::ReportFigure gear_diagram_figure(double gear_ratio) {
  figures::ReportFigure out;
  out.paper_number = 8;
  out.id = "fig-08-gear-model";
  out.title = tr("Model of the gear");
  out.caption =
      tr("An ideal gear of ratio n = {gear_ratio:g} with the inertia of rotor and gear reflected "
         "to the motor shaft as J: torque is multiplied by n, the angle divided by n, and no power "
         "is lost.",
         {{"gear_ratio", gear_ratio}});
  out.how_to_read =
      tr("The arrows in the sketch, which is not to scale, are the positive senses on both sides. "
         "Without acceleration the arm's torque is n times what friction leaves of the motor's; a "
         "real gear's own losses are included in the friction.");
  out.alt =
      tr("Sketch of a pinion on the motor shaft and a wheel on the arm, and a block diagram: the "
         "motor's torque minus friction and minus J times its acceleration, times n = "
         "{gear_ratio:g}, is the arm's torque; the motor angle divided by n is the arm's angle q.",
         {{"gear_ratio", gear_ratio}});
  render::figure::Diagram& diagram =
      out.figure.diagram.emplace(draw_schematic(gear_graph(gear_ratio, 0.0), places(), routes()));
  diagram.height = 105;
  add_sketch(diagram, gear_ratio);
  out.figure.height_px = 1130;
  out.figure.id = out.id;
  out.figure.title = out.title;
  return out;
}

}  // namespace tribolog::paper::drawings
