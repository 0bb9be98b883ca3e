#include "report/review/kept_samples.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace tribolog::report {
namespace {

using Signals = std::vector<const std::vector<double>*>;

struct Scaled {
  const std::vector<double>* values;
  double span;
};

/// Marks where the smallest and the largest are; returns the signals that vary at all.
std::vector<Scaled> varying(const Signals& signals, std::vector<bool>& stays) {
  std::vector<Scaled> out;
  for (const std::vector<double>* signal : signals) {
    std::size_t low = signal->size();
    std::size_t high = low;
    for (std::size_t i = 0; i < signal->size(); ++i) {
      const double value = (*signal)[i];
      if (!std::isfinite(value)) continue;
      if (low == signal->size() || value < (*signal)[low]) low = i;
      if (high == signal->size() || value > (*signal)[high]) high = i;
    }
    if (low == signal->size()) continue;
    stays[low] = stays[high] = true;
    const double span = (*signal)[high] - (*signal)[low];
    if (span > 0.0) out.push_back({signal, span});
  }
  return out;
}

/// Samples in a list from which the least needed one is taken out at a time.
class ThinnedLine {
 public:
  ThinnedLine(const std::vector<double>& t, std::vector<Scaled> signals, std::vector<bool> stays)
      : t_(t), signals_(std::move(signals)), stays_(std::move(stays)), weight_(t.size()) {
    for (std::size_t i = 0; i < t.size(); ++i) {
      before_.push_back(i == 0 ? 0 : i - 1);
      after_.push_back(i + 1);
    }
    for (std::size_t i = 0; i < t.size(); ++i) weigh(i, 0.0);
  }

  /// @return false if every sample that is left has to stay.
  bool take_least() {
    while (!queue_.empty()) {
      const auto [weight, i] = queue_.top();
      queue_.pop();
      if (weight != weight_[i]) continue;  // weighed again since
      const std::size_t a = before_[i];
      const std::size_t b = after_[i];
      weight_[i] = std::numeric_limits<double>::quiet_NaN();
      after_[a] = b;
      before_[b] = a;
      // What was harder to replace than a sample that went stays harder.
      weigh(a, weight);
      weigh(b, weight);
      return true;
    }
    return false;
  }

  [[nodiscard]] std::vector<std::size_t> left() const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < t_.size(); i = after_[i]) out.push_back(i);
    return out;
  }

 private:
  void weigh(std::size_t i, double at_least) {
    if (stays_[i]) return;
    const std::size_t a = before_[i];
    const std::size_t b = after_[i];
    const double share = (t_[i] - t_[a]) / (t_[b] - t_[a]);
    double worst = at_least;
    for (const auto& [values, span] : signals_) {
      const std::vector<double>& y = *values;
      const double miss = std::abs(y[i] - y[a] - share * (y[b] - y[a])) / span;
      if (miss > worst) worst = miss;
    }
    weight_[i] = worst;
    queue_.push({worst, i});
  }

  using Entry = std::pair<double, std::size_t>;
  const std::vector<double>& t_;
  std::vector<Scaled> signals_;
  std::vector<bool> stays_;
  std::vector<double> weight_;
  std::vector<std::size_t> before_;
  std::vector<std::size_t> after_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

std::vector<std::size_t> kept_samples(const std::vector<double>& t, const Signals& signals,
                                      const std::vector<std::size_t>& needed, std::size_t most) {
  if (t.empty()) return {};
  std::vector<bool> stays(t.size(), false);
  stays.front() = stays.back() = true;
  for (const std::size_t i : needed) stays[i] = true;
  std::vector<Scaled> scaled = varying(signals, stays);
  ThinnedLine line(t, std::move(scaled), std::move(stays));
  for (std::size_t size = t.size(); size > most; --size) {
    if (!line.take_least()) break;
  }
  return line.left();
}

}  // namespace tribolog::report
