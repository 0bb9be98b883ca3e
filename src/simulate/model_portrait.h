#pragma once
// What a friction model does in four short experiments, for comparing models by their pictures.

#include <vector>

#include "friction/catalogue.h"

namespace tribolog::simulate {

struct PortraitCurve {
  std::vector<double> x;
  std::vector<double> torque_Nm;  ///< As many as x.
};

struct ModelPortrait {
  PortraitCurve steady;      ///< x: speed [rad/s] on both sides of rest, where it jumps.
  PortraitCurve loop;        ///< x: angle [rad]; slow strokes of pre-sliding with inner loops.
  PortraitCurve lag;         ///< x: speed [rad/s], going up and down without reversal.
  PortraitCurve break_away;  ///< x: way [rad] from rest at a small constant speed.
  double largest_Nm{};       ///< On the way to sliding.
  double sliding_Nm{};       ///< At the end of that way.
  double lag_Nm{};           ///< Mean torque at rising less that at falling speed.
  /// Torque at the end of an inner loop less that at its start; 0 for non-local memory.
  double inner_loop_gap_Nm{};
};

/// The model with parameters that match the contact. Ways scale with the contact's elastic
/// deflection (static torque / stiffness), speeds with its Stribeck velocity.
ModelPortrait portrait_of(const friction::FrictionModelEntry& entry,
                          const friction::ContactParameters& contact);

}  // namespace tribolog::simulate
