#include "inspect/motion/stroke_shape.h"

#include <algorithm>
#include <cmath>

#include "inspect/motion/way.h"

namespace tribolog {
namespace {

constexpr double steady_share = 0.87;
constexpr double even_share = 0.9;     // of halves that agree
constexpr double slowest_share = 0.6;  // of any tenth of the middle half: slower is a pause

bool agree(double a, double b) { return std::min(a, b) >= even_share * std::max(a, b); }

/// Time at which the way first reaches a share of its travel, interpolated.
double time_at(const AngleTrace& trace, const Way& way, double share) {
  const double level = share * way.travel_rad();
  for (std::size_t i = way.first() + 1; i <= way.last(); ++i) {
    if (way.at(i) < level) continue;
    const double rise = way.at(i) - way.at(i - 1);
    const double part = rise > 0 ? (level - way.at(i - 1)) / rise : 1.0;
    return trace.t_s[i - 1] + std::clamp(part, 0.0, 1.0) * (trace.t_s[i] - trace.t_s[i - 1]);
  }
  return trace.t_s[way.last()];
}

}  // namespace

StrokeShape shape_of(const AngleTrace& trace, const AngleStroke& stroke) {
  const Way way(trace, stroke.first, stroke.last);
  const auto speed = [&](double from, double to) {
    const double seconds = time_at(trace, way, to) - time_at(trace, way, from);
    return seconds > 0 ? (to - from) * way.travel_rad() / seconds : 0.0;
  };
  StrokeShape shape;
  shape.speed_rad_s = speed(0.3, 0.7);
  if (!(shape.speed_rad_s > 0)) return shape;
  const double least = steady_share * shape.speed_rad_s;
  const double early = speed(0.1, 0.25);
  const double late = speed(0.75, 0.9);
  const bool is_even = agree(speed(0.25, 0.5), speed(0.5, 0.75));
  for (double share = 0.25; share < 0.7; share += 0.1) {
    if (speed(share, share + 0.1) < slowest_share * shape.speed_rad_s) return shape;
  }
  const bool has_slow_start = is_even && agree(late, shape.speed_rad_s);
  const bool has_slow_end = is_even && agree(early, shape.speed_rad_s);
  shape.is_steady = (early >= least && late >= least) || has_slow_start || has_slow_end;
  return shape;
}

}  // namespace tribolog
