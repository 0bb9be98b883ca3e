#include "statistics/random_stream.h"

#include <cmath>

namespace tribolog::statistics {
namespace {

/// SplitMix64's finaliser: neighbouring inputs give unrelated outputs.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : bits_(mixed(mixed(seed) + stream)) {}

double RandomStream::uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

double RandomStream::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double u{};
  double v{};
  double s{};
  do {
    u = 2 * uniform() - 1;
    v = 2 * uniform() - 1;
    s = u * u + v * v;
  } while (s >= 1 || s == 0);
  const double factor = std::sqrt(-2 * std::log(s) / s);
  spare_ = v * factor;
  has_spare_ = true;
  return u * factor;
}

// Drawing blocks.

namespace {

/// Gamma variate of the given shape >= 1 and scale 1: G. Marsaglia and W. W. Tsang, ACM
/// Transactions on Mathematical Software 26 (2000) 363-372.
double gamma_from_one(RandomStream& random, double shape) {
  const double d = shape - 1.0 / 3.0;
  const double c = 1 / std::sqrt(9 * d);
  for (;;) {
    const double x = random.normal();
    const double root = 1 + c * x;
    if (root <= 0) continue;
    const double v = root * root * root;
    const double u = 1 - random.uniform();  // not zero
    if (std::log(u) < x * x / 2 + d - d * v + d * std::log(v)) return d * v;
  }
}

double chi_square(RandomStream& random, double freedom) {
  const double shape = freedom / 2;
  if (shape >= 1) return 2 * gamma_from_one(random, shape);
  const double u = 1 - random.uniform();
  return 2 * gamma_from_one(random, shape + 1) * std::pow(u, 1 / shape);
}

}  // namespace

std::vector<double> centred_counts(RandomStream& random, std::size_t blocks) {
  std::vector<double> counts(blocks, -1.0);
  for (std::size_t k = 0; k < blocks; ++k) {
    counts[static_cast<std::size_t>(random.uniform() * static_cast<double>(blocks))] += 1;
  }
  return counts;
}

double few_blocks_scale(RandomStream& random, double freedom) {
  return std::isfinite(freedom) ? std::sqrt(freedom / chi_square(random, freedom)) : 1.0;
}

double resampled_mean_shift(const std::vector<double>& values, const std::vector<double>& counts) {
  const auto n = static_cast<double>(values.size());
  if (values.size() < 2) return 0;
  double mean = 0;
  for (const double value : values) mean += value / n;
  double shift = 0;
  for (std::size_t k = 0; k < values.size(); ++k) shift += counts[k] * (values[k] - mean) / n;
  return shift * std::sqrt(n / (n - 1));
}

}  // namespace tribolog::statistics
