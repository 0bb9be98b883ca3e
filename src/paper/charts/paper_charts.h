#pragma once
// The paper's charts of friction laws, and the parameters that they are drawn with.

#include <vector>

#include "figures/report_figure.h"
#include "friction/static_laws.h"
#include "simulate/presliding_loops.h"

namespace tribolog::paper::charts {

// Static friction that is discontinuous at rest, eq. (1). The law itself is what is drawn solid.

/// Friction over speed on both sides of rest, the range at rest, and the levels.
figures::ReportFigure static_friction_figure(const friction::StribeckFriction& friction);

// Figure 2: static friction made continuous by a linear zone around rest, eq. (2).

/// The whole curve above, the close-up of the linear zone below.
/// @throw std::invalid_argument for a law without Stribeck effect (decay 0): its decay is the scale
/// of the chart.
figures::ReportFigure linear_zone_figure(const friction::ThresholdSpeedFriction& friction);

// Figure 5: hysteresis of friction under an oscillating force.

/// The three loops in two readings of the caption.
struct PreslidingLoops {
  /// Friction has the printed amplitudes, in a motion so slow that its rate does not count.
  std::vector<simulate::PresetLoop> by_friction;
  std::vector<simulate::PresetLoop> at_printed_rate;  ///< The same motion at the printed frequency.
  std::vector<simulate::PreslidingLoop> by_force;     ///< The force has them, at that frequency.
};

PreslidingLoops loops_of_figure_5(const friction::ContactParameters& contact);

/// As printed on one pair of axes, friction over displacement, by friction; below them one panel
/// for each loop by force, all with the same axis of force: their widths differ by orders of
/// magnitude, so that each has its own axis of displacement.
/// @throw std::invalid_argument if a reading has no loop.
figures::ReportFigure presliding_hysteresis_figure(const PreslidingLoops& loops);

// Parameters for the paper's static laws, of which it prints none.
//
// Sizes are those of the paper's joint at the motor: the break-away torque that its hysteresis
// loop has (0.884 N·m), and Coulomb torque, Stribeck velocity and viscous slope with which eq. (1)
// follows the reconstructed curve of eq. (6) in the large: 0.45 N·m at its dip and about 1.17 N·m
// at 300 rad/s.

/// Eq. (1).
friction::StribeckFriction stribeck_at_joint_scale();

/// Eq. (2) with the same torques and slope; its Stribeck effect decays over the Stribeck velocity
/// of the former, and its threshold is the largest that the paper names.
friction::ThresholdSpeedFriction linear_zone_at_joint_scale();

}  // namespace tribolog::paper::charts
