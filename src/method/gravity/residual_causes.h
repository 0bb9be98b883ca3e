#pragma once
// Where a sweep's residual comes from: each cause widens an interval by a rule of its own.
//
// ripple     repeats with the motor's angle, with the same sign there and back. A loop at one
//            position cannot average it out.
// friction   repeats with the angle, with opposite signs there and back: it cancels in a loop.
// vibration  is periodic in time.
// noise      is correlated in time without a period: blocks of neighbours already account for it.
//
// Lines of three spectra compete (over angle, over angle times direction, over time): the strongest
// that stands out from its neighbourhood is found in each, the one with the most power is removed,
// and the search continues. In the remainder, products of the two directions' residuals at equal
// angle show what repeats with it. A sweep in one direction cannot show that; all of it then counts
// as ripple.

#include <vector>

#include "method/gravity/ripple_spectrum.h"
#include "method/motion/sweep_samples.h"

namespace tribolog::method::gravity {

/// A torque periodic in time.
struct VibrationLine {
  double frequency_Hz{};
  double amplitude_Nm{};  ///< Motor side.
};

struct ResidualCauses {
  Ripple ripple;
  std::vector<VibrationLine> vibration;  ///< In the order in which they were found.
  Ripple friction;                       ///< Lines over the motor's angle, of a rising joint angle.
  double coloured_Nm{};                  ///< Standard deviation.
  /// Torque of all lines at each sample, to be subtracted.
  std::vector<double> lines_Nm;
};

/// @param residual_Nm one per sample of the sweep.
/// @param beyond_white_Nm its standard deviation beyond white noise, > 0.
ResidualCauses find_residual_causes(const motion::Sweep& sweep,
                                    const std::vector<double>& residual_Nm, double gear_ratio,
                                    double beyond_white_Nm, double white_variance);

}  // namespace tribolog::method::gravity
