#pragma once
// Every gravity torque and mass that the recordings give, compared with the recommended one.
//
// Estimates from the same data share their errors, so two intervals do not show whether two
// estimates agree: each difference has an interval of its own, from resampling both together.

#include <optional>
#include <vector>

#include "base/statement.h"
#include "method/intervals/bootstrap.h"

namespace tribolog::method::intervals {

struct CrossCheck {
  GravityMethod method;                              ///< Named by the message "estimator.midline".
  statistics::Estimate gravity_Nm;                   ///< Motor side; closed form.
  statistics::Estimate mass_kg;                      ///< The same, as a surrogate mass.
  std::optional<statistics::Estimate> resampled_kg;  ///< With the interval of the bootstrap.
  bool is_recommended{};
  bool is_biased{};             ///< A pair mean of a loop whose motion has harmonics; not expected
                                ///< to agree.
  double difference_percent{};  ///< Of the recommended mass.
  double difference_half_width_percent{};
  /// |difference| in units of its 95 % half width; above 1 the difference is significant. 0 if both
  /// are exact.
  double difference_in_intervals{};
  bool disagrees{};  ///< By more than chance among all methods, and by more than 0.1 %.

  /// Whether it should agree with the recommended one: not the classical regression, whose model is
  /// known to be wrong, nor what the motion biases.
  [[nodiscard]] bool counts() const;
};

struct CrossChecksResult {
  /// Including the recommended one; empty without one, or where it is indistinguishable from zero.
  std::vector<CrossCheck> checks;
  std::optional<selection::ClassicalRegression> classical;
  std::vector<Statement> findings;  ///< Those that disagree, with likely causes.
  /// The recommended torque, its interval widened by the spread of methods that disagree; absent
  /// where none does, or where they disagree by too much.
  std::optional<statistics::Estimate> widened_gravity_Nm;
  bool doubtful{};  ///< They disagree by more than an interval should cover.
};

/// A smaller relative difference is of no consequence, however narrow the intervals.
inline constexpr double least_difference = 1e-3;
/// Relative accuracy of numerics and model.
inline constexpr double numerical_share = 1e-4;
/// An interval that has to be relatively wider than this to cover all methods is no answer.
inline constexpr double largest_spread = 1e-2;

/// @param intervals without resamples, differences are judged as if the estimates were independent.
CrossChecksResult cross_check(const ChainResults& results, const IntervalsResult& intervals);

}  // namespace tribolog::method::intervals
