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
  bool is_biased{};             ///< A pair mean of a loop whose motion has even harmonics.
  double difference_percent{};  ///< Of the recommended mass.
  double difference_half_width_percent{};
  /// |difference| in units of its 95 % half width; above 1 the two disagree. 0 if both are exact.
  double difference_in_intervals{};
  bool disagrees{};  ///< More than chance among all methods, and by more than a tenth of a percent.

  /// Whether it should agree with the recommended one: not the classical regression, whose model
  /// the method knows to be wrong, nor what the motion biases.
  [[nodiscard]] bool counts() const;
};

struct CrossChecksResult {
  /// The recommended one among them; empty without one, or where it cannot be told from zero.
  std::vector<CrossCheck> checks;
  std::optional<selection::ClassicalRegression> classical;
  std::vector<Statement> findings;  ///< Those that disagree, with likely causes.
  /// The recommended torque, its interval widened by the spread of methods that disagree; absent
  /// where none does, or where they disagree by too much.
  std::optional<statistics::Estimate> widened_gravity_Nm;
  bool doubtful{};  ///< They disagree by more than an interval should hold.
};

/// A difference of less than this share is of no consequence, however narrow the intervals.
inline constexpr double least_difference = 1e-3;
/// Numbers and model are no better than this share.
inline constexpr double numerical_share = 1e-4;
/// An interval that has to be wider than this share to hold what methods say is no answer.
inline constexpr double largest_spread = 1e-2;

/// @param intervals without resamples: differences are judged as if estimates were independent.
CrossChecksResult cross_check(const ChainResults& results, const IntervalsResult& intervals);

}  // namespace tribolog::method::intervals
