#pragma once
// The change from one estimate to another, with its interval.
//
// The two are of different recordings: their errors are independent. With d = x2 - x1 the sides of
// the 95 % interval add in quadrature, each with the side that moves d the same way:
//
//   d - sqrt((x2 - low2)^2 + (high1 - x1)^2)   to   d + sqrt((high2 - x2)^2 + (x1 - low1)^2)
//
// Exact for normal errors; for lopsided ones the usual approximation (R. Barlow, "Asymmetric
// errors", PHYSTAT 2003). What both estimates share, such as a torque constant that is wrong in
// both, cancels. Where the stated intervals hold such an error all the same, that of the model for
// one, the interval of the change is too wide, never too narrow.

#include <optional>
#include <vector>

#include "statistics/estimate.h"

namespace tribolog::history {

struct Change {
  Estimate absolute;                ///< In the quantity's unit.
  std::optional<Estimate> percent;  ///< Of the first value as it stands; absent near zero.
  double chance{1};  ///< Of a change at least this large without one, two-sided, normal errors.
};

/// @param is_angle the difference is taken on the circle, -pi to pi, and not in percent.
Change change_between(const Estimate& first, const Estimate& second, bool is_angle);

/// Holm's step-down adjustment (1979): with these, the chance of one wrong "changed" among all is
/// the chance that is compared with, whatever depends on what.
std::vector<double> holm_adjusted(const std::vector<double>& chances);

}  // namespace tribolog::history
