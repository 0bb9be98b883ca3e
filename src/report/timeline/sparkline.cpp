#include "report/timeline/sparkline.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace tribolog::report::timeline {
namespace {

constexpr int margin = 5;

/// From values to places, with room at the edges for the dot.
class SparkAxis {
 public:
  SparkAxis(double low, double high, int from, int to)
      : low_(low), size_(high - low), from_(from), to_(to) {}
  [[nodiscard]] int at(double value) const {
    const double share = size_ > 0 ? std::clamp((value - low_) / size_, 0.0, 1.0) : 0.5;
    return static_cast<int>(std::lround(from_ + share * (to_ - from_)));
  }

 private:
  double low_;
  double size_;
  int from_;
  int to_;
};

SparkAxis height_axis(const history::FleetCell& cell, double band_half) {
  const statistics::Estimate& latest = cell.results.back().estimate;
  double low = latest.low;
  double high = latest.high;
  const auto hold = [&](double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const history::PastResult& past : cell.results) hold(past.estimate.value);
  if (cell.to_history) {
    hold(cell.to_history->median - band_half);
    hold(cell.to_history->median + band_half);
  }
  return {low, high, sparkline_height - margin, margin};
}

}  // namespace

Sparkline sparkline_of(const history::FleetCell& cell, const history::Fleet& fleet) {
  Sparkline line;
  const double band_half = cell.to_history ? fleet.limit * cell.to_history->scatter : 0;
  const SparkAxis x(fleet.first_s, fleet.last_s, margin, sparkline_width - margin);
  const SparkAxis y = height_axis(cell, band_half);
  if (cell.to_history) {
    const int top = y.at(cell.to_history->median + band_half);
    const int bottom = y.at(cell.to_history->median - band_half);
    line.band = fmt::format("M0 {}h{}v{}H0z", top, sparkline_width, std::max(bottom - top, 1));
  }
  if (cell.to_others) {
    line.others = fmt::format("M0 {}h{}", y.at(cell.to_others->median), sparkline_width);
  }
  for (const history::PastResult& past : cell.results) {
    line.history += fmt::format("{}{} {}", line.history.empty() ? "M" : " ", x.at(past.time_s),
                                y.at(past.estimate.value));
  }
  const history::PastResult& latest = cell.results.back();
  const int where = x.at(latest.time_s);
  line.history +=
      fmt::format("M{} {}V{}", where, y.at(latest.estimate.low), y.at(latest.estimate.high));
  line.latest = fmt::format("M{} {}h0", where, y.at(latest.estimate.value));
  return line;
}

}  // namespace tribolog::report::timeline
