#pragma once
// Runs at constant speed without what their inertia takes of the torque.
//
// After the corner of a speed ramp a drive in closed loop settles for a while: the speed creeps
// towards what was asked for, within any sensible tolerance of a plateau, and J times that small
// acceleration stands in the torque. Fast runs are short, so that most of it stays in their mean:
// friction grows or shrinks with the speed by it, and so does the viscous coefficient.

#include <cstddef>
#include <vector>

#include "joint/recording.h"

namespace tribolog::method::motion {

class SteadyRuns {
 public:
  SteadyRuns() = default;
  /// @param recordings are referred to, and must outlive this.
  /// @param inertia_kgm2 J, at the joint, of all that moves; 0: not known, and nothing is taken
  /// off. J q''(t) is taken off each plateau: q'' is a local slope of local slopes of the angle,
  /// over windows of up to a twentieth of the plateau, which average over noise and vibration.
  explicit SteadyRuns(std::vector<const joint::Recording*> recordings, double inertia_kgm2 = 0);

  /// In the order given.
  [[nodiscard]] std::vector<const joint::Recording*> recordings() const;
  /// What was taken off the torque of one of them, sample by sample; empty: nothing.
  [[nodiscard]] const std::vector<double>& taken_off_Nm(std::size_t recording) const;
  /// That the logged torque is rounded to; 0: to none. A slow run may stay on one value all along:
  /// the others tell the step.
  [[nodiscard]] double torque_step_Nm() const { return torque_step_Nm_; }

 private:
  std::vector<const joint::Recording*> logged_;
  std::vector<joint::Recording> without_inertia_;  ///< Empty: as logged.
  std::vector<std::vector<double>> taken_off_Nm_;  ///< One for each of these.
  double torque_step_Nm_{};
};

}  // namespace tribolog::method::motion
