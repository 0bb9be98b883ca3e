#pragma once
// The viscous curve as models see it: size of friction against size of speed, with the direction
// and the load beside them.

#include <cstddef>
#include <vector>

#include "method/viscous/viscous_curves.h"

namespace tribolog {

struct CurveSample {
  double speed_rad_s{};  ///< > 0, motor side.
  double friction_Nm{};  ///< Against the motion; negative where a wrong mass makes it drive.
  double direction{};    ///< +1: joint angle rising, -1: falling.
  double load{};         ///< Share of the gravity torque that loads the joint, 0 to 1.
  std::size_t group{};   ///< Held out together: all runs of one speed, or neighbouring angles.
};

/// Sorted by group, groups counting from 0. Runs within 3 % of the same speed are one group, the
/// two directions too: what is left over them, ripple or an error of gravity, is the same. The
/// cells of a sweep are grouped by neighbouring angles instead.
std::vector<CurveSample> curve_samples(const ViscousCurvesResult& curves,
                                       const ViscousCurve& curve);

/// Number of groups.
std::size_t group_count(const std::vector<CurveSample>& samples);

}  // namespace tribolog
