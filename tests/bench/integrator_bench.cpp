// Prescribed-motion LuGre: ours against CVODE, time per sample and error of each, in one run.
// Errors are against our integrator at a hundredth of the step (its error there is 1e-8 of that at
// the full step; tests/simulate checks the limit itself against CVODE).

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <benchmark/benchmark.h>

#include "simulate/bristle_integrator.h"
#include "support/cvode_bristle.h"

namespace {

using namespace tribolog;

constexpr double frequency_Hz = 1;
constexpr double duration_s = 2;

const tribolog::friction::LuGreFriction paper_joint({465.42, 0.77080, 0.001, 0.60, 0.88437633,
                                                     5.0});
const tribolog::simulate::HarmonicMotion micro_oscillation =
    tribolog::simulate::HarmonicMotion::sine(0, 0.01, frequency_Hz);

std::size_t samples_at(double rate) { return static_cast<std::size_t>(duration_s * rate) + 1; }

const std::vector<double>& reference(double rate) {
  static std::map<double, std::vector<double>> known;
  std::vector<double>& z = known[rate];
  if (z.empty()) {
    constexpr std::size_t finer = 100;
    const std::size_t n = (samples_at(rate) - 1) * finer + 1;
    std::vector<double> fine(n);
    std::vector<double> dz(n);
    tribolog::simulate::integrate_bristle(paper_joint, micro_oscillation, 0, 1 / rate / finer, 0,
                                          fine, dz);
    for (std::size_t i = 0; i < n; i += finer) z.push_back(fine[i]);
  }
  return z;
}

void report(benchmark::State& state, const std::vector<double>& z, double rate) {
  const std::vector<double>& truth = reference(rate);
  double worst = 0;
  double largest = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    worst = std::max(worst, std::abs(z[i] - truth[i]));
    largest = std::max(largest, std::abs(truth[i]));
  }
  state.counters["error"] = worst / largest;
  state.counters["ns_per_sample"] = benchmark::Counter(
      static_cast<double>(z.size()) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void ours(benchmark::State& state) {
  const auto rate = static_cast<double>(state.range(0));
  std::vector<double> z(samples_at(rate));
  std::vector<double> dz(z.size());
  for (auto _ : state) {
    tribolog::simulate::integrate_bristle(paper_joint, micro_oscillation, 0, 1 / rate, 0, z, dz);
    benchmark::DoNotOptimize(z.data());
  }
  report(state, z, rate);
}

void cvode(benchmark::State& state) {
  const auto rate = static_cast<double>(state.range(0));
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(1)));
  tribolog::test::CvodeOptions options;
  options.relative_tolerance = tolerance;
  options.absolute_tolerance_rad = tolerance * 1e-5;
  options.largest_step_s = 0.005 / frequency_Hz;
  options.reversals_s = tribolog::test::sine_reversals(frequency_Hz, duration_s);
  std::vector<double> z(samples_at(rate));
  for (auto _ : state) {
    tribolog::test::solve_bristle_with_cvode(paper_joint, micro_oscillation, 1 / rate, options, z);
    benchmark::DoNotOptimize(z.data());
  }
  report(state, z, rate);
}

BENCHMARK(ours)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(cvode)->ArgsProduct({{10'000, 100'000}, {6, 8, 10, 12}})->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
