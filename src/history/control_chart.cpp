#include "history/control_chart.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "base/requirements.h"
#include "statistics/distributions.h"

namespace tribolog::history {
namespace {

constexpr double limit_of_one = 9.3;
constexpr double wrongly_back = 1e-3;

/// Page's test of "back at the reference" against the change that was found.
class WayBack {
 public:
  WayBack(int direction, double found)
      : direction_(direction), found_(std::max(2 * cusum_allowance, found)) {}

  /// @return whether the values are back for good.
  bool add(std::size_t point, double score) {
    const double sum = sum_ + found_ / 2 - direction_ * score;
    if (sum_ == 0) first_ = point;
    sum_ = std::max(0.0, sum);
    return found_ * sum_ >= -std::log(wrongly_back);
  }
  [[nodiscard]] std::size_t first() const { return first_; }

 private:
  int direction_;
  double found_;  ///< Mean score of the change.
  double sum_{0};
  std::size_t first_{0};
};

class Charting {
 public:
  Charting(const std::vector<SeriesPoint>& series, const ChartSettings& settings)
      : series_(series), settings_(settings) {
    chart_.limit = cusum_limit(settings.watched);
  }

  ControlChart run() {
    const std::size_t learned = std::max(settings_.learned, fewest_learned);
    for (std::size_t k = 0; k < series_.size(); ++k) {
      chart_.points.emplace_back();
      if (members_.size() < learned) {
        members_.push_back(k);
      } else {
        judge(k);
      }
    }
    if (members_.size() >= fewest_learned) {
      leave_out_apart();
      chart_.reference = ReferenceLine::fitted(series_, members_, settings_.with_slope);
    }
    return std::move(chart_);
  }

 private:
  void judge(std::size_t k) {
    if (!way_back_ || !frozen_) {
      frozen_ = ReferenceLine::fitted(series_, members_, settings_.with_slope);
    }
    if (!frozen_) {
      members_.push_back(k);
      return;
    }
    ChartPoint& point = chart_.points[k];
    point.is_judged = true;
    const double score = score_of(k, *frozen_);
    point.is_apart = is_apart(k, score);
    point.score = std::clamp(score, -largest_score, largest_score);
    add_to_sums(k, point);
    if (way_back_) {
      if (way_back_->add(k, point.score)) end_excursion(k);
      return;
    }
    members_.push_back(k);
    if (above_ >= chart_.limit) begin_excursion(k, 1, above_from_);
    if (below_ >= chart_.limit) begin_excursion(k, -1, below_from_);
  }

  /// Held against those before it that do not stand apart themselves. The sums learn from all: a
  /// joint whose calibrations are wild now and then has no alarm of them.
  [[nodiscard]] bool is_apart(std::size_t k, double score_among_all) const {
    std::vector<std::size_t> others;
    std::copy_if(members_.begin(), members_.end(), std::back_inserter(others),
                 [&](std::size_t i) { return !chart_.points[i].is_apart; });
    if (others.size() == members_.size()) return std::abs(score_among_all) >= apart_score;
    const auto reference = ReferenceLine::fitted(series_, others, settings_.with_slope);
    return reference && std::abs(score_of(k, *reference)) >= apart_score;
  }

  [[nodiscard]] double score_of(std::size_t k, const ReferenceLine& reference) const {
    return statistics::normal_score(reference.standardised(series_[k]), reference.freedom);
  }

  /// Of the reference, where they are few; where they are many, that is how the joint scatters.
  void leave_out_apart() {
    constexpr double most_apart = 0.25;
    const auto apart =
        static_cast<double>(std::count_if(members_.begin(), members_.end(), [&](std::size_t i) {
          return chart_.points[i].is_apart;
        }));
    if (apart > most_apart * static_cast<double>(members_.size())) {
      for (ChartPoint& point : chart_.points) point.is_apart = false;
      return;
    }
    std::erase_if(members_, [&](std::size_t i) { return chart_.points[i].is_apart; });
  }

  void add_to_sums(std::size_t k, ChartPoint& point) {
    const auto add = [&](double score, double& sum, std::size_t& from) {
      if (sum == 0) from = k;
      sum = std::clamp(sum + score - cusum_allowance, 0.0, 2 * chart_.limit);
    };
    add(point.score, above_, above_from_);
    add(-point.score, below_, below_from_);
    point.above = above_;
    point.below = below_;
  }

  /// Of the calibrations from `from` on, the one from which on a shift is likeliest: by their
  /// whole distances from what was before, of which a score counts no more than 4.
  [[nodiscard]] std::size_t likeliest_start(const ReferenceLine& before, std::size_t from,
                                            std::size_t alarm) const {
    double sum = 0;
    double most = -1;
    std::size_t start = alarm;
    for (std::size_t i = alarm + 1; i-- > from;) {
      sum += before.standardised(series_[i]);
      const double likelihood = sum * sum / static_cast<double>(alarm - i + 1);
      if (likelihood <= most) continue;
      most = likelihood;
      start = i;
    }
    return start;
  }

  void begin_excursion(std::size_t k, int direction, std::size_t left_zero) {
    members_.erase(std::lower_bound(members_.begin(), members_.end(), left_zero), members_.end());
    const auto before = ReferenceLine::fitted(series_, members_, settings_.with_slope);
    const std::size_t start = before ? likeliest_start(*before, left_zero, k) : left_zero;
    for (std::size_t i = left_zero; i < start; ++i) members_.push_back(i);
    chart_.excursions.push_back({direction, start, k, std::nullopt});
    double sum = 0;
    for (std::size_t i = start; i <= k; ++i) sum += direction * chart_.points[i].score;
    way_back_.emplace(direction, sum / static_cast<double>(k - start + 1));
    frozen_ = ReferenceLine::fitted(series_, members_, settings_.with_slope);
  }

  void end_excursion(std::size_t k) {
    const std::size_t back = present(way_back_).first();
    chart_.excursions.back().back = back;
    for (std::size_t i = back; i <= k; ++i) members_.push_back(i);
    way_back_.reset();
    above_ = below_ = 0;
    // The sums begin again with the first that is back.
    for (std::size_t i = back; i <= k; ++i) {
      chart_.points[i].above = chart_.points[i].below = 0;
    }
  }

  const std::vector<SeriesPoint>& series_;
  const ChartSettings& settings_;
  ControlChart chart_;
  std::vector<std::size_t> members_;  ///< Of the reference.
  std::optional<ReferenceLine> frozen_;
  std::optional<WayBack> way_back_;  ///< While an excursion lasts.
  double above_{0};
  double below_{0};
  std::size_t above_from_{0};
  std::size_t below_from_{0};
};

}  // namespace

double cusum_limit(std::size_t watched) {
  return limit_of_one + std::log(static_cast<double>(std::max<std::size_t>(watched, 1)));
}

std::size_t ControlChart::judged() const {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const ChartPoint& p) { return p.is_judged; }));
}

const Excursion* ControlChart::warning() const {
  const bool stands = !excursions.empty() && !excursions.back().back;
  return stands ? &excursions.back() : nullptr;
}

ControlChart make_control_chart(const std::vector<SeriesPoint>& series,
                                const ChartSettings& settings) {
  return Charting(series, settings).run();
}

}  // namespace tribolog::history
