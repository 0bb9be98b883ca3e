#include "inspect/motion/angle_trace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>

#include "method/motion/encoder_resolution.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

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

TravelBetweenTurns::TravelBetweenTurns(const AngleTrace& trace, std::size_t first, std::size_t last)
    : trace_(&trace),
      first_(first),
      last_(last),
      sign_(trace.q_rad[last] < trace.q_rad[first] ? -1.0 : 1.0) {}

double TravelBetweenTurns::largest_wiggle_rad() const {
  double furthest = 0;
  double wiggle = 0;
  for (std::size_t i = first_; i <= last_; ++i) {
    furthest = std::max(furthest, at(i));
    wiggle = std::max(wiggle, furthest - at(i));
  }
  return wiggle;
}

std::vector<std::size_t> TravelBetweenTurns::passages(double band_rad) const {
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

namespace {

constexpr double steps = 3;
constexpr double deviations = 5;
constexpr double curvature_share = 1e-4;
/// Correlation of neighbouring differences: -0.5 of white noise, positive of motion.
constexpr double largest_correlation_of_noise = -0.25;
constexpr std::size_t samples_in_window = 64;
/// From this share of equal neighbours on a signal comes in steps, though not in whole ones.
constexpr double least_share_of_equals = 0.1;
/// Fewer changes between standing and moving, in shares of the samples, are starts of motions.
constexpr double fewest_changes = 0.01;

struct Window {
  double squares{};  ///< Of neighbouring differences.
  double products{};
  double sd{};
};

Window window_of(const std::vector<double>& signal, std::size_t first, std::size_t end) {
  Window window;
  for (std::size_t i = first + 2; i < end; ++i) {
    const double before = signal[i - 1] - signal[i - 2];
    const double here = signal[i] - signal[i - 1];
    window.squares += (before * before + here * here) / 2;
    window.products += before * here;
  }
  window.sd = statistics::white_sd_beside_jumps(
      statistics::third_differences({signal.begin() + static_cast<std::ptrdiff_t>(first),
                                     signal.begin() + static_cast<std::ptrdiff_t>(end)}));
  return window;
}

double white_floor(const std::vector<double>& signal) {
  std::vector<Window> windows;
  for (std::size_t first = 0; first == 0 || first + samples_in_window <= signal.size();
       first += samples_in_window) {
    windows.push_back(window_of(signal, first, std::min(first + samples_in_window, signal.size())));
  }
  std::sort(windows.begin(), windows.end(),
            [](const Window& a, const Window& b) { return a.squares < b.squares; });
  windows.resize((windows.size() + 3) / 4);
  Window quiet;
  std::vector<double> deviations_seen;
  for (const Window& window : windows) {
    quiet.squares += window.squares;
    quiet.products += window.products;
    deviations_seen.push_back(window.sd);
  }
  const double floor = deviations * statistics::median(std::move(deviations_seen));
  if (quiet.products < largest_correlation_of_noise * quiet.squares) return floor;
  const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
  return std::min(floor, curvature_share * (*high - *low));
}

/// The smaller steps with which a signal that often stands leaves its stand or comes to it; 0 where
/// it hardly ever stands.
double step_from_stand(const std::vector<double>& signal) {
  std::vector<double> steps_seen;
  std::size_t equals = 0;
  for (std::size_t i = 2; i < signal.size(); ++i) {
    const double before = std::abs(signal[i - 1] - signal[i - 2]);
    const double here = std::abs(signal[i] - signal[i - 1]);
    if (here == 0) ++equals;
    if ((here == 0) != (before == 0)) steps_seen.push_back(std::max(here, before));
  }
  const double fewest = std::max(10.0, fewest_changes * static_cast<double>(signal.size()));
  if (static_cast<double>(steps_seen.size()) < fewest ||
      static_cast<double>(equals) < least_share_of_equals * static_cast<double>(signal.size())) {
    return 0;
  }
  const auto small = steps_seen.begin() + static_cast<std::ptrdiff_t>(steps_seen.size() / 4);
  std::nth_element(steps_seen.begin(), small, steps_seen.end());
  return *small;
}

}  // namespace

double noise_floor(const std::vector<double>& signal) {
  if (signal.size() < 4) return 0;
  return std::max(white_floor(signal),
                  steps * std::max(method::motion::common_step(signal), step_from_stand(signal)));
}

}  // namespace tribolog::inspect::motion
