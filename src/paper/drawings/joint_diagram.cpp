#include <utility>

#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/schematic.h"
#include "wording/tr.h"

namespace tribolog::paper::drawings {

namespace {

using render::figure::Block;
using render::figure::BlockKind;
using render::figure::BlockSide;
using render::figure::TextPlace;
using wording::tr;

constexpr double measured_speed_row = 11;
constexpr double friction_row = 36;
constexpr double contact = 7;  // of the switch, above and below the middle
constexpr double inertia_row = 62;
constexpr double arm_inertia_row = 82;
constexpr double gravity_row = 101;
constexpr double measured_angle_row = 116;
constexpr double source_column = 37.5;
constexpr double branch_column = 50.5;
constexpr double gear_column = 61;
constexpr double model_column = 89;
constexpr double sum_column = 130;
constexpr double arm_sum_column = 113;
constexpr double output_column = 152;

std::map<std::string, NodePlace> places() {
  return {
      {"arm speed", {{source_column, friction_row}, 11, 10}},
      {"arm acceleration", {{source_column, inertia_row}, 11, 10}},
      {"arm angle", {{source_column, gravity_row}, 11, 10}},
      {"speed gear", {{gear_column, friction_row}, 12, 13}},
      {"acceleration gear", {{gear_column, inertia_row}, 12, 13}},
      {"static friction",
       {{model_column, friction_row - contact},
        27,
        11,
        render::figure::BlockSide::right,
        {tr("static (6), (7)")}}},
      {"dynamic friction",
       {{model_column, friction_row + contact},
        27,
        11,
        render::figure::BlockSide::right,
        {"LuGre (3)–(5)"}}},
      {"friction choice", {{113, friction_row}, 12, 4 * contact}},
      {"inertia", {{model_column, inertia_row}, 14, 13}},
      {"arm inertia", {{model_column, arm_inertia_row}, 14, 13}},
      {"gravity",
       {{model_column - 4, gravity_row},
        36,
        11,
        render::figure::BlockSide::right,
        {"m g r cos(q + q_{c})"}}},
      {"arm torque", {{arm_sum_column, gravity_row}, 10, 10}},
      {"gear", {{sum_column, arm_inertia_row}, 15, 15, render::figure::BlockSide::top}},
      {"torque", {{sum_column, inertia_row}, 10, 10}},
      {"measured speed", {{output_column, measured_speed_row}, 11, 10}},
      {"measured torque", {{output_column, inertia_row}, 11, 10}},
      {"measured angle", {{output_column, measured_angle_row}, 11, 10}},
  };
}

std::vector<WireRoute> routes() {
  const Port left{render::figure::BlockSide::left, 0};
  const Port right{render::figure::BlockSide::right, 0};
  const Port top{render::figure::BlockSide::top, 0};
  const Port bottom{render::figure::BlockSide::bottom, 0};
  const double speed_branch = 70;
  const double above = friction_row - contact;
  return {
      {"arm speed", "speed gear", right, left},
      {"speed gear", "measured speed", top, left, {}, {{speed_branch, above}}},
      {"speed gear", "static friction", right, left, {speed_branch, above}},
      {"speed gear", "dynamic friction", bottom, left, {}, {{speed_branch, friction_row}}},
      {"static friction", "friction choice", right, {render::figure::BlockSide::left, -contact}},
      {"dynamic friction", "friction choice", right, {render::figure::BlockSide::left, contact}},
      {"friction choice", "torque", right, top, {}, {}, "T_{f}", {124.5, friction_row}},
      {"arm acceleration", "acceleration gear", right, left},
      {"acceleration gear", "inertia", right, left, {}, {}, "φ\u0308", {74.5, inertia_row}},
      {"inertia", "torque", right, left, {}, {}, "J φ\u0308", {110.5, inertia_row}},
      {"arm acceleration", "arm inertia", bottom, left, {}, {{branch_column, inertia_row}}},
      {"arm inertia", "arm torque", right, top, {}, {}, "I q\u0308", {104, arm_inertia_row}},
      {"arm angle", "gravity", right, left},
      {"arm angle", "measured angle", bottom, left, {}, {{branch_column, gravity_row}}},
      {"gravity", "arm torque", right, left},
      {"arm torque", "gear", right, bottom, {}, {}, "T_{ARM}", {124.5, gravity_row}},
      {"gear", "torque", top, bottom},
      {"torque", "measured torque", right, left},
  };
}

void add_surroundings(render::figure::Diagram& diagram) {
  const auto frame = [](std::vector<std::string> lines, render::figure::DiagramPoint centre,
                        double width, double height) {
    render::figure::Block block;
    block.kind = render::figure::BlockKind::frame;
    block.lines = std::move(lines);
    block.centre = centre;
    block.width = width;
    block.height = height;
    block.colour = render::figure::palette::grey;
    block.fill.alpha = 0;
    return block;
  };
  diagram.blocks.push_back(frame(in_lines(tr("ideal source\nof motion")), {36.5, 65}, 22, 88));
  diagram.blocks.push_back(frame({tr("friction")}, {96.5, friction_row - 1.5}, 48, 35));
  render::figure::Block reference;
  reference.lines = in_lines(tr("reference\nsignal"));
  reference.centre = {11.5, 67};
  reference.width = 19;
  reference.height = 14;
  diagram.blocks.push_back(reference);
  render::figure::Wire wire;
  wire.points = {{21, 67}, {25.5, 67}};
  diagram.wires.push_back(wire);
  diagram.texts.push_back({tr("measured"), {159, 3}, render::figure::TextPlace::left, true});
}

}  // namespace

figures::ReportFigure joint_diagram_figure() {
  const auto none = [](double) { return 0.0; };
  JointElements any;
  any.drive = {1.0, 0.0, none};
  any.dynamic_friction_Nm = none;
  figures::ReportFigure out;
  out.paper_number = 7;
  out.id = "fig-07-joint-model";
  out.title = tr("Model of the joint");
  out.caption =
      tr("Inverse dynamics of the joint: an ideal source moves the arm along the reference signal, "
         "and the motor torque T is what friction, the inertia J of motor and gear, and the arm "
         "with inertia I and gravity require. Sweeps and runs at constant speed use the static "
         "friction model, micro-oscillations the dynamic one.");
  out.how_to_read =
      tr("Angles and torques pass through the gear: n towards the motor, 1/n for the arm's torque. "
         "The outputs on the right are all that a robot's log contains: the arm's angle, the "
         "motor's speed and its torque.");
  out.alt =
      tr("Block diagram. From the reference signal an ideal source of motion generates angle, "
         "speed and acceleration of the arm. Through the gear they drive the friction models and "
         "the inertia of the motor; gravity and inertia of the arm, divided by n, are added to the "
         "motor torque. Measured are q, the motor speed and T.");
  out.figure.diagram = draw_schematic(joint_graph(any), places(), routes());
  out.figure.diagram->height = 123;
  add_surroundings(*out.figure.diagram);
  out.figure.height_px = 1310;
  out.figure.id = out.id;
  out.figure.title = out.title;
  return out;
}

SignalGraph joint_graph(const JointElements& joint) {
  const DriveElements& drive = joint.drive;
  const double n = drive.gear_ratio;
  const auto gravity = [load = joint.load](double q) { return load.torque_Nm(q); };
  const std::size_t choice = joint.friction == FrictionChoice::steady ? 0 : 1;
  SignalGraph graph;
  graph.nodes = {
      {"arm angle", "q", Operation::input},
      {"arm speed", "q\u0307", Operation::input},
      {"arm acceleration", "q\u0308", Operation::input},
      {"speed gear", "n", Operation::gain, n},
      {"acceleration gear", "n", Operation::gain, n},
      {"static friction", "", Operation::function, 0, drive.friction_Nm},
      {"dynamic friction", "", Operation::function, 0, joint.dynamic_friction_Nm},
      {"friction choice", "", Operation::selector, 0, {}, choice},
      {"inertia", "J", Operation::gain, drive.motor_inertia_kgm2},
      {"arm inertia", "I", Operation::gain, joint.arm_inertia_kgm2},
      {"gravity", "", Operation::function, 0, gravity},
      {"arm torque", "", Operation::sum},
      {"gear", "1/n", Operation::gain, 1.0 / n},
      {"torque", "", Operation::sum},
      {"measured speed", "φ\u0307", Operation::output},
      {"measured torque", "T", Operation::output},
      {"measured angle", "q", Operation::output},
  };
  graph.edges = {
      {"arm speed", "speed gear"},
      {"arm acceleration", "acceleration gear"},
      {"speed gear", "static friction"},
      {"speed gear", "dynamic friction"},
      {"static friction", "friction choice"},
      {"dynamic friction", "friction choice"},
      {"acceleration gear", "inertia"},
      {"arm acceleration", "arm inertia"},
      {"arm angle", "gravity"},
      {"arm inertia", "arm torque"},
      {"gravity", "arm torque"},
      {"arm torque", "gear"},
      {"friction choice", "torque"},
      {"inertia", "torque"},
      {"gear", "torque"},
      {"speed gear", "measured speed"},
      {"torque", "measured torque"},
      {"arm angle", "measured angle"},
  };
  return graph;
}

}  // namespace tribolog::paper::drawings
