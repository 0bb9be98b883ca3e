#pragma once
// The paper's twenty-two figures: what can be read off the printed one, or has to hold in it.

#include <vector>

#include "figures/report_figure.h"
#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

/// Figures 1, 2 and 5: the points that are drawn.
Checks check_static_chart(const PapersJoint& joint, const figures::ReportFigure& drawn);
Checks check_linear_zone_chart(const PapersJoint& joint, const figures::ReportFigure& drawn);
Checks check_presliding_chart(const PapersJoint& joint);
/// Figure 3: from the lines that are drawn.
Checks check_bristle_sketch(const figures::ReportFigure& drawn);
/// Figures 6 to 8: the diagrams' graphs against the simulation.
Checks check_drive_diagram(const PapersJoint& joint);
Checks check_lugre_diagram(const PapersJoint& joint);
Checks check_joint_diagram(const PapersJoint& joint);
Checks check_gear_diagram(const PapersJoint& joint);
/// Figures 9, 10 and 12: the arm in space.
Checks check_robot(const PapersJoint& joint);
Checks check_mass_model(const PapersJoint& joint);
Checks check_motion_range(const PapersJoint& joint);
/// Figures 11, 13 and 14: the sweeps.
Checks check_sweep_motion(const PapersJoint& joint);
Checks check_rough_peak(const PapersJoint& joint);
Checks check_precise_peak(const PapersJoint& joint);
/// Figures 15 to 17: the loops.
Checks check_torque_loop(const PapersJoint& joint);
Checks check_deflection_loop(const PapersJoint& joint);
Checks check_rate_loop(const PapersJoint& joint);
/// Figures 18 to 22: the viscous curves and the choice among them.
Checks check_candidate_curves(const PapersJoint& joint);
Checks check_reference_curve(const PapersJoint& joint);
Checks check_quality_errors(const PapersJoint& joint);
Checks check_selected_curve(const PapersJoint& joint);
Checks check_torque_choice(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
