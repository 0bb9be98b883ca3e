#pragma once
// Internal to the gravity of the runs: the runs' plateaus, and the rows of the regression.

#include <cstddef>
#include <optional>
#include <vector>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/gravity/ripple_spectrum.h"
#include "method/motion/plateaus.h"

namespace tribolog::method::gravity {

/// A plateau of constant speed, and the angles it passes [rad, joint].
struct GravityRun {
  const joint::Recording* recording;
  motion::Plateau plateau;
  double low_rad, high_rad;
};

/// Mean of a run within a cell of the angle, less the mean of the run.
struct GravityRow {
  std::size_t run, cell;
  double cosine, sine;  ///< Of the angle from the middle; the cosine less 1.
  double torque_Nm;
};

/// The cells of the joint angle [rad] over which rows are formed.
struct GravityCells {
  static constexpr std::size_t count = 240;  ///< Over all angles; a run's mean in each is one row.
  static constexpr std::size_t blocks = 24;  ///< Within each, rows are not independent.
  double lowest_rad, highest_rad;

  [[nodiscard]] double middle_rad() const { return (lowest_rad + highest_rad) / 2; }
  [[nodiscard]] std::size_t of(double q_rad) const;
};

std::vector<GravityRun> gravity_runs_of(const std::vector<const joint::Recording*>& recordings);

/// Rows of all runs. Subtracting a run's means from its columns is equivalent to an offset of its
/// own.
/// @param ripple is subtracted from the torque, by the motor's angle.
/// @param of_angle is subtracted too.
std::vector<GravityRow> gravity_rows(const std::vector<GravityRun>& runs, const GravityCells& cells,
                                     double gear_ratio, const Ripple& ripple,
                                     const std::optional<TorqueOfAngle>& of_angle);

/// The ripple that the runs show beyond b cos + c sin and an offset for each run, of at least one
/// period a motor turn and half a period a block: what is slower does not come from the motor or
/// looks like gravity, and shows as scatter between the blocks. White noise is the median of the
/// runs'.
/// @param b_Nm, c_Nm amplitudes of the rows' cosine and sine [N·m].
Ripple ripple_of_runs(const std::vector<GravityRun>& runs, const GravityCells& cells,
                      double gear_ratio, double b_Nm, double c_Nm,
                      const std::optional<TorqueOfAngle>& of_angle);

}  // namespace tribolog::method::gravity
