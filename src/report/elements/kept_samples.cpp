#include "report/elements/kept_samples.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace tribolog::report::elements {

std::vector<double> picked(const std::vector<double>& signal, const std::vector<std::size_t>& at) {
  std::vector<double> out;
  out.reserve(at.size());
  for (const std::size_t i : at) out.push_back(signal[i]);
  return out;
}
namespace {

using Signals = std::vector<const std::vector<double>*>;

struct Scaled {
  const std::vector<double>* values;
  double span;
};

constexpr std::size_t long_recording = 100;  // times what is to be kept
constexpr std::size_t parts_per_kept = 5;

/// Where the smallest and the largest finite values in [from, to) are; `to` if there are none.
std::pair<std::size_t, std::size_t> extremes(const std::vector<double>& signal, std::size_t from,
                                             std::size_t to) {
  std::size_t low = to;
  std::size_t high = to;
  for (std::size_t i = from; i < to; ++i) {
    if (!std::isfinite(signal[i])) continue;
    if (low == to || signal[i] < signal[low]) low = i;
    if (high == to || signal[i] > signal[high]) high = i;
  }
  return {low, high};
}

/// Marks where the smallest and the largest are; returns the signals that vary at all.
std::vector<Scaled> varying(const Signals& signals, std::vector<bool>& stays) {
  std::vector<Scaled> out;
  for (const std::vector<double>* signal : signals) {
    const auto [low, high] = extremes(*signal, 0, signal->size());
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

/// Weighing every sample of an hour's log would take its time and memory: of each of so many parts
/// the smallest and the largest of each signal, and what is needed.
std::vector<std::size_t> extremes_of_parts(std::size_t size, const Signals& signals,
                                           std::vector<std::size_t> needed, std::size_t parts) {
  for (std::size_t k = 0; k < parts; ++k) {
    const std::size_t from = size * k / parts;
    const std::size_t to = size * (k + 1) / parts;
    needed.push_back(from);
    for (const std::vector<double>* signal : signals) {
      const auto [low, high] = extremes(*signal, from, to);
      if (low < to) needed.insert(needed.end(), {low, high});
    }
  }
  needed.push_back(size - 1);
  std::sort(needed.begin(), needed.end());
  needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
  return needed;
}

/// The same question about fewer samples.
std::vector<std::size_t> kept_of_extremes(const std::vector<double>& t, const Signals& signals,
                                          const std::vector<std::size_t>& needed,
                                          std::size_t most) {
  const auto rough = extremes_of_parts(t.size(), signals, needed, parts_per_kept * most);
  std::vector<std::vector<double>> values;
  values.reserve(signals.size());
  for (const std::vector<double>* signal : signals) values.push_back(picked(*signal, rough));
  Signals fewer;
  for (const std::vector<double>& signal : values) fewer.push_back(&signal);
  std::vector<std::size_t> still_needed;
  for (const std::size_t i : needed) {
    const auto at = std::lower_bound(rough.begin(), rough.end(), i);
    still_needed.push_back(static_cast<std::size_t>(at - rough.begin()));
  }
  std::vector<std::size_t> kept = kept_samples(picked(t, rough), fewer, still_needed, most);
  for (std::size_t& i : kept) i = rough[i];
  return kept;
}

}  // namespace

std::vector<std::size_t> kept_samples(const std::vector<double>& t, const Signals& signals,
                                      const std::vector<std::size_t>& needed, std::size_t most) {
  if (t.empty()) return {};
  // Fewer than half of the samples are left for the second time, so that it ends.
  const std::size_t rest = needed.size() + 1 + parts_per_kept * most * (1 + 2 * signals.size());
  if (most > 0 && t.size() > long_recording * most && t.size() > 2 * rest) {
    return kept_of_extremes(t, signals, needed, most);
  }
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

std::vector<std::size_t> last_cycles(const std::vector<double>& t, double frequency_Hz,
                                     double cycles, std::size_t most) {
  std::size_t first = 0;
  if (frequency_Hz > 0) {
    const double from = t.back() - cycles / frequency_Hz;
    first = static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), from) - t.begin());
  }
  std::vector<std::size_t> kept;
  const std::size_t step = std::max<std::size_t>((t.size() - first + most - 1) / most, 1);
  for (std::size_t i = first; i < t.size(); i += step) kept.push_back(i);
  return kept;
}

}  // namespace tribolog::report::elements
