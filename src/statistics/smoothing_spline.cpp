#include "statistics/smoothing_spline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/statement.h"

namespace tribolog::statistics {
namespace {

/// Symmetric, two diagonals beside the main one.
struct Band {
  std::vector<double> main, first, second;
  explicit Band(std::size_t n) : main(n), first(n), second(n) {}
};

/// The triangular factors L D L' of a positive definite band, in its place.
void factorise(Band& a) {
  const std::size_t m = a.main.size();
  for (std::size_t k = 0; k < m; ++k) {
    const double first = a.first[k];
    const double second = a.second[k];
    if (k + 1 < m) {
      a.first[k] /= a.main[k];
      a.main[k + 1] -= a.first[k] * first;
      if (k + 2 < m) a.first[k + 1] -= a.first[k] * second;
    }
    if (k + 2 < m) {
      a.second[k] /= a.main[k];
      a.main[k + 2] -= a.second[k] * second;
    }
  }
}

void solve(const Band& factors, std::vector<double>& x) {
  const std::size_t m = x.size();
  for (std::size_t k = 0; k < m; ++k) {
    if (k + 1 < m) x[k + 1] -= factors.first[k] * x[k];
    if (k + 2 < m) x[k + 2] -= factors.second[k] * x[k];
  }
  for (std::size_t k = m; k-- > 0;) {
    x[k] /= factors.main[k];
    if (k + 1 < m) x[k] -= factors.first[k] * x[k + 1];
    if (k + 2 < m) x[k] -= factors.second[k] * x[k + 2];
  }
}

/// The same band of the inverse (M. F. Hutchinson, F. R. de Hoog, Numer. Math. 47 (1985) 99-106).
Band band_of_inverse(const Band& factors) {
  const std::size_t m = factors.main.size();
  Band out(m);
  for (std::size_t k = m; k-- > 0;) {
    const double l1 = k + 1 < m ? factors.first[k] : 0;
    const double l2 = k + 2 < m ? factors.second[k] : 0;
    const double next = k + 1 < m ? out.main[k + 1] : 0;
    const double beside = k + 1 < m ? out.first[k + 1] : 0;
    const double after = k + 2 < m ? out.main[k + 2] : 0;
    out.first[k] = -l1 * next - l2 * beside;
    out.second[k] = -l1 * beside - l2 * after;
    out.main[k] = 1 / factors.main[k] - l1 * out.first[k] - l2 * out.second[k];
  }
  return out;
}

/// The system of one set of points. Inner points only; times in mean intervals and errors in mean
/// errors, so that the weight has no unit.
class Smoother {
 public:
  explicit Smoother(const CurvePoints& p)
      : y_(p.y), unit_((p.t.back() - p.t.front()) / static_cast<double>(p.t.size() - 1)) {
    for (std::size_t i = 0; i + 1 < p.t.size(); ++i) h_.push_back((p.t[i + 1] - p.t[i]) / unit_);
    for (std::size_t k = 0; k + 1 < h_.size(); ++k) {
      bend_.push_back((y_[k + 2] - y_[k + 1]) / h_[k + 1] - (y_[k + 1] - y_[k]) / h_[k]);
    }
    for (const double e : p.error) mean_error_ += e / static_cast<double>(p.error.size());
    for (const double e : p.error) variance_.push_back(e * e / (mean_error_ * mean_error_));
  }

  /// Solves (R + weight Q'VQ) curvature = Q'y, V the errors' squares, and leaves the residuals
  /// weight V Q curvature.
  void solve_with(double weight) {
    const std::size_t m = bend_.size();
    Band a(m);
    for (std::size_t k = 0; k < m; ++k) {
      a.main[k] = (h_[k] + h_[k + 1]) / 3 + weight * product(k, k);
      if (k + 1 < m) a.first[k] = h_[k + 1] / 6 + weight * product(k, k + 1);
      if (k + 2 < m) a.second[k] = weight * product(k, k + 2);
    }
    factorise(a);
    curvature_ = bend_;
    solve(a, curvature_);
    residuals_.assign(y_.size(), 0.0);
    for (std::size_t k = 0; k < m; ++k) {
      const Difference d = difference(k);
      for (std::size_t i = 0; i < 3; ++i) {
        residuals_[k + i] += weight * variance_[k + i] * d.by[i] * curvature_[k];
      }
    }
    const Band inverse = band_of_inverse(a);
    left_ = 0;
    for (std::size_t k = 0; k < m; ++k) {
      left_ += inverse.main[k] * product(k, k);
      if (k + 1 < m) left_ += 2 * inverse.first[k] * product(k, k + 1);
      if (k + 2 < m) left_ += 2 * inverse.second[k] * product(k, k + 2);
    }
    left_ *= weight;
    squares_ = 0;
    for (std::size_t i = 0; i < y_.size(); ++i) {
      squares_ += residuals_[i] * residuals_[i] / variance_[i];
    }
  }

