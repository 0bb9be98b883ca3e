#pragma once
// Reproducible random numbers: the same seed gives the same numbers on every machine (the standard
// library's normal distribution does not).

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace tribolog::statistics {

class RandomStream {
 public:
  /// @param seed of the run @param stream independent stream of that seed, e.g. one per recording.
  RandomStream(std::uint64_t seed, std::uint64_t stream);
  /// Uniform in [0, 1), 53 bits.
  double uniform();
  /// Standard normal (Marsaglia's polar method).
  double normal();

 private:
  std::mt19937_64 bits_;
  double spare_{};
  bool has_spare_{false};
};

// Drawing blocks with replacement, with a correction for their small number.
//
// A bootstrap of m blocks underestimates the scatter, and a percentile interval ignores how poorly
// few blocks determine their own scatter: with nine cycles its coverage would be 90 instead of 95
// %. Each draw is therefore scaled by sqrt(f / chi-square(f)), f the degrees of freedom of the
// blocks' scatter. Resampled deviations are then distributed as Student's t: the percentile
// interval of one mean is its t interval, and a sum over several groups of blocks has the tails
// that its groups justify.

/// How often each of `blocks` blocks was drawn in as many draws with replacement, less 1.
std::vector<double> centred_counts(RandomStream& random, std::size_t blocks);

/// sqrt(f / chi-square(f)); 1 for infinite f. @param freedom > 0
double few_blocks_scale(RandomStream& random, double freedom);

/// Deviation of the resampled mean of some values from their mean, scaled to the unbiased variance
/// of the mean, without few_blocks_scale().
/// @param counts of centred_counts(), one per value; they may be part of a larger draw.
double resampled_mean_shift(const std::vector<double>& values, const std::vector<double>& counts);

}  // namespace tribolog::statistics
