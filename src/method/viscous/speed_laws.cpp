#include "method/viscous/speed_laws.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::viscous {
namespace {

constexpr double stray = 0.01;         // after Holm's correction
constexpr double least_stray = 0.005;  // of the friction: what matters
constexpr double strays_per_speed = 0.2;

/// The scatter, squared, at which the weighted sum of squares equals its degrees of freedom.
/// @param largest friction.
template <class Leaves>
double root_of_scatter(const Leaves& leaves, double freedom, double largest) {
  if (leaves(0) <= freedom) return 0;
  double low = std::log(1e-14 * largest * largest);
  double high = std::log(largest * largest);
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (leaves(std::exp(middle)) > freedom ? low : high) = middle;
  }
  return std::exp((low + high) / 2);
}

}  // namespace

const LawPoint* best_of(const std::vector<LawPoint>& points) {
  const auto at = std::min_element(points.begin(), points.end(),
                                   [](const auto& a, const auto& b) { return a.chi2 < b.chi2; });
  return at == points.end() ? nullptr : &*at;
}

SpeedLaws::SpeedLaws(std::vector<SpeedMean> means, bool load)
    : means_(std::move(means)), load_(load) {
  slowest_ = fastest_ = means_.front().speed_rad_s;
  for (const SpeedMean& m : means_) {
    slowest_ = std::min(slowest_, m.speed_rad_s);
    fastest_ = std::max(fastest_, m.speed_rad_s);
    largest_ = std::max(largest_, std::abs(m.friction_Nm));
  }
}

LawGrid SpeedLaws::whole_grid() const {
  constexpr double below_slowest = 30;
  constexpr double beyond_fastest = 3;
  return {{exponent_}, {power_}, load_, slowest_ / below_slowest, beyond_fastest * fastest_};
}

std::vector<LawPoint> SpeedLaws::possible_lines(const std::vector<double>& powers) const {
  std::vector<LawPoint> out;
  for (const double power : powers) {
    LawPoint point = line(power);
    if (power == 1 || point.coulomb_Nm >= 0) out.push_back(point);
  }
  return out;
}

LawPoint SpeedLaws::best() const {
  const LawPoint straight = line(power_);
  if (!can_dip()) return straight;
  const std::optional<LawPoint> dip = best_law(whole_grid());
  return dip && dip->chi2 < straight.chi2 ? *dip : straight;
}

std::optional<LawPoint> SpeedLaws::best_law(LawGrid grid) const {
  std::optional<LawPoint> best;
  constexpr int rounds = 4;
  for (int k = 0; k < rounds; ++k) {
    const std::vector<LawPoint> points = scan(grid);
    const LawPoint* at = best_of(points);
    if (at == nullptr) break;
    if (!best || at->chi2 < best->chi2) best = *at;
    const double step = std::pow(grid.fastest_speed / grid.slowest_speed,
                                 2.0 / static_cast<double>(speeds_tried - 1));
    grid.slowest_speed = std::max(grid.slowest_speed, best->speed_rad_s / step);
    grid.fastest_speed = std::min(grid.fastest_speed, best->speed_rad_s * step);
  }
  return best;
}

void SpeedLaws::find_scatter() {
  scatter2_ = 0;
  constexpr int rounds = 3;
  const double freedom = best_freedom();
  if (!(freedom > 0)) return;
  for (int k = 0; k < rounds; ++k) {
    const LawPoint law = best();
    const auto leaves = [&](double scatter2) {
      if (!law.has_excess) return line_at(means_, scatter2, law.power, load_).chi2;
      const LawGrid one{{law.exponent}, {law.power}, load_, law.speed_rad_s, law.speed_rad_s};
      const std::vector<LawPoint> at = scan_laws(means_, scatter2, one, 2);
      return at.empty() ? 0.0 : at.front().chi2;
    };
    const double before = scatter2_;
    scatter2_ = root_of_scatter(leaves, freedom, largest_);
    if (std::abs(scatter2_ - before) <= 1e-3 * before) break;
  }
}