  /// Of the residuals in mean errors.
  [[nodiscard]] double squares() const { return squares_; }
  /// Trace of 1 less the smoother.
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double mean_error() const { return mean_error_; }
  /// What one unit of the weight is, in the points' own units.
  [[nodiscard]] double unit_of_weight() const {
    return unit_ * unit_ * unit_ / (mean_error_ * mean_error_);
  }
  [[nodiscard]] double freedom() const { return static_cast<double>(y_.size()) - left_; }
  [[nodiscard]] std::vector<double> values() const {
    std::vector<double> out = y_;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] -= residuals_[i];
    return out;
  }
  /// By time in its own unit; none at the ends.
  [[nodiscard]] std::vector<double> curvatures() const {
    std::vector<double> out{0.0};
    for (const double c : curvature_) out.push_back(c / (unit_ * unit_));
    out.push_back(0.0);
    return out;
  }

 private:
  struct Difference {
    double by[3];
  };
  /// Column k of Q: the second difference around inner point k + 1.
  [[nodiscard]] Difference difference(std::size_t k) const {
    return {{1 / h_[k], -1 / h_[k] - 1 / h_[k + 1], 1 / h_[k + 1]}};
  }
  /// Of columns j <= k of Q, weighed by the errors' squares.
  [[nodiscard]] double product(std::size_t j, std::size_t k) const {
    const Difference a = difference(j);
    const Difference b = difference(k);
    double sum = 0;
    for (std::size_t i = k - j; i < 3; ++i) sum += variance_[j + i] * a.by[i] * b.by[i - (k - j)];
    return sum;
  }

  std::vector<double> y_;
  double unit_;
  double mean_error_{};
  std::vector<double> h_, bend_, variance_, curvature_, residuals_;
  double squares_{};
  double left_{};
};

constexpr std::size_t fewest_points = 4;

/// Powers of ten between which the weight is searched: from next to no smoothing to nearly a
/// straight line.
constexpr double lowest_power = -4;
constexpr double highest_power = 16;
constexpr double beside = 0.5;       // of what the same curve had before
constexpr double resolution = 0.05;  // of the power

/// With more points than this the weight is found on stretches spread over the curve that hold as
/// many points together: they determine it as well as all points do.
constexpr std::size_t most_points_to_weigh = 20'000;
constexpr std::size_t stretches_to_weigh = 10;

CurvePoints cut(const CurvePoints& p, std::size_t first, std::size_t size) {
  const auto part = [&](const std::vector<double>& v) {
    const auto begin = v.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(size));
  };
  return {part(p.t), part(p.y), part(p.error)};
}

/// None: the whole curve.
std::vector<Smoother> parts_to_weigh(const CurvePoints& p, double weighed_from) {
  std::vector<Smoother> parts;
  const auto begin = static_cast<std::size_t>(
      std::lower_bound(p.t.begin(), p.t.end(), weighed_from) - p.t.begin());
  const std::size_t points = p.t.size() - begin;
  constexpr std::size_t size = most_points_to_weigh / stretches_to_weigh;
  if (points <= most_points_to_weigh) {
    if (begin > 0 && points >= fewest_points) parts.emplace_back(cut(p, begin, points));
    return parts;
  }
  for (std::size_t k = 0; k < stretches_to_weigh; ++k) {
    parts.emplace_back(cut(p, begin + (points - size) * k / (stretches_to_weigh - 1), size));
  }
  return parts;
}

/// The score of generalised cross-validation over all parts.
/// @param weight in units of the whole.
double score_of(std::span<Smoother> parts, const Smoother& whole, double weight) {
  double squares = 0;
  double left = 0;
  for (Smoother& part : parts) {
    part.solve_with(weight * (whole.unit_of_weight() / part.unit_of_weight()));
    squares += part.squares() * std::pow(whole.mean_error() / part.mean_error(), 2);
    left += part.left();
  }
  return squares / (left * left);
}

