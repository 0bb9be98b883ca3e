#pragma once
// Figures 6 and 8: the drive from the motor's torque to the arm's, eq. (8), and its gear.

#include <functional>

#include "figures/report_figure.h"
#include "paper/drawings/signal_graph.h"

namespace tribolog::paper::drawings {

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

}  // namespace tribolog::paper::drawings