double direction_scatter2(const std::vector<FrictionAtSpeed>& speeds, double scatter2,
                          double freedom_of_scatter) {
  constexpr Eigen::Index terms = 3;
  std::vector<const FrictionAtSpeed*> both;
  double largest = 0;
  for (const FrictionAtSpeed& s : speeds) {
    if (!s.has_both) continue;
    both.push_back(&s);
    largest = std::max(largest, std::abs(s.mean.friction_Nm));
  }
  const auto n = static_cast<Eigen::Index>(both.size());
  const auto freedom = static_cast<double>(n - terms);
  if (freedom < 2) return 0;
  const auto leaves = [&](double scatter) {
    Eigen::MatrixXd x(n, terms);
    Eigen::VectorXd y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const FrictionAtSpeed& s = *both[static_cast<std::size_t>(i)];
      const double weight = 1 / std::sqrt(s.mean.variance + scatter);
      x.row(i) << weight, weight * s.mean.friction_Nm / largest, weight * s.mean.speed_rad_s;
      y(i) = weight * s.half_difference;
    }
    const Eigen::VectorXd c = statistics::least_squares(x, y);
    return (y - x * c).squaredNorm();
  };
  // Of an error that the runs' own scatter tells, and of one that was found beside the law.
  double variance = 0;
  for (const FrictionAtSpeed* s : both) variance += s->mean.variance / static_cast<double>(n);
  const double sure = scatter2 > variance ? std::max(1.0, freedom_of_scatter) : 1e6;
  if (statistics::f_upper_tail(leaves(scatter2) / freedom, freedom, sure) > 0.01) return 0;
  return root_of_scatter(leaves, freedom, largest);
}

namespace {

/// Whether a viscous term of another power leaves of all speeds no more than a straight one leaves
/// of the others: where the curve bends, no speed is a stray.
bool bends_there(const std::vector<FrictionAtSpeed>& speeds, std::size_t stray_speed, bool load) {
  SpeedLaws others(means_of(speeds, stray_speed), load);
  others.find_scatter();
  double variance = 0;
  for (const FrictionAtSpeed& s : speeds)
    variance += s.mean.variance / static_cast<double>(speeds.size());
  for (const double power : {0.4, 0.7, 1.3, 1.6, 1.9, 2.2}) {
    SpeedLaws bent(means_of(speeds), load);
    bent.set_shape(2, power);
    bent.find_scatter();
    if (bent.scatter2() <= others.scatter2() + variance) return true;
  }
  return false;
}

}  // namespace

std::vector<StrayFriction> without_strays(std::vector<FrictionAtSpeed>& speeds, bool load) {
  std::vector<StrayFriction> out;
  const auto most = static_cast<std::size_t>(strays_per_speed * static_cast<double>(speeds.size()));
  while (out.size() < most) {
    struct Farthest {
      std::size_t index{no_speed};
      double chance{1}, off_Nm{};
    } farthest;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      SpeedLaws others(means_of(speeds, i), load);
      if (!others.can_dip()) return out;
      others.find_scatter();
      const LawPoint law = others.best();
      SpeedLaws all(means_of(speeds), load);
      all.set_scatter2(others.scatter2());
      const double freedom = others.best_freedom();
      const double f = (all.best().chi2 - law.chi2) / (law.chi2 / freedom);
      const double chance = statistics::f_upper_tail(f, 1, freedom);
      const SpeedMean& m = speeds[i].mean;
      const double w = m.speed_rad_s;
      double there = law.coulomb_Nm + law.slope * w + law.load_Nm * m.load;
      if (law.has_excess) {
        there += law.excess_Nm * std::exp(-std::pow(w / law.speed_rad_s, law.exponent));
      }
      const double off = m.friction_Nm - there;
      if (std::abs(off) < least_stray * all.largest()) continue;
      if (chance < farthest.chance) farthest = {i, chance, off};
    }
    if (farthest.index == no_speed ||
        farthest.chance * static_cast<double>(speeds.size()) > stray ||
        bends_there(speeds, farthest.index, load)) {
      break;
    }
    const auto at = speeds.begin() + static_cast<std::ptrdiff_t>(farthest.index);
    out.push_back({at->mean.speed_rad_s, at->runs, farthest.off_Nm});
    speeds.erase(at);
  }
  return out;
}

}  // namespace tribolog::method::viscous
