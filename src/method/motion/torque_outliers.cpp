#include "method/motion/torque_outliers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "method/motion/encoder_resolution.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::motion {
namespace {

constexpr std::size_t beside = 3;        // neighbours on either side that a sample is compared with
constexpr std::size_t beside_scale = 7;  // those that tell the scale

/// Median of the samples about i, `half` on either side.
double median_about(const std::vector<double>& y, std::size_t i, std::size_t half) {
  std::array<double, 2 * beside_scale + 1> window{};
  const auto end = std::copy(y.begin() + static_cast<std::ptrdiff_t>(i - half),
                             y.begin() + static_cast<std::ptrdiff_t>(i + half + 1), window.begin());
  const auto middle = window.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(window.begin(), middle, end);
  return *middle;
}

double deviation_about(const std::vector<double>& y, std::size_t i, double median) {
  std::array<double, 2 * beside_scale + 1> window{};
  for (std::size_t k = 0; k < window.size(); ++k) {
    window[k] = std::abs(y[i - beside_scale + k] - median);
  }
  std::nth_element(window.begin(), window.begin() + beside_scale, window.end());
  return statistics::normal_sd_by_median_size * window[beside_scale];
}

/// Whether the joint accelerates or decelerates unusually about a sample: its torque may then well
/// be a genuine spike.
class RareMotion {
 public:
  explicit RareMotion(const std::vector<double>& q_rad) : q_(q_rad) {
    std::vector<double> changes;
    std::vector<double> paths;
    for (std::size_t i = beside_scale; i + beside_scale < q_.size(); ++i) {
      changes.push_back(std::abs(change(i)));
      paths.push_back(std::abs(q_[i + beside] - q_[i - beside]));
    }
    constexpr double rare = 5 * statistics::normal_sd_by_median_size;
    constexpr double steady = 0.01;  // of the path
    // A second difference of rounded angles is up to two steps off.
    constexpr double rounding = 2.5;
    rare_ = std::max({rare * statistics::median(std::move(changes)),
                      steady * statistics::median(std::move(paths)), rounding * common_step(q_)});
  }
  [[nodiscard]] bool at(std::size_t i) const {
    for (std::size_t k = i - beside; k <= i + beside; ++k) {
      if (std::abs(change(k)) > rare_) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] double change(std::size_t i) const {
    return q_[i + beside] - 2 * q_[i] + q_[i - beside];
  }
  const std::vector<double>& q_;
  double rare_{};
};

struct UsualTorque {
  double low_Nm;   ///< 5th percentile,
  double high_Nm;  ///< and 95th.
  [[nodiscard]] double range_Nm() const { return high_Nm - low_Nm; }
  /// Of a run at constant speed the range is small: a start from rest changes the torque by all of
  /// it, a reversal by twice of that.
  [[nodiscard]] double size_Nm() const {
    return std::max({range_Nm(), std::abs(low_Nm), std::abs(high_Nm)});
  }
};

UsualTorque usual_torque(std::vector<double> y) {
  const auto at = [&](double share) {
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(y.size() - 1));
    std::nth_element(y.begin(), y.begin() + k, y.end());
    return y[static_cast<std::size_t>(k)];
  };
  const double high = at(0.95);
  return {at(0.05), high};
}

/// Samples that no motion makes, wherever they are: as of bytes that were read wrongly.
std::vector<std::size_t> impossible_samples(const std::vector<double>& y, double size_Nm) {
  constexpr double beyond = 4;  // times the recording's usual torque
  std::vector<std::size_t> found;
  if (y.size() < 2 * beside + 1 || !(size_Nm > 0)) return found;
  const auto [least, most] = std::minmax_element(y.begin(), y.end());
  if (*most - *least <= beyond * size_Nm) return found;  // none is so far from any other
  for (std::size_t i = 0; i < y.size(); ++i) {
    const std::size_t about = std::clamp(i, beside, y.size() - 1 - beside);
    if (std::abs(y[i] - median_about(y, about, beside)) > beyond * size_Nm) found.push_back(i);
  }
  return found;
}

}  // namespace

