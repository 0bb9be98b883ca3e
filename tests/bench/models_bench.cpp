// Every dynamic friction model under prescribed motion: our own method (friction_response) against
// CVODE on the same model's rates. Same motion, same contact (table 1 of the paper), same samples
// of torque from an unloaded contact. Times per sample and errors; model_ratios.py prints the
// ratios.
//
// Error: the largest difference of a torque sample from the reference, over the static torque. It
// counts in full where a jump (reset integrator, a bond that snaps) falls on the wrong side of a
// sample. Discrete members are not compared: a wrong one shows in the torque. The random bonds come
// from a counter, so that both see the same ones in the same order.
//
// Reference: our method in steps so many times finer (`finer`). It is ours, so it needs a proof:
// the smallest error of CVODE's runs is how far the two solvers agree, and is printed beside ours.
//
// CVODE gets what helps it: BDF with dense Newton and Adams with fixed-point iteration, a ladder of
// tolerances, its own steps with interpolated samples, reversals known beforehand, event location,
// no unknowns for discrete members. Its time at our error is interpolated (log-log) between those
// of its runs, of both methods, that no other run beats in both time and error. Where even its best
// run is less exact than ours, that run's time stands as a lower bound; where all are more exact,
// the cheapest one's time.
//
// Bonds: 500 of them snap 66,000 times in a second of sliding, and each is a stop for CVODE. They
// have fewer tolerances and samples, and Adams only: BDF would factorise a matrix of 500 by 500 at
// each stop. A run that fails or stops without end is reported as such.

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "friction/catalogue.h"
#include "simulate/model_portrait.h"
#include "support/cvode_friction.h"

namespace {

using namespace tribolog;
using Method = tribolog::simulate::CvodeSolver::Method;

const tribolog::friction::ContactParameters contact;

struct NamedMotion {
  std::string name;
  tribolog::simulate::HarmonicMotion motion;
};

// Samples do not fall on reversals, where a torque that jumps there could be read on either side.
constexpr double frequency_Hz = 2;
constexpr double phase_rad = 0.1234567;

tribolog::simulate::HarmonicMotion oscillation(double amplitude_rad, double third_harmonic_rad) {
  return {0,
          frequency_Hz,
          {{amplitude_rad * std::sin(phase_rad), amplitude_rad * std::cos(phase_rad)},
           {0, 0},
           {0, third_harmonic_rad}}};
}

const std::vector<NamedMotion>& motions() {
  // The contact slides fully beyond 1.5e-5; the Stribeck velocity is 1e-3. So: pre-sliding with
  // inner loops, and strokes of 60 times that way at up to 6 times that speed.
  static const std::vector<NamedMotion> all{{"pre-sliding", oscillation(6e-6, 5e-6)},
                                            {"sliding", oscillation(5e-4, 0)}};
  return all;
}

/// One model, motion and sampling rate, with the reference.
class Task {
 public:
  Task(const tribolog::friction::FrictionModelEntry& entry, const NamedMotion& motion,
       double rate_Hz)
      : model_(entry.matched(contact)), motion_(motion.motion), rate_Hz_(rate_Hz) {
    const bool snaps_often = entry.traits.is_random && motion.name == "sliding";
    duration_s_ = snaps_often ? 0.2 : 1.0;
    constexpr double scan_s = 0.003;
    reversals_s_ = tribolog::test::reversals_of(motion_, duration_s_, scan_s);
  }

  [[nodiscard]] std::vector<double> by_our_method() const { return by_our_method(rate_Hz_); }
  [[nodiscard]] std::vector<double> by_cvode(Method method, double tolerance) const {
    tribolog::test::CvodeFrictionOptions options;
    options.method = method;
    options.relative_tolerance = tolerance;
    options.largest_step_s = 0.01;
    options.first_step_s = 1e-6;
    options.reversals_s = reversals_s_;
    std::vector<double> torque(samples(rate_Hz_));
    tribolog::test::friction_by_cvode(*model_, motion_, 1 / rate_Hz_, options, torque);
    return torque;
  }
  [[nodiscard]] double error_of(const std::vector<double>& torque) {
    constexpr std::size_t finer = 50;
    if (reference_.empty()) reference_ = by_our_method(rate_Hz_ * finer);
    double worst = 0;
    for (std::size_t i = 0; i < torque.size(); ++i) {
      worst = std::max(worst, std::abs(torque[i] - reference_[i * finer]));
    }
    return worst / contact.static_Nm;
  }

 private:
  [[nodiscard]] std::size_t samples(double rate_Hz) const {
    return static_cast<std::size_t>(std::lround(duration_s_ * rate_Hz)) + 1;
  }
  [[nodiscard]] std::vector<double> by_our_method(double rate_Hz) const {
    std::vector<double> torque(samples(rate_Hz));
    std::vector<double> state = model_->unloaded();
    tribolog::simulate::friction_response(*model_, motion_, 0, 1 / rate_Hz, state, torque);
    return torque;
  }

  std::unique_ptr<tribolog::friction::DynamicFriction> model_;
  const tribolog::simulate::Motion& motion_;
  double rate_Hz_;
  double duration_s_;
  std::vector<double> reversals_s_;
  std::vector<double> reference_;
};

template <class Solve>
void measure(benchmark::State& state, Task& task, const Solve& solve) {
  std::vector<double> torque;
  try {
    for (auto _ : state) {
      torque = solve();
      benchmark::DoNotOptimize(torque.data());
    }
  } catch (const std::exception& failure) {
    state.SkipWithError(failure.what());
    return;
  }
  state.counters["error"] = task.error_of(torque);
  state.counters["ns_per_sample"] = benchmark::Counter(
      static_cast<double>(torque.size()) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void register_cvode(const std::string& name, const std::shared_ptr<Task>& task, Method method,
                    int digits) {
  const std::string kind = method == Method::bdf ? "bdf" : "adams";
  benchmark::RegisterBenchmark(
      (name + "/cvode-" + kind + "-1e-" + std::to_string(digits)).c_str(),
      [task, method, digits](benchmark::State& state) {
        measure(state, *task, [&] { return task->by_cvode(method, std::pow(10.0, -digits)); });
      });
}

void register_task(const tribolog::friction::FrictionModelEntry& entry, const NamedMotion& motion,
                   double rate_Hz) {
  const auto task = std::make_shared<Task>(entry, motion, rate_Hz);
  const std::string name =
      entry.name + "/" + motion.name + "/" + std::to_string(std::lround(rate_Hz));
  benchmark::RegisterBenchmark((name + "/ours").c_str(), [task](benchmark::State& state) {
    measure(state, *task, [&] { return task->by_our_method(); });
  });
  const bool is_random = entry.traits.is_random;
  for (int digits = 3; digits <= 13; digits += is_random ? 3 : 1) {
    register_cvode(name, task, Method::adams, digits);
    if (!is_random) register_cvode(name, task, Method::bdf, digits);
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const tribolog::friction::FrictionModelEntry& entry :
       tribolog::friction::dynamic_friction_models()) {
    for (const NamedMotion& motion : motions()) {
      for (const double rate_Hz : {1e3, 1e4}) register_task(entry, motion, rate_Hz);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
