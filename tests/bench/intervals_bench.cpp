// What 1,000 resamples cost: the chain on the paper-size dataset with them and without, on two
// cores. Prints the ratio of the medians of interleaved rounds; status 1 from ten times on.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "identify/identify.h"
#include "support/paper_joint.h"

namespace {

double milliseconds(const tribolog::joint::Dataset& dataset, std::size_t resamples) {
  tribolog::identify::IdentifyOptions options;
  options.resamples = resamples;
  options.threads = 2;
  const auto start = std::chrono::steady_clock::now();
  const tribolog::calibration::Calibration calibration =
      tribolog::identify::identify(dataset, options);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  return calibration.masses.masses.empty() ? 0.0 : took.count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

}  // namespace

int main() {
  constexpr int rounds = 9;
  constexpr double most = 10;
  const tribolog::joint::Dataset dataset =
      tribolog::simulate::simulated_dataset(tribolog::test::noisy_paper_joint(1));
  std::vector<double> without, with;
  for (int round = 0; round < rounds; ++round) {
    without.push_back(milliseconds(dataset, 0));
    with.push_back(milliseconds(dataset, 1000));
  }
  const double ratio = median(with) / median(without);
  std::printf("chain without resamples %.1f ms, with 1,000 %.1f ms: %.2f times (limit %.0f)\n",
              median(without), median(with), ratio, most);
  return ratio < most ? 0 : 1;
}
