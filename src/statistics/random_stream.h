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

// Drawing blocks with replacement, and paying for their small number.
//
// A bootstrap of m blocks shows less scatter than there is, and a percentile interval knows nothing
// of how badly few blocks tell their own scatter: nine cycles would cover 90 % instead of 95. Each
// draw is therefore scaled by sqrt(f / chi-square(f)), f the degrees of freedom of the blocks'
// scatter. Resampled deviations are then spread as Student's t, so that the percentile interval of
// one mean is its t interval, and a sum over several groups of blocks gets the tails that its
// groups justify.

/// How often each of `blocks` was drawn, in `blocks` draws with replacement, less 1.
std::vector<double> centred_counts(RandomStream& random, std::size_t blocks);

/// sqrt(f / chi-square(f)); 1 for infinite f. @param freedom > 0
double few_blocks_scale(RandomStream& random, double freedom);

/// Deviation of the resampled mean of some values from their mean. Counts from above, one for each
/// value; they may be part of a larger draw. Scaled to the unbiased variance of the mean, without
/// few_blocks_scale().
double resampled_mean_shift(const std::vector<double>& values, const std::vector<double>& counts);

}  // namespace tribolog::statistics
