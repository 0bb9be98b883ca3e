#include "method/viscous/curve_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tribolog {
namespace {

constexpr double same_speed = 0.03;
constexpr std::size_t sweep_groups = 12;

}  // namespace

std::vector<CurveSample> curve_samples(const ViscousCurvesResult& curves,
                                       const ViscousCurve& curve) {
  std::vector<std::size_t> order(curves.runs.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::size_t i) {
    const ConstantSpeedRun& run = curves.runs[i];
    return curves.from_sweep ? run.q_rad : std::abs(run.speed_rad_s);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<CurveSample> samples;
  double first = std::numeric_limits<double>::quiet_NaN();
  std::size_t group = 0;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const ConstantSpeedRun& run = curves.runs[order[place]];
    const double direction = run.speed_rad_s < 0 ? -1.0 : 1.0;
    const double friction = direction * curve.friction_Nm[order[place]];
    if (curves.from_sweep) {
      group = place * std::min(sweep_groups, order.size()) / order.size();
    } else if (!(key(order[place]) <= (1 + same_speed) * first)) {
      group += samples.empty() ? 0 : 1;
      first = key(order[place]);
    }
    samples.push_back({std::abs(run.speed_rad_s), friction, direction, run.mean_load, group});
  }
  return samples;
}

std::size_t group_count(const std::vector<CurveSample>& samples) {
  return samples.empty() ? 0 : samples.back().group + 1;
}

}  // namespace tribolog
