#pragma once
// Figure 7: the model of the whole joint, from the reference signal to what is measured.

#include <functional>

#include "figures/report_figure.h"
#include "joint/gravity_load.h"
#include "paper/drawings/drive_diagram.h"
#include "paper/drawings/signal_graph.h"

namespace tribolog::paper::drawings {

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

}  // namespace tribolog::paper::drawings
