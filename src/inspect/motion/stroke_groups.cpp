#include <algorithm>
#include <cmath>

#include "inspect/motion/angle_trace.h"
#include "inspect/motion/strokes_and_ramps.h"
#include "statistics/order_statistics.h"

namespace tribolog::inspect::motion {

namespace {

constexpr double steady_share = 0.87;
constexpr double even_share = 0.9;     // of halves that agree
constexpr double slowest_share = 0.6;  // of any tenth of the middle half: slower is a pause

bool agree(double a, double b) { return std::min(a, b) >= even_share * std::max(a, b); }

/// Time at which the way first reaches a share of its travel, interpolated.
double time_at(const AngleTrace& trace, const TravelBetweenTurns& way, double share) {
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
  const TravelBetweenTurns way(trace, stroke.first, stroke.last);
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

namespace {

constexpr double least_ratio = 0.7;
constexpr double least_speed_ratio = 0.92;
constexpr double longest_rest = 0.5;        // of the shorter stroke
constexpr double least_part_stroke = 0.35;  // a sine from its middle begins with half a stroke
constexpr double regular_share = 0.6;       // of a chain's strokes, in its largest group
constexpr std::size_t short_chain = 2;

double ratio(double a, double b) { return std::min(a, b) / std::max(a, b); }

class Grouping {
 public:
  Grouping(const AngleTrace& trace, const StrokeFamily& family, double widest_oscillation_rad)
      : trace_(trace), family_(family), widest_oscillation_rad_(widest_oscillation_rad) {
    for (const AngleStroke& stroke : family) shapes_.push_back(shape_of(trace, stroke));
  }

  std::vector<StrokeGroup> groups() {
    for (std::size_t k = 0; k < family_.size(); ++k) {
      if (k == 0 || !are_alike(k - 1, k)) ends_.push_back(k);
    }
    ends_.push_back(family_.size());
    take_part_strokes();
    std::vector<StrokeGroup> groups;
    for (std::size_t g = 0; g + 1 < ends_.size(); ++g) {
      if (ends_[g] < ends_[g + 1]) groups.push_back(group(ends_[g], ends_[g + 1]));
    }
    mark_irregular_chains(groups);
    return groups;
  }

 private:
  [[nodiscard]] double seconds(const AngleStroke& s) const {
    return trace_.t_s[s.last] - trace_.t_s[s.first];
  }

  [[nodiscard]] bool come_after_each_other(std::size_t a, std::size_t b) const {
    const AngleStroke& before = family_[a];
    const AngleStroke& behind = family_[b];
    const double rest = trace_.t_s[behind.first] - trace_.t_s[before.last];
    return before.travel_rad * behind.travel_rad < 0 &&
           rest <= longest_rest * std::min(seconds(before), seconds(behind));
  }

  [[nodiscard]] bool are_alike(std::size_t a, std::size_t b) const {
    if (!come_after_each_other(a, b)) return false;
    if (shapes_[a].is_steady && shapes_[b].is_steady &&
        ratio(shapes_[a].speed_rad_s, shapes_[b].speed_rad_s) < least_speed_ratio) {
      return false;
    }
    return ratio(std::abs(family_[a].travel_rad), std::abs(family_[b].travel_rad)) >= least_ratio &&
           ratio(seconds(family_[a]), seconds(family_[b])) >= least_ratio;
  }

  [[nodiscard]] StrokeGroup group(std::size_t first, std::size_t end) const {
    StrokeGroup result;
    std::size_t steady = 0;
    for (std::size_t k = first; k < end; ++k) {
      result.strokes.push_back(family_[k]);
      result.shapes.push_back(shapes_[k]);
      if (shapes_[k].is_steady) ++steady;
    }
    result.is_steady = 2 * steady > end - first;
    return result;
  }

  /// Whether stroke k, beside the group [first, end), is a part of its motion.
  [[nodiscard]] bool is_part_of(std::size_t k, std::size_t first, std::size_t end) const {
    const StrokeGroup whole = group(first, end);
    const double share = std::abs(family_[k].travel_rad) / whole.travel_rad();
    if (share > 1) return false;
    const bool begins_narrow_oscillation = k < first && end - first >= 3 &&
                                           whole.travel_rad() <= widest_oscillation_rad_ &&
                                           !family_[k].follows_on;
    return begins_narrow_oscillation ||
           (share >= least_part_stroke && end - first >= 2 && !whole.is_steady);
  }

  void take_part_strokes() {
    const auto is_single = [&](std::size_t g) {
      return g + 1 < ends_.size() && ends_[g + 1] - ends_[g] == 1;
    };
    for (std::size_t g = 0; g + 1 < ends_.size(); ++g) {
      const std::size_t first = ends_[g];
      const std::size_t end = ends_[g + 1];
      if (end - first < 2) continue;
      if (is_single(g + 1) && family_[end].follows_on && is_part_of(end, first, end)) {
        ++ends_[g + 1];
      }
      if (g > 0 && is_single(g - 1) && family_[first].follows_on &&
          is_part_of(first - 1, first, end)) {
        --ends_[g];
      }
    }
  }

  /// A chain of strokes without rest of which no group holds the most.
  static void mark_irregular_chains(std::vector<StrokeGroup>& groups) {
    for (std::size_t g = 0; g < groups.size();) {
      std::size_t end = g + 1;
      while (end < groups.size() && groups[end].strokes.front().follows_on) ++end;
      std::size_t all = 0;
      std::size_t largest = 0;
      for (std::size_t k = g; k < end; ++k) {
        all += groups[k].strokes.size();
        if (!groups[k].is_steady) largest = std::max(largest, groups[k].strokes.size());
        if (groups[k].is_steady) largest = all;
      }
      const bool is_irregular =
          end - g > short_chain &&
          static_cast<double>(largest) < regular_share * static_cast<double>(all);
      for (; g < end; ++g) groups[g].is_irregular = is_irregular;
    }
  }

  const AngleTrace& trace_;
  const StrokeFamily& family_;
  double widest_oscillation_rad_;
  std::vector<StrokeShape> shapes_;
  std::vector<std::size_t> ends_;  ///< First stroke of each group, and the number of strokes.
};

}  // namespace

double StrokeGroup::travel_rad() const {
  std::vector<double> travels;
  for (const AngleStroke& stroke : strokes) travels.push_back(std::abs(stroke.travel_rad));
  return statistics::median(std::move(travels));
}

double StrokeGroup::speed_rad_s() const {
  std::vector<double> speeds;
  for (const StrokeShape& shape : shapes) speeds.push_back(shape.speed_rad_s);
  return statistics::median(std::move(speeds));
}

std::vector<StrokeGroup> group_strokes(const AngleTrace& trace, const StrokeFamily& family,
                                       double widest_oscillation_rad) {
  return Grouping(trace, family, widest_oscillation_rad).groups();
}

}  // namespace tribolog::inspect::motion
