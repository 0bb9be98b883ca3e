#pragma once
// Is friction the same in both directions?
//
// At equal angle and speed (T(+v) + T(-v))/2 is gravity and whatever of friction does not change
// its sign with the motion. What is left of it without the recommended gravity torque is the
// asymmetry: half the difference of the two directions' friction. It is the limit of the reference
// (T(+v) - T(-v))/2, which is the mean of the two. An offset of the torque signal looks the same,
// and so does an error of the gravity torque as far as its interval reaches.

#include <string>
#include <vector>

#include "method/hysteresis/surrogate_masses.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/estimate.h"

namespace tribolog {

struct DirectionAsymmetryResult {
  bool examined{false};             ///< The numbers below are valid.
  bool found{false};                ///< Larger than its interval and the error of gravity together.
  std::string sentence;             ///< Never empty.
  std::vector<double> speed_rad_s;  ///< Per pair of runs, motor side, > 0.
  std::vector<double> asymmetry_Nm;
  Estimate mean_Nm;                   ///< Over the pairs; scatter of the pairs.
  double gravity_could_explain_Nm{};  ///< Half width of the gravity torque, at the pairs' angles.
};

/// @param mass the recommended one, or nullptr.
/// @param sweep_offset_Nm what was taken out of the pairs where they come from a sweep.
DirectionAsymmetryResult identify_direction_asymmetry(const ViscousCurvesResult& curves,
                                                      const SurrogateMass* mass,
                                                      double sweep_offset_Nm);

}  // namespace tribolog
