#pragma once
// The noise of a dataset as its recordings show it: what a repetition of the measurement would
// have.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "simulate/scenario.h"
#include "truth/readings.h"

namespace tribolog::truth {

/// Standard deviation of the white part of a torque [N·m], from third differences of neighbouring
/// samples (statistics/sampled_signal.h). The smaller one of their mean square and their median:
/// jumps of friction at a reversal weigh on the first, steps of the torque on the second. 0 with
/// fewer than four samples.
double white_torque_Nm(const std::vector<double>& torque_Nm);

/// Torque ripple periodic in the motor's angle, from what the rough sweep's fit leaves: the
/// strongest lines of a search as fine as its samples allow (method/gravity/ripple_spectrum.h), up
/// to four, so enlarged that together they make the standard deviation CogSweepResult::ripple_Nm.
/// Periods of which the sweep holds fewer than three are left out: they cannot be separated from
/// gravity. Empty where no line carries a tenth of the ripple's variance. Phases are as found.
/// @param dataset that the sweep belongs to, `curves` those of its rough sweep.
std::vector<simulate::Noise::Ripple> ripple_of(const joint::Dataset& dataset,
                                               const method::gravity::CogSweepResult& rough,
                                               const method::gravity::SweepCurves& curves);

// What was identified, as a simulation: its torque along the recorded motions.
//
// Angles, speeds and times are those of the log, so that its motions, its sampling and its encoder
// are all in it whatever they were. The torque is the model's:
//
//   sweeps and runs:   T = G cos(q - q_peak) + offset + Tf(speed) + J acceleration
//   oscillations:      T = G cos(q - q_peak) + s0 z + s1 dz/dt + s2 w + J dw/dt, eq. (3), (4)
//
// with speeds from the angle itself. G is that of the recommended estimator in all of them: one
// joint, whose numbers are known.

struct IdentifiedJoint {
  /// The dataset with the model's torque, without noise. Recordings that the model cannot follow
  /// are left out.
  joint::Dataset dataset;
  std::vector<std::vector<double>> friction_Nm;  ///< In the torque of each recording.
  std::vector<Reading> put_in;   ///< The numbers it was made with, each an estimate of no width.
  std::vector<double> white_Nm;  ///< White noise found in each recording of `dataset`.
  std::vector<double> torque_step_Nm;        ///< Step of the torque in each; 0: continuous.
  std::vector<double> scatter_of_points_Nm;  ///< Of friction points about the law, each file's.
  std::vector<simulate::Noise::Ripple>
      ripple;                       ///< Found in the rough sweep; laid on all recordings.
  std::vector<Statement> left_out;  ///< What could not be simulated, and why.
};

/// @param dataset the one that the calibration was made from.
IdentifiedJoint identified_joint(const joint::Dataset& dataset,
                                 const calibration::Calibration& calibration);

/// The joint's torque with the noise of one run, and its ripple at phases of that run.
joint::Dataset with_noise(const IdentifiedJoint& joint, std::uint64_t seed, std::size_t run);

}  // namespace tribolog::truth
