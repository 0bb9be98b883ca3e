#pragma once
// Bias, scatter and coverage of an estimator over many runs of known truth.
//
// Bias is the mean error, known to scatter / sqrt(runs). Coverage is the share of the runs whose
// stated 95 % interval holds the truth; its own interval is Wilson's, which stays within 0 to 1 and
// is right at the shares near 1 that matter here, where the usual p +- 1.96 sqrt(p(1-p)/n) is not.

#include <cstddef>
#include <vector>

#include "statistics/estimate.h"

namespace tribolog::study {

/// A share with its 95 % interval; 0 <= low <= value <= high <= 1.
struct Share {
  double value{};
  double low{};
  double high{};
};

/// Wilson's interval of `hits` out of `trials` (Wilson 1927).
/// @throw std::invalid_argument if hits > trials or there is no trial.
Share wilson_share(std::size_t hits, std::size_t trials);

struct ErrorStatistics {
  std::size_t runs{};   ///< Of the study.
  std::size_t found{};  ///< Those in which the estimator gave a number.
  double truth{};
  double bias{};                 ///< Mean error; NaN if never found.
  double bias_standard_error{};  ///< NaN with fewer than two.
  double scatter{};              ///< Standard deviation of the errors; NaN with fewer than two.
  double error_95{};             ///< 95 of 100 errors are no larger (by size, nearest rank).
  double half_width{};           ///< Mean half width of the stated intervals.
  Share coverage;                ///< Of those found.

  /// The bias is more than three of its standard errors, and larger than what matters.
  [[nodiscard]] bool is_biased(double practical_bound) const;
  /// The runs are all the same, for want of noise: they count as one, and their coverage says
  /// nothing.
  [[nodiscard]] bool all_alike() const;
  /// The coverage is below or above what 91 to 99 % allows, beyond its own uncertainty.
  [[nodiscard]] bool intervals_too_narrow() const;
  [[nodiscard]] bool intervals_too_wide() const;
};

/// @param estimates one per run in which the quantity was found. @param runs as many or more.
ErrorStatistics error_statistics(const std::vector<statistics::Estimate>& estimates, double truth,
                                 std::size_t runs);

}  // namespace tribolog::study
