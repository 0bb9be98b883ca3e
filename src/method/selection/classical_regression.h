#pragma once
// Internal to the cross-checks: the linear regression over everything that moves.

#include <optional>

#include "method/selection/gravity_by_other_ways.h"

namespace tribolog {

struct ClassicalFit {
  ClassicalRegression regression;
  GravityByOtherWay gravity;
};

/// Neighbouring samples are averaged in groups, so that a long log costs no more than a short one:
/// the terms are linear, and a mean of rows is a row. Speed and acceleration are slopes over
/// neighbouring groups. Rest takes no part. Absent without both directions, or if the recordings
/// cannot tell the columns apart.
std::optional<ClassicalFit> classical_regression(const std::vector<const Recording*>& recordings,
                                                 double gear_ratio, double middle_rad);

}  // namespace tribolog
