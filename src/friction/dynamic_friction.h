#pragma once
// The common shape of friction models with memory.
//
// A model turns the motion of the shaft into a friction torque through a state that the motion
// changes: deflections of bristles, torques of elements, a lagged speed. Angle and torque may as
// well be displacement [m] and force [N]: no equation knows the difference.

#include <cstddef>
#include <span>
#include <vector>

#include "friction/named_parameters.h"
#include "friction/speed_step.h"

namespace tribolog::friction {

class DynamicFriction : public FrictionModel {
 public:
  /// How many numbers the state has.
  [[nodiscard]] virtual std::size_t states() const = 0;

  /// The state of a contact that has never been loaded: all zero unless the model says otherwise.
  [[nodiscard]] virtual std::vector<double> unloaded() const {
    return std::vector<double>(states(), 0.0);
  }

  /// d(state)/dt at a speed. Discrete members of a state (an element slips or sticks) have rate 0
  /// and are changed by settle() only.
  virtual void rates(std::span<const double> state, double speed_rad_s,
                     std::span<double> rates) const = 0;

  /// Brings the discrete members of a state in line with its continuous ones and the speed: what a
  /// solver of ordinary differential equations calls after each of its steps. Most models have
  /// none.
  virtual void settle(std::span<double> /*state*/, double /*speed_rad_s*/) const {}

  /// How many values event_values() gives.
  [[nodiscard]] virtual std::size_t events() const { return 0; }
  /// Values whose zeros are the moments at which settle() would change the state; a solver stops
  /// there. A reversal of the speed is always such a moment and is not among them.
  virtual void event_values(std::span<const double> /*state*/, double /*speed_rad_s*/,
                            std::span<double> /*values*/) const {}

  /// The size that each member of a state usually has: what a solver's errors are measured by.
  virtual void state_scales(std::span<double> scales) const = 0;

  /// Friction torque [N·m], positive where it resists a positive speed.
  [[nodiscard]] virtual double torque_Nm(std::span<const double> state,
                                         double speed_rad_s) const = 0;

  /// Torque [N·m] that steady sliding at this speed ends in; 0 at rest.
  [[nodiscard]] virtual double steady_torque_Nm(double speed_rad_s) const = 0;

  /// Advances the state over a piece of prescribed motion, with the model's own method: exact where
  /// the model allows that, and never bound by its stiffness.
  virtual void advance(std::span<double> state, const SpeedStep& step) const = 0;

  /// Advances over steps of which each begins where the one before ended, and reads the torque
  /// [N·m] at the end of each. As advance() and torque_Nm() in turn; a model that needs the same
  /// numbers for a step's end and the next one's start can do better.
  /// @param torque_Nm out: as many as steps.
  virtual void respond(std::span<double> state, std::span<const SpeedStep> steps,
                       std::span<double> torque_Nm) const {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      advance(state, steps[i]);
      torque_Nm[i] = this->torque_Nm(state, steps[i].end_rad_s);
    }
  }
};

}  // namespace tribolog::friction
