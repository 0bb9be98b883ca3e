#include "method/viscous/speed_means.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tribolog::method::viscous {
namespace {

constexpr double least_error = 2e-4;  // of the friction

/// What one direction of a speed has.
struct DirectionMean {
  double friction{};
  double variance{};
  double count{};
  void add(const CurveSample& s, double its_variance) {
    friction = (count * friction + s.friction_Nm) / (count + 1);
    variance += its_variance;
    count += 1;
  }
  [[nodiscard]] double variance_of_mean() const { return variance / (count * count); }
};

/// Half the difference of rising and falling friction, for speeds with one direction only: the mean
/// over speeds with both, or a line in speed where the terms have one.
class Asymmetries {
 public:
  void add(double speed, double half) {
    ++n_;
    w_ += speed;
    h_ += half;
    ww_ += speed * speed;
    wh_ += speed * half;
  }
  [[nodiscard]] double at(double speed, bool line) const {
    if (n_ == 0) return 0;
    const double spread = n_ * ww_ - w_ * w_;
    if (!line || n_ < 3 || !(spread > 0)) return h_ / n_;
    const double slope = (n_ * wh_ - w_ * h_) / spread;
    return (h_ - slope * w_) / n_ + slope * speed;
  }

 private:
  double n_{}, w_{}, h_{}, ww_{}, wh_{};
};

/// Variances of the runs' means, from ten blocks each, are themselves known only to a third, and
/// weights must not depend on that: each is shrunk towards the common value for its number of
/// samples, the more so the less they differ (empirical Bayes, Smyth 2004).
std::vector<double> variances_of(const std::vector<CurveSample>& samples) {
  constexpr double freedom = 9;
  std::vector<double> logs;
  for (const CurveSample& s : samples) {
    if (s.standard_error_Nm > 0 && s.count > 0) {
      logs.push_back(std::log(s.standard_error_Nm * s.standard_error_Nm * s.count));
    }
  }
  std::vector<double> out;
  if (logs.size() < 3) {
    for (const CurveSample& s : samples) out.push_back(std::pow(s.standard_error_Nm, 2));
    return out;
  }
  double mean = 0;
  for (const double l : logs) mean += l / static_cast<double>(logs.size());
  double spread = 0;
  for (const double l : logs) {
    spread += (l - mean) * (l - mean) / static_cast<double>(logs.size() - 1);
  }
  // Of the logarithm of a chi-squared number: its variance, and its mean.
  const double own = 2 / freedom * (1 + 1 / freedom);
  const double common = std::exp(mean + 1 / freedom);
  const double weight = spread > own ? 2 / (spread - own) : std::numeric_limits<double>::infinity();
  for (const CurveSample& s : samples) {
    const double its = std::pow(s.standard_error_Nm, 2);
    const double shared = s.count > 0 ? common / s.count : its;
    if (!(its > 0)) {
      out.push_back(shared);
    } else {
      out.push_back(std::isinf(weight) ? shared
                                       : (weight * shared + freedom * its) / (weight + freedom));
    }
  }
  return out;
}

/// No mean is better known than motion and method allow.
void floor_variances(std::vector<FrictionAtSpeed>& speeds) {
  double largest = 0;
  for (const FrictionAtSpeed& s : speeds) largest = std::max(largest, std::abs(s.mean.friction_Nm));
  for (FrictionAtSpeed& s : speeds) {
    s.mean.variance +=
        std::pow(least_error * std::abs(s.mean.friction_Nm), 2) + std::pow(1e-6 * largest, 2);
  }
}

}  // namespace

std::vector<FrictionAtSpeed> speeds_of(const std::vector<CurveSample>& samples,
                                       const CurveModel& terms) {
  struct Group {
    DirectionMean rising, falling;
    double speed{}, load{}, count{};
    std::vector<std::size_t> runs;
  };
  std::vector<Group> groups(group_count(samples));
  const std::vector<double> variances = variances_of(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const CurveSample& s = samples[i];
    Group& g = groups[s.group];
    (s.direction < 0 ? g.falling : g.rising).add(s, variances[i]);
    g.speed += s.speed_rad_s;
    g.load += s.load;
    g.count += 1;
    g.runs.push_back(s.run);
  }
  Asymmetries halves;
  for (const Group& g : groups) {
    if (g.rising.count == 0 || g.falling.count == 0) continue;
    halves.add(g.speed / g.count, (g.rising.friction - g.falling.friction) / 2);
  }
  std::vector<FrictionAtSpeed> speeds;
  for (Group& g : groups) {
    FrictionAtSpeed s;
    s.mean.speed_rad_s = g.speed / g.count;
    s.mean.load = g.load / g.count;
    if (g.rising.count > 0 && g.falling.count > 0) {
      s.has_both = true;
      s.half_difference = (g.rising.friction - g.falling.friction) / 2;
      s.mean.friction_Nm = (g.rising.friction + g.falling.friction) / 2;
      s.mean.variance = (g.rising.variance_of_mean() + g.falling.variance_of_mean()) / 4;
    } else {
      const bool is_rising = g.rising.count > 0;
      const DirectionMean& one = is_rising ? g.rising : g.falling;
      const double half =
          halves.at(s.mean.speed_rad_s, terms.asymmetry == Asymmetry::coulomb_viscous);
      s.mean.friction_Nm = one.friction - (is_rising ? half : -half);
      s.mean.variance = one.variance_of_mean();
    }
    s.runs = std::move(g.runs);
    speeds.push_back(std::move(s));
  }
  floor_variances(speeds);
  return speeds;
}

std::vector<SpeedMean> means_of(const std::vector<FrictionAtSpeed>& speeds, std::size_t without) {
  std::vector<SpeedMean> means;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (i != without) means.push_back(speeds[i].mean);
  }
  return means;
}

}  // namespace tribolog::method::viscous
