#pragma once
// Where a sweep's residual comes from, as each cause widens an interval by a rule of its own.
//
// ripple     repeats with the motor's angle, with the same sign there and back. A loop at one
//            position cannot average it out.
// friction   repeats with the angle, with opposite signs there and back: it cancels in a loop.
// vibration  is periodic in time.
// noise      hangs together in time without a period: what blocks of neighbours already hold.
//
// Lines of all three spectra compete (over the angle, over the angle times the direction, over the
// time): of each the strongest that stands out of its own neighbourhood is found, the one that
// carries most is taken out, and the search goes on. In what is left, the products of both
// directions' residuals at equal angle tell what repeats with it. A sweep of one direction cannot
// tell; there all of it counts as ripple.

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
  /// Of each sample: the torque of all lines, to be taken off.
  std::vector<double> lines_Nm;
};

/// @param residual_Nm one per sample of the sweep.
/// @param beyond_white_Nm its standard deviation beyond white noise, > 0.
ResidualCauses find_residual_causes(const motion::Sweep& sweep,
                                    const std::vector<double>& residual_Nm, double gear_ratio,
                                    double beyond_white_Nm, double white_variance);

}  // namespace tribolog::method::gravity
