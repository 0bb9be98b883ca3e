#pragma once
// A friction model with memory under prescribed motion: its torque over time.

#include <span>
#include <vector>

#include "friction/catalogue.h"
#include "friction/friction_model.h"
#include "simulate/motion.h"

namespace tribolog::simulate {

/// Advances the model from sample to sample; an interval in which the motion reverses is cut there.
/// @param motion of the shaft the friction acts on.
/// @param t0_s time of the first sample, dt_s sampling interval > 0.
/// @param state in: at t0_s; out: at the last sample.
/// @param torque_Nm out: friction torque at t0, t0 + dt, ...; its size is the number of samples.
/// @throw std::invalid_argument if dt_s is not > 0 or the state is not of the model's size.
void friction_response(const friction::DynamicFriction& friction, const Motion& motion, double t0_s,
                       double dt_s, std::span<double> state, std::span<double> torque_Nm);

// What a friction model does in four short experiments, for comparing models by their pictures.

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
