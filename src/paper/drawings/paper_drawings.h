#pragma once
// The paper's drawings: of the joint, its drive, the bristle and the LuGre model.

#include <functional>
#include <vector>

#include "figures/report_figure.h"
#include "friction/lugre.h"
#include "joint/gravity_load.h"
#include "paper/drawings/signal_graph.h"
#include "render/figure/diagram.h"

namespace tribolog::paper::drawings {

// Figure 3: two surfaces in contact through elastic bristles, the picture behind LuGre.

/// An elastic bristle, clamped at `root` and straight down (or up, if length is negative) when at
/// rest, whose tip is pushed sideways by `deflection`: the bending line of a cantilever.
std::vector<render::figure::DiagramPoint> bent_bristle(render::figure::DiagramPoint root,
                                                       double length, double deflection);

/// Corners of an upright rectangle.
std::vector<render::figure::DiagramPoint> upright_rectangle(double left, double top, double right,
                                                            double bottom);

/// Of the elastic bristles: five side by side, then the mean one, enlarged.
inline constexpr render::figure::Colour bristle_colour = render::figure::palette::blue;
inline constexpr double enlargement_of_mean_bristle = 2;

figures::ReportFigure bristle_sketch_figure();

// Figure 4: LuGre friction as a block diagram, eq. (3) to (5).

/// The model as a graph. Input "speed" [rad/s], integrator "deflection" z [rad] fed by "rate"
/// dz/dt [rad/s], output "friction" T_f [N·m].
SignalGraph lugre_graph(const friction::LuGreFriction& friction);

/// The same graph, drawn; independent of the parameters' values.
figures::ReportFigure lugre_diagram_figure();

// Figures 6 and 8: the drive from the motor's torque to the arm's, eq. (8), and its gear.

/// What the drive is made of.
struct DriveElements {
  double gear_ratio{};                          ///< n
  double motor_inertia_kgm2{};                  ///< J of rotor and gear, at the motor shaft.
  std::function<double(double)> friction_Nm{};  ///< T_f over motor speed [rad/s].
};

/// Inputs "motor torque" T [N·m], "motor speed" [rad/s], "motor acceleration" [rad/s²]; output
/// "arm torque" T_ARM [N·m], all of eq. (8): T_ARM = n (T - J φ'' - T_f).
SignalGraph drive_graph(const DriveElements& drive);

/// The gear alone. Inputs "shaft torque" T - T_f [N·m], "motor angle" [rad], "motor acceleration"
/// [rad/s²]; outputs "arm torque" [N·m] and "arm angle" q = φ/n [rad].
SignalGraph gear_graph(double gear_ratio, double inertia_kgm2);

/// Figure 6. Drawn from drive_graph; shows the gear ratio's value.
figures::ReportFigure drive_diagram_figure(double gear_ratio);

/// Figure 8. The gear as a sketch, and drawn from gear_graph.
figures::ReportFigure gear_diagram_figure(double gear_ratio);

// Figure 7: the model of the whole joint, from the reference signal to what is measured.

/// The friction models that the joint has both of.
enum class FrictionChoice { steady, dynamic };

struct JointElements {
  DriveElements drive;                                  ///< Its friction: the static model.
  std::function<double(double)> dynamic_friction_Nm{};  ///< Over motor speed, at the present z.
  FrictionChoice friction{FrictionChoice::steady};
  double arm_inertia_kgm2{};  ///< I about the joint's axis.
  joint::GravityLoad load{1.0, 1.0, 0.0};
};

/// Inverse dynamics. Inputs "arm angle" q [rad], "arm speed" [rad/s], "arm acceleration" [rad/s²]
/// of the ideal source of motion; outputs "measured angle", "measured speed" (motor) and "measured
/// torque" T [N·m] (motor).
SignalGraph joint_graph(const JointElements& joint);

figures::ReportFigure joint_diagram_figure();

// The paper's figures that are drawings: 3, 4, 6, 7 and 8.

/// In the paper's order. They show the models that the program computes with and depend on no log;
/// `gear_ratio` (> 0) is printed where the paper prints 100. `ReportFigure::stage` is empty.
std::vector<figures::ReportFigure> paper_drawings(double gear_ratio = 100.0);

}  // namespace tribolog::paper::drawings