std::vector<std::size_t> torque_outliers(const joint::Recording& recording) {
  constexpr double far_off = 8;          // in standard deviations: one in 1e15
  constexpr double least_share = 0.005;  // of the torque's usual range
  constexpr double most_share = 0.1;     // more of them are no outliers
  constexpr std::size_t fewest_samples = 50;
  const std::vector<double>& y = recording.torque_Nm;
  if (y.empty() || y.size() != recording.size()) return {};
  const UsualTorque usual = usual_torque(y);
  std::vector<std::size_t> out = impossible_samples(y, usual.size_Nm());
  const auto are_few = [&] {
    return static_cast<double>(out.size()) <= most_share * static_cast<double>(y.size());
  };
  if (!are_few()) return {};
  if (y.size() < fewest_samples) return out;
  const std::vector<std::size_t> impossible = out;
  const double noise = statistics::white_sd_beside_jumps(statistics::third_differences(y));
  out.clear();
  const double least = std::max(far_off * noise, least_share * usual.range_Nm());
  // Four of six neighbours lie beyond the median: of any three one does.
  const auto may_be_one = [&](std::size_t i) {
    return std::abs(y[i] - y[i - 3]) > least || std::abs(y[i] - y[i - 1]) > least ||
           std::abs(y[i] - y[i + 2]) > least;
  };
  for (std::size_t i = beside_scale; i + beside_scale < y.size(); ++i) {
    if (!may_be_one(i)) continue;
    const double median = median_about(y, i, beside);
    const double off = std::abs(y[i] - median);
    if (!(off > least)) continue;
    if (off > far_off * deviation_about(y, i, median_about(y, i, beside_scale))) out.push_back(i);
  }
  if (out.empty()) return impossible;
  const RareMotion motion(recording.q_rad);
  std::erase_if(out, [&](std::size_t i) { return motion.at(i); });
  // A torque in coarse steps flickers between two of them.
  constexpr double flicker = 1.5;
  const double step = common_step(y);
  if (step > 0) {
    std::erase_if(out, [&](std::size_t i) {
      return std::abs(y[i] - median_about(y, i, beside)) < flicker * step;
    });
  }
  std::vector<std::size_t> all;
  std::set_union(out.begin(), out.end(), impossible.begin(), impossible.end(),
                 std::back_inserter(all));
  out = std::move(all);
  return are_few() ? out : impossible;
}

TorqueOutliers replace_torque_outliers(std::vector<joint::Recording>& recordings) {
  TorqueOutliers found;
  for (joint::Recording& r : recordings) {
    const std::vector<std::size_t> outliers = torque_outliers(r);
    if (outliers.empty()) continue;
    found.replaced += outliers.size();
    const double percent =
        100 * static_cast<double>(outliers.size()) / static_cast<double>(r.size());
    if (percent > found.worst_percent) {
      found.worst_percent = percent;
      found.recording = r.name;
    }
    for (std::size_t k = 0; k < outliers.size();) {
      std::size_t last = k;
      while (last + 1 < outliers.size() && outliers[last + 1] == outliers[last] + 1) ++last;
      // At the recording's end only one neighbour is there.
      const std::size_t behind =
          outliers[last] + 1 < r.size() ? outliers[last] + 1 : outliers[k] - 1;
      const std::size_t before = outliers[k] > 0 ? outliers[k] - 1 : behind;
      for (std::size_t i = outliers[k]; i <= outliers[last]; ++i) {
        const double share =
            before == behind ? 0 : (r.t_s[i] - r.t_s[before]) / (r.t_s[behind] - r.t_s[before]);
        const double line = std::lerp(r.torque_Nm[before], r.torque_Nm[behind], share);
        found.largest_Nm = std::max(found.largest_Nm, std::abs(r.torque_Nm[i] - line));
        r.torque_Nm[i] = line;
      }
      k = last + 1;
    }
  }
  return found;
}

}  // namespace tribolog::method::motion
