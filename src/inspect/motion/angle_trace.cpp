#include "inspect/motion/angle_trace.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace tribolog::inspect::motion {

std::vector<std::size_t> turning_points(const std::vector<double>& signal, std::size_t first,
                                        std::size_t last, double threshold) {
  std::vector<std::size_t> points;
  std::size_t lowest = first;
  std::size_t highest = first;
  std::size_t i = first;
  for (; i <= last; ++i) {
    if (signal[i] < signal[lowest]) lowest = i;
    if (signal[i] > signal[highest]) highest = i;
    if (signal[highest] - signal[lowest] >= threshold) break;
  }
  if (i > last) return points;
  double direction = lowest < highest ? 1 : -1;
  points.push_back(direction > 0 ? lowest : highest);
  std::size_t extreme = i;
  for (; i <= last; ++i) {
    const double beyond = direction * (signal[i] - signal[extreme]);
    if (beyond > 0) extreme = i;
    if (beyond > -threshold) continue;
    points.push_back(extreme);
    extreme = i;
    direction = -direction;
  }
  points.push_back(extreme);
  return points;
}

namespace {

/// Largest and smallest value of a window that moves on, by the classic pair of monotone queues.
class WindowSpread {
 public:
  explicit WindowSpread(const std::vector<double>& signal) : signal_(signal) {}
  void enter(std::size_t i) {
    while (!highs_.empty() && signal_[highs_.back()] <= signal_[i]) highs_.pop_back();
    while (!lows_.empty() && signal_[lows_.back()] >= signal_[i]) lows_.pop_back();
    highs_.push_back(i);
    lows_.push_back(i);
  }
  void leave(std::size_t i) {
    if (highs_.front() == i) highs_.pop_front();
    if (lows_.front() == i) lows_.pop_front();
  }
  [[nodiscard]] double spread() const { return signal_[highs_.front()] - signal_[lows_.front()]; }

 private:
  const std::vector<double>& signal_;
  std::deque<std::size_t> highs_;
  std::deque<std::size_t> lows_;
};

/// Goes through `count` samples from `start` on, forward or backward.
std::optional<std::size_t> find(const std::vector<double>& t_s, const std::vector<double>& signal,
                                const QuietSearch& search, bool forward) {
  const std::size_t count = search.to - search.from + 1;
  const auto sample = [&](std::size_t k) { return forward ? search.from + k : search.to - k; };
  WindowSpread window(signal);
  std::size_t end = 0;
  for (std::size_t k = 0; k < count; ++k) {
    while (end < count &&
           (end == k || std::abs(t_s[sample(end - 1)] - t_s[sample(k)]) < search.window_s)) {
      window.enter(sample(end++));
    }
    if (std::abs(t_s[sample(end - 1)] - t_s[sample(k)]) < search.window_s) return std::nullopt;
    if (window.spread() <= search.tolerance) return sample(k);
    window.leave(sample(k));
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> first_quiet(const std::vector<double>& t_s,
                                       const std::vector<double>& signal,
                                       const QuietSearch& search) {
  return find(t_s, signal, search, true);
}

std::optional<std::size_t> last_quiet(const std::vector<double>& t_s,
                                      const std::vector<double>& signal,
                                      const QuietSearch& search) {
  return find(t_s, signal, search, false);
}

Way::Way(const AngleTrace& trace, std::size_t first, std::size_t last)
    : trace_(&trace),
      first_(first),
      last_(last),
      sign_(trace.q_rad[last] < trace.q_rad[first] ? -1.0 : 1.0) {}

double Way::largest_wiggle_rad() const {
  double furthest = 0;
  double wiggle = 0;
  for (std::size_t i = first_; i <= last_; ++i) {
    furthest = std::max(furthest, at(i));
    wiggle = std::max(wiggle, furthest - at(i));
  }
  return wiggle;
}

std::vector<std::size_t> Way::passages(double band_rad) const {
  std::vector<std::size_t> reached{first_};
  double next = band_rad;
  for (std::size_t i = first_; i < last_; ++i) {
    while (at(i) >= next && next < travel_rad()) {
      reached.push_back(i);
      next += band_rad;
    }
  }
  reached.push_back(last_);
  return reached;
}

}  // namespace tribolog::inspect::motion
