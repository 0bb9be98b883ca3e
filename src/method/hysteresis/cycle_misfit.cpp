#include "method/hysteresis/cycle_misfit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "statistics/distributions.h"

namespace tribolog::method::hysteresis {
namespace {

constexpr std::size_t fewest_cycles = 4;
constexpr std::size_t most_harmonics = 25;
constexpr double fewest_samples_in_period = 8;  // of the highest harmonic

using Coefficients = std::vector<std::complex<double>>;  // by harmonic, the first is the mean

/// Of one cycle from sample `first` to before `end`.
Coefficients coefficients_of(const joint::Recording& r, const std::vector<double>& model_Nm,
                             double frequency_Hz, std::size_t first, std::size_t end,
                             std::size_t harmonics) {
  Coefficients out(harmonics + 1);
  const auto n = static_cast<double>(end - first);
  for (std::size_t i = first; i < end; ++i) {
    const double turns = frequency_Hz * (r.t_s[i] - r.t_s.front());
    const std::complex<double> step =
        std::polar(1.0, -2 * std::numbers::pi * (turns - std::floor(turns)));
    std::complex<double> power = (r.torque_Nm[i] - model_Nm[i]) / n;
    out[0] += power;
    for (std::size_t k = 1; k <= harmonics; ++k) {
      power *= step;
      out[k] += 2.0 * power;
    }
  }
  return out;
}

struct MeanAndScatter {
  std::complex<double> mean;
  double variance{};  ///< Of one component of a single cycle's coefficient.
  double freedom{};   ///< Of both components.
};

/// About a straight line over the cycles, which removes a drift.
MeanAndScatter over_cycles(const std::vector<Coefficients>& cycles, std::size_t k) {
  const auto n = static_cast<double>(cycles.size());
  MeanAndScatter out;
  for (const Coefficients& c : cycles) out.mean += c[k] / n;
  std::complex<double> slope;
  double squares = 0;
  for (std::size_t p = 0; p < cycles.size(); ++p) {
    const double at = static_cast<double>(p) - (n - 1) / 2;
    slope += at * (cycles[p][k] - out.mean);
    squares += at * at;
  }
  slope /= squares;
  double scatter = 0;
  for (std::size_t p = 0; p < cycles.size(); ++p) {
    const double at = static_cast<double>(p) - (n - 1) / 2;
    scatter += std::norm(cycles[p][k] - out.mean - slope * at);
  }
  out.freedom = 2 * (n - 2);
  out.variance = scatter / out.freedom;
  return out;
}

}  // namespace

bool CycleMisfit::is_significant() const {
  constexpr double chance_of_a_false_alarm = 0.01;
  return is_known() && chance < chance_of_a_false_alarm;
}

CycleMisfit cycle_misfit(const joint::Recording& r, const std::vector<double>& model_Nm,
                         double frequency_Hz) {
  CycleMisfit out;
  if (r.size() < 2 || !(frequency_Hz > 0) || model_Nm.size() != r.size()) return out;
  // Samples at which a cycle begins.
  std::vector<std::size_t> begins;
  double next = 1;
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (frequency_Hz * (r.t_s[i] - r.t_s.front()) < next - 1e-9) continue;
    begins.push_back(i);
    next += 1;
  }
  if (begins.size() < fewest_cycles + 1) return out;
  const double in_cycle =
      static_cast<double>(begins.back() - begins.front()) / static_cast<double>(begins.size() - 1);
  const auto harmonics =
      std::min(most_harmonics, static_cast<std::size_t>(in_cycle / fewest_samples_in_period));
  if (harmonics < 2) return out;
  std::vector<Coefficients> cycles;
  for (std::size_t p = 0; p + 1 < begins.size(); ++p) {
    cycles.push_back(
        coefficients_of(r, model_Nm, frequency_Hz, begins[p], begins[p + 1], harmonics));
  }
  out.cycles = cycles.size();
  const auto n = static_cast<double>(cycles.size());
  double odd = 0;
  double even = 0;
  for (std::size_t k = 1; k <= harmonics; ++k) {
    const MeanAndScatter m = over_cycles(cycles, k);
    const double f = m.variance > 0 ? n * std::norm(m.mean) / (2 * m.variance) : 0;
    const double chance = statistics::f_upper_tail(f, 2, m.freedom);
    out.harmonics.push_back({static_cast<int>(k), std::abs(m.mean), std::arg(m.mean),
                             std::sqrt(m.variance / n), chance});
    out.chance = std::min(out.chance, chance * static_cast<double>(harmonics));
    (k % 2 == 1 ? odd : even) += std::max(0.0, (std::norm(m.mean) - 2 * m.variance / n) / 2);
  }
  out.systematic_Nm = std::sqrt(odd + even);
  if (odd + even > 0) {
    out.odd_share = odd / (odd + even);
    out.even_share = even / (odd + even);
  }
  return out;
}

}  // namespace tribolog::method::hysteresis
