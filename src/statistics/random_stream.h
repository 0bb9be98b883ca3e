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

}  // namespace tribolog::statistics