/// The score may have several minima: the deepest on a grid, then refined.
double best_power(std::span<Smoother> parts, const Smoother& whole, double from, double to,
                  double grid) {
  const auto score = [&](double power) { return score_of(parts, whole, std::pow(10, power)); };
  double best = from;
  double least = score(best);
  for (double power = from + grid; power < to + grid / 2; power += grid) {
    const double s = score(power);
    if (s < least) {
      least = s;
      best = power;
    }
  }
  for (double step = grid / 2; step > resolution; step /= 2) {
    for (const double power : {best - step, best + step}) {
      const double s = score(power);
      if (s < least) {
        least = s;
        best = power;
      }
    }
  }
  return best;
}

void require_points(const CurvePoints& p) {
  if (p.t.size() < fewest_points || p.y.size() != p.t.size() || p.error.size() != p.t.size()) {
    throw Refusal({"spline.wrong_sizes",
                   {{"times", p.t.size()},
                    {"values", p.y.size()},
                    {"errors", p.error.size()},
                    {"needed", fewest_points}}});
  }
  for (std::size_t i = 0; i < p.t.size(); ++i) {
    if (i > 0 && !(p.t[i] > p.t[i - 1])) {
      throw Refusal({"spline.times_do_not_increase", {{"time", p.t[i]}, {"before", p.t[i - 1]}}});
    }
    if (!(p.error[i] > 0)) {
      throw Refusal({"spline.error_not_positive", {{"error", p.error[i]}, {"time", p.t[i]}}});
    }
  }
}

}  // namespace

SmoothingSpline::SmoothingSpline(const CurvePoints& points, double weighed_from)
    : SmoothingSpline(points, weighed_from, nullptr) {}

SmoothingSpline::SmoothingSpline(const CurvePoints& points, const SmoothingSpline& found)
    : SmoothingSpline(points, found.weighed_from_, &found) {}

SmoothingSpline::SmoothingSpline(const CurvePoints& points, double weighed_from,
                                 const SmoothingSpline* found)
    : t_(points.t), weighed_from_(weighed_from) {
  require_points(points);
  Smoother smoother(points);
  double from = lowest_power;
  double to = highest_power;
  double grid = 1;
  if (found != nullptr) {
    const double power = std::log10(found->weight_ / smoother.unit_of_weight());
    from = std::max(lowest_power, power - beside);
    to = std::min(highest_power, power + beside);
    grid = beside;
  }
  std::vector<Smoother> parts = parts_to_weigh(points, weighed_from);
  const std::span<Smoother> weighed =
      parts.empty() ? std::span<Smoother>(&smoother, 1) : std::span<Smoother>(parts);
  const double weight = std::pow(10, best_power(weighed, smoother, from, to, grid));
  smoother.solve_with(weight);
  weight_ = weight * smoother.unit_of_weight();
  freedom_ = smoother.freedom();
  value_ = smoother.values();
  curvature_ = smoother.curvatures();
}

/// The piece between points i and i + 1 that holds t; the outermost ones go on beyond the points.
std::size_t SmoothingSpline::piece_of(double t) const {
  // Clocks mostly tick evenly: where the point stands then, or near there.
  constexpr std::size_t near = 2;
  const std::size_t last = t_.size() - 2;
  const double share = (t - t_.front()) / (t_.back() - t_.front());
  auto i = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(last));
  for (std::size_t k = 0; k < near && i > 0 && t < t_[i]; ++k) --i;
  for (std::size_t k = 0; k < near && i < last && t >= t_[i + 1]; ++k) ++i;
  if ((i == 0 || t >= t_[i]) && (i == last || t < t_[i + 1])) return i;
  const auto after = std::upper_bound(t_.begin() + 1, t_.end() - 1, t);
  return static_cast<std::size_t>(after - t_.begin()) - 1;
}

SmoothingSpline::Point SmoothingSpline::at(double t) const {
  const std::size_t i = piece_of(t);
  const double h = t_[i + 1] - t_[i];
  const double chord = (value_[i + 1] - value_[i]) / h;
  const double slope = chord - h / 6 * (2 * curvature_[i] + curvature_[i + 1]);
  const double inside = std::clamp(t - t_[i], 0.0, h);
  const double jerk = (curvature_[i + 1] - curvature_[i]) / h;
  Point out;
  out.curvature = curvature_[i] + jerk * inside;
  out.slope = slope + inside * (curvature_[i] + jerk * inside / 2);
  out.value = value_[i] + inside * (slope + inside * (curvature_[i] / 2 + jerk * inside / 6)) +
              (t - t_[i] - inside) * out.slope;
  return out;
}

}  // namespace tribolog::statistics
