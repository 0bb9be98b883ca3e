#pragma once
// Errors at groups of samples that took no part in the fit.

#include <vector>

#include "method/viscous/curve_fit.h"

namespace tribolog {

/// Groups that are held out in turn: all but the slowest and the fastest where there are six or
/// more, else all.
std::vector<std::size_t> groups_to_hold_out(const std::vector<CurveSample>& samples);

/// Mean squared error [N²·m²] of each group held out, from fits to the others that start at `all`.
/// Empty if one of the fits fails.
std::vector<double> held_out_errors(const CurveFit& all, const std::vector<CurveSample>& samples,
                                    const std::vector<std::size_t>& groups);

/// Mean of `one - other` over the groups, and its standard error.
struct ErrorDifference {
  double mean{};
  double standard_error{};
};
ErrorDifference difference(const std::vector<double>& one, const std::vector<double>& other);

double root_mean(const std::vector<double>& squares);

}  // namespace tribolog
