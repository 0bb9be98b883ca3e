#pragma once
// The samples of a sweep as its figures need them: which were used, and in which direction.

#include <cstddef>
#include <vector>

#include "joint/dataset.h"
#include "method/gravity/cog_sweep.h"

namespace tribolog::figures {

enum class Stroke : signed char { falling = -1, left_out = 0, rising = 1 };

/// One recording of a sweep. All vectors have the same length.
struct SweepTrace {
  std::vector<double> t_s;  ///< From 0; a further recording goes on where the one before ended.
  std::vector<double> q_rad;
  std::vector<double> motor_speed_rad_s;  ///< Gear ratio times the local slope of the angle.
  std::vector<double> torque_Nm;
  std::vector<Stroke> stroke;  ///< left_out also where the slope is zero.
};

/// The recordings of the role. Those without a sample are passed over. A mask of another length
/// counts as "all left out".
std::vector<SweepTrace> sweep_traces(const method::gravity::SweepCurves& sweep,
                                     const joint::Dataset& dataset, joint::Role role);

std::size_t count(const std::vector<SweepTrace>& sweeps, Stroke stroke);

/// A signal of SweepTrace, e.g. &SweepTrace::q_rad.
using Signal = std::vector<double> SweepTrace::*;

/// That signal of all samples with this stroke, or of all samples, in the order of time.
std::vector<double> signal_of(const std::vector<SweepTrace>& sweeps, Stroke stroke, Signal signal);
std::vector<double> signal_of(const std::vector<SweepTrace>& sweeps, Signal signal);

/// Two signals over an uninterrupted stretch of samples; of equal length.
struct Stretch {
  std::vector<double> x;
  std::vector<double> y;
};

/// One stretch for each time the stroke is taken up. A mask that flickers gives very many: beyond a
/// few dozen they come as one, with a gap (not a number) between them.
std::vector<Stretch> stretches_of(const std::vector<SweepTrace>& sweeps, Stroke stroke, Signal x,
                                  Signal y);

}  // namespace tribolog::figures
