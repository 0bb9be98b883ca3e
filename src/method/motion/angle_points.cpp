#include "method/motion/angle_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribolog {
namespace {

/// Standard deviation of rounding, in steps.
const double rounding = 1 / std::sqrt(12.0);
/// Steps rest for many samples where the motion all but stands; it is not known that well there.
constexpr double most_samples_on_step = 20;

/// Samples [first, last) of one value.
struct Tread {
  std::size_t first, last;
  [[nodiscard]] double samples() const { return static_cast<double>(last - first); }
};

std::vector<Tread> treads_of(const std::vector<double>& q, double step_rad) {
  std::vector<Tread> treads;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (treads.empty() || std::abs(q[i] - q[i - 1]) > step_rad / 2) treads.push_back({i, i});
    treads.back().last = i + 1;
  }
  return treads;
}

}  // namespace

CurvePoints angle_points(const std::vector<double>& t, const std::vector<double>& q,
                         double step_rad) {
  if (!(step_rad > 0)) return {t, q, std::vector<double>(t.size(), 1.0)};
  const std::vector<Tread> treads = treads_of(q, step_rad);
  CurvePoints out;
  const auto add = [&](double time, double angle, double error) {
    if (!out.t.empty() && !(time > out.t.back())) return;
    out.t.push_back(time);
    out.y.push_back(angle);
    out.error.push_back(error);
  };
  const auto rise = [&](std::size_t k) { return q[treads[k + 1].first] - q[treads[k].first]; };
  for (std::size_t k = 0; k < treads.size(); ++k) {
    const Tread& tread = treads[k];
    const bool at_end = k == 0 || k + 1 == treads.size();
    if (at_end || rise(k - 1) * rise(k) < 0) {
      const std::size_t last = tread.last - 1;
      const double time = k == 0 ? t.front() : at_end ? t.back() : (t[tread.first] + t[last]) / 2;
      add(time, q[tread.first], rounding * step_rad);
    }
    if (k + 1 == treads.size()) break;
    const Tread& next = treads[k + 1];
    const double samples =
        std::clamp(std::min(tread.samples(), next.samples()), 1.0, most_samples_on_step);
    add((t[tread.last - 1] + t[next.first]) / 2, (q[tread.first] + q[next.first]) / 2,
        rounding * step_rad / samples);
  }
  return out;
}

}  // namespace tribolog
