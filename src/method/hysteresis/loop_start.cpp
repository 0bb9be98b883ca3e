#include "method/hysteresis/loop_start.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace tribolog::method::hysteresis {
namespace {

struct Range {
  double low{std::numeric_limits<double>::infinity()};
  double high{-std::numeric_limits<double>::infinity()};
};

}  // namespace

double settled_from_s(const joint::Recording& r, double period_s) {
  constexpr double fewest_later_cycles = 2;
  constexpr double beyond = 0.1;        // of the later cycles' height
  constexpr double times_the_blow = 2;  // what it leaves behind dies away about as fast as it
  constexpr double shortest_cycle_share = 0.02;
  if (r.size() < 2 || !(period_s > 0)) return 0;
  const auto since = [&](std::size_t i) { return r.t_s[i] - r.t_s.front(); };
  if (since(r.size() - 1) < (1 + fewest_later_cycles) * period_s) return 0;
  Range later;
  std::size_t first_later = 0;
  while (since(first_later) < period_s) ++first_later;
  for (std::size_t i = first_later; i < r.size(); ++i) {
    later.low = std::min(later.low, r.torque_Nm[i]);
    later.high = std::max(later.high, r.torque_Nm[i]);
  }
  const double margin = beyond * (later.high - later.low);
  if (!(margin > 0)) return 0;
  for (std::size_t i = first_later; i-- > 0;) {
    if (r.torque_Nm[i] > later.high + margin || r.torque_Nm[i] < later.low - margin) {
      return std::max(times_the_blow * since(i), shortest_cycle_share * period_s);
    }
  }
  return 0;
}

}  // namespace tribolog::method::hysteresis
