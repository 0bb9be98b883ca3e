#pragma once
// Every gravity torque and mass that the recordings give, held against the recommended one.
//
// Estimates from the same data share their errors, so that two intervals do not tell whether two
// estimates agree: each difference has an interval of its own, from resampling both together.

#include <optional>
#include <vector>

#include "base/statement.h"
#include "method/intervals/bootstrap.h"

namespace tribolog::method::intervals {

struct CrossCheck {
  GravityMethod method;             ///< "estimator.midline" is the message that names it.
  statistics::Estimate gravity_Nm;  ///< Motor side; closed form.
  statistics::Estimate mass_kg;     ///< The same, as a surrogate mass.
  std::optional<statistics::Estimate> resampled_kg;  ///< With the interval of the bootstrap.
  bool is_recommended{};
  double difference_percent{};  ///< Of the recommended mass.
  double difference_half_width_percent{};
  /// |difference| in units of its 95 % half width; above 1 the two disagree. 0 if both are exact.
  double difference_in_intervals{};
  bool disagrees{};  ///< Beyond its interval and beyond a tenth of a percent.
};

struct CrossChecksResult {
  /// The recommended one among them; empty without one, or where it cannot be told from zero.
  std::vector<CrossCheck> checks;
  std::optional<selection::ClassicalRegression> classical;
  std::vector<Statement> findings;  ///< Those that disagree, with likely causes.
  /// Whether one of those disagrees that should agree: not the classical regression, whose model
  /// the method knows to be wrong.
  bool doubtful{};
};

/// A difference of less than this share is of no consequence, however narrow the intervals.
inline constexpr double least_difference = 1e-3;

/// @param intervals without resamples: differences are judged as if estimates were independent.
CrossChecksResult cross_check(const ChainResults& results, const IntervalsResult& intervals);

}  // namespace tribolog::method::intervals
