#pragma once
// Starts, stops and changes of speed in sweeps and runs, and the forces that act in them: what a
// lag between torque and angle, and its rivals, are found from.
//
// A row is the motion about one sample, smoothed over its neighbours as the torque will be
// (statistics/smoothed_derivatives.h). Friction is a polygon over the speed: no law is assumed.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"
#include "statistics/smoothed_derivatives.h"

namespace tribolog::method::motion {

/// A recording whose starts and stops are looked at.
struct Travel {
  const joint::Recording* recording{};
  std::size_t half{};  ///< Samples to either side that a row is made of.
  double dt_s{};
  statistics::SmoothedDerivatives smoothed;
  std::vector<double> speed;  ///< Of each sample.
};

/// The smoothed motion about one sample.
struct TransientRow {
  std::size_t travel{};  ///< Its index.
  std::size_t index{};
  double speed{}, acceleration{};
  std::size_t transient{};  ///< Number of its start or stop.
};

/// Those of one or several recordings.
struct Transients {
  std::vector<Travel> travels;
  std::vector<TransientRow> rows;
  std::size_t count{};
};

/// Those of all recordings whose sampling is dense enough to show them.
/// @param recordings outlive what is returned.
Transients find_transients(const std::vector<const joint::Recording*>& recordings,
                           double gear_ratio);

/// Some of the rows, their transients numbered from 0 on without gaps.
void renumber_transients(std::vector<TransientRow>& rows);

/// Where the friction polygon over the speed bends: as many rows between any two.
std::vector<double> speed_knots(const std::vector<TransientRow>& rows);

/// Columns of forces_at_samples(); behind them one for each knot.
enum class Force : Eigen::Index { cosine, sine, offset, coulomb, bends };

/// What acts at each sample of a travel besides inertia and viscous friction.
Eigen::MatrixXd forces_at_samples(const Travel& travel, const std::vector<double>& knots);

}  // namespace tribolog::method::motion
