#include "method/motion/oscillation_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "method/motion/encoder_resolution.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::motion {
namespace {

using std::numbers::pi;

/// Mean period from the upward crossings of the middle, each counted after a swing of a quarter of
/// the range to both sides, so that noise at the crossing does not count twice. 0: less than one
/// period.
double rough_period(const joint::Recording& r) {
  const auto [low, high] = std::minmax_element(r.q_rad.begin(), r.q_rad.end());
  const double middle = (*low + *high) / 2;
  const double quarter = (*high - *low) / 4;
  if (!(quarter > 0)) return 0;
  std::vector<double> turns;
  bool armed = false;
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (r.q_rad[i] < middle - quarter) armed = true;
    if (armed && r.q_rad[i] > middle + quarter) {
      turns.push_back(r.t_s[i]);
      armed = false;
    }
  }
  if (turns.size() >= 2)
    return (turns.back() - turns.front()) / static_cast<double>(turns.size() - 1);
  // One or two strokes: the extremes are half a period apart.
  const double half = std::abs(r.t_s[static_cast<std::size_t>(high - r.q_rad.begin())] -
                               r.t_s[static_cast<std::size_t>(low - r.q_rad.begin())]);
  return r.t_s.back() - r.t_s.front() >= 1.9 * half ? 2 * half : 0;
}

/// Of a longer recording the first iterations use every n-th sample; the last ones use all.
constexpr std::size_t most_samples_at_first = 50'000;
constexpr double fewest_samples_a_period = 60;

std::size_t first_stride(const joint::Recording& r, double period_s) {
  const double per_period =
      period_s * static_cast<double>(r.size() - 1) / (r.t_s.back() - r.t_s.front());
  const double stride = std::min(static_cast<double>(r.size()) / most_samples_at_first,
                                 per_period / fewest_samples_a_period);
  return static_cast<std::size_t>(std::max(1.0, stride));
}

/// A harmonic series of unknown frequency fitted to a recording by Gauss-Newton: linear in centre
/// and harmonics, with a column for the derivative with respect to frequency. Processes a stretch
/// of the recording at a time: a long one needs no more memory.
class SeriesFit {
 public:
  SeriesFit(const joint::Recording& recording, int harmonics, double omega)
      : r_(recording), harmonics_(harmonics), omega_(omega) {}

  /// Up to so many iterations over every `stride`-th sample.
  void improve(std::size_t stride, int rounds) {
    stride_ = stride;
    for (int round = 0; round < rounds; ++round) {
      solve();
      c_ = solution_.head(1 + 2 * harmonics_);
      if (solution_.size() == c_.size()) continue;
      const double step = std::clamp(solution_(1 + 2 * harmonics_), -0.05 * omega_, 0.05 * omega_);
      omega_ += step;
      if (std::abs(step) < 1e-13 * omega_) break;
    }
  }

  [[nodiscard]] double omega() const { return omega_; }
  /// Centre, counted from the first angle, and cosine and sine of each harmonic.
  [[nodiscard]] const Eigen::VectorXd& coefficients() const { return c_; }

  /// Goes on with more of them, the further ones zero.
  void take_harmonics(int harmonics) {
    harmonics_ = harmonics;
    c_.conservativeResizeLike(Eigen::VectorXd::Zero(1 + 2 * harmonics_));
  }

  /// Standard deviation of the last iteration's residuals.
  double residual() {
    double squares = 0;
    over_stretches(last_omega_, last_c_, [&](const auto& x, const auto& y) {
      squares += (y - x * solution_).squaredNorm();
    });
    return std::sqrt(squares / static_cast<double>(samples()));
  }

 private:
  [[nodiscard]] std::size_t samples() const { return (r_.size() + stride_ - 1) / stride_; }

  void solve() {
    const Eigen::Index columns = c_.size() > 0 ? 2 + 2 * harmonics_ : 1 + 2 * harmonics_;
    Eigen::MatrixXd xx = Eigen::MatrixXd::Zero(columns, columns);
    Eigen::VectorXd xy = Eigen::VectorXd::Zero(columns);
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(columns);
    over_stretches(omega_, c_, [&](const auto& x, const auto& y) {
      xx += x.transpose() * x;
      xy += x.transpose() * y;
      squares += x.colwise().squaredNorm().transpose();
    });
    // Columns differ by orders of magnitude only through time; the normal equations carry that.
    const Eigen::VectorXd scale = squares.cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
    const Eigen::MatrixXd normal = scale.asDiagonal() * xx * scale.asDiagonal();
    const Eigen::VectorXd right = scale.asDiagonal() * xy;
    solution_ = scale.asDiagonal() * statistics::solve_normal(normal, right);
    last_omega_ = omega_;
    last_c_ = c_;
  }

  template <class Visit>
  void over_stretches(double omega, const Eigen::VectorXd& c, Visit visit) {
    constexpr std::size_t stretch = std::size_t{1} << 16;
    const bool with_frequency = c.size() > 0;
    const Eigen::Index columns = with_frequency ? 2 + 2 * harmonics_ : 1 + 2 * harmonics_;
    const double t0 = r_.t_s.front();
    const double origin = r_.q_rad.front();
    for (std::size_t first = 0; first < samples(); first += stretch) {
      const auto rows = static_cast<Eigen::Index>(std::min(stretch, samples() - first));
      x_.resize(rows, columns);
      y_.resize(rows);
      for (Eigen::Index row = 0; row < rows; ++row) {
        const std::size_t i = (first + static_cast<std::size_t>(row)) * stride_;
        const double t = r_.t_s[i] - t0;
        y_(row) = r_.q_rad[i] - origin;
        x_(row, 0) = 1;
        double by_omega = 0;
        for (int k = 1; k <= harmonics_; ++k) {
          const double cosine = std::cos(k * omega * t);
          const double sine = std::sin(k * omega * t);
          x_(row, 2 * k - 1) = cosine;
          x_(row, 2 * k) = sine;
          if (with_frequency) by_omega += k * t * (c(2 * k) * cosine - c(2 * k - 1) * sine);
        }
        if (with_frequency) x_(row, 1 + 2 * harmonics_) = by_omega;
      }
      visit(x_, y_);
    }
  }

  const joint::Recording& r_;
  int harmonics_;
  std::size_t stride_{1};
  double omega_;
  Eigen::VectorXd c_, solution_;
  double last_omega_{};
  Eigen::VectorXd last_c_;  // those that the last round went out from
  Eigen::MatrixXd x_;
  Eigen::VectorXd y_;
};

using Harmonic = simulate::HarmonicMotion::Harmonic;

/// Orders up to `most` of values over cycles `from` to before `to` of a recording.
std::vector<Harmonic> orders_of(const std::vector<double>& t_s, const std::vector<double>& values,
                                double omega, int most, double from, double to) {
  std::vector<Harmonic> out(static_cast<std::size_t>(most));
  std::size_t samples = 0;
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    const double phase = omega * (t_s[i] - t_s.front());
    if (phase < 2 * pi * from) continue;
    if (!(phase < 2 * pi * to)) break;
    ++samples;
    const std::complex<double> first = std::polar(1.0, phase);
    std::complex<double> order = first;
    for (Harmonic& h : out) {
      h.cosine += values[i] * order.real();
      h.sine += values[i] * order.imag();
      order *= first;
    }
  }
  for (Harmonic& h : out) {
    h.cosine *= 2 / static_cast<double>(samples);
    h.sine *= 2 / static_cast<double>(samples);
  }
  return out;
}

/// A drift would be in all orders.
void take_trend_off(const std::vector<double>& t_s, std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  const double mean_s = std::accumulate(t_s.begin(), t_s.end(), 0.0) / n;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double along = 0;
  double square = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    along += (t_s[i] - mean_s) * values[i];
    square += (t_s[i] - mean_s) * (t_s[i] - mean_s);
  }
  const double slope = square > 0 ? along / square : 0;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= mean + slope * (t_s[i] - mean_s);
}

double amplitude_of(const Harmonic& h) { return std::hypot(h.cosine, h.sine); }

/// What is left of the angle, order by order, without those that were fitted.
class HigherOrders {
 public:
  HigherOrders(const joint::Recording& r, const SeriesFit& fit, int harmonics) : r_(r) {
    constexpr int highest = 31;
    constexpr double samples_a_period = 8;  // of the highest
    const double duration = r.t_s.back() - r.t_s.front();
    const double per_period = static_cast<double>(r.size() - 1) / duration * 2 * pi / fit.omega();
    most_ = std::min(highest, static_cast<int>(per_period / samples_a_period));
    fitted_ = harmonics;
    omega_ = fit.omega();
    if (most_ <= fitted_) return;
    const Eigen::VectorXd& c = fit.coefficients();
    first_rad_ = std::hypot(c(1), c(2));
    std::vector<Harmonic> series;
    for (int k = 1; k <= fitted_; ++k) series.push_back({c(2 * k - 1), c(2 * k)});
    const simulate::HarmonicMotion motion(r.q_rad.front() + c(0), omega_ / (2 * pi),
                                          std::move(series));
    std::vector<double> left(r.size());
    for (std::size_t i = 0; i < r.size(); ++i) {
      left[i] = r.q_rad[i] - motion.angle(r.t_s[i] - r.t_s.front());
    }
    take_trend_off(r.t_s, left);
    cycles_ = std::floor(duration * omega_ / (2 * pi) + 1e-9);
    if (cycles_ < 1) {
      most_ = 0;
      return;
    }
    left_ = orders_of(r.t_s, left, omega_, most_, 0, cycles_);
    for (const double value : left) variance_ += value * value / static_cast<double>(r.size());
    for (int k = fitted_ + 1; k <= most_; ++k) variance_ -= std::pow(amplitude(k), 2) / 2;
    const double half = std::floor(cycles_ / 2);
    if (half < 1) return;
    early_ = orders_of(r.t_s, left, omega_, most_, 0, half);
    late_ = orders_of(r.t_s, left, omega_, most_, cycles_ - half, cycles_);
  }

  /// Highest order that the angle shows beyond its noise and its encoder's steps: a servo's motion
  /// is no sine where the contact bends over. Steps are no white noise: each cycle of a steady
  /// oscillation is read alike. What they leave is in all orders, and is seen in the highest.
  [[nodiscard]] int shown() const {
    if (most_ <= fitted_) return fitted_;
    double of_steps = 0.3 * angle_step(r_.q_rad, 1).step_rad;
    if (are_enough()) {
      constexpr double beyond = 3;
      double highest_rad = 0;
      for (int k = most_ - most_ / 4; k <= most_; ++k) {
        highest_rad = std::max(highest_rad, amplitude(k));
      }
      of_steps = beyond * highest_rad;
    }
    constexpr double standard_errors = 6;
    const double error = std::sqrt(2 * std::max(0.0, variance_) / static_cast<double>(r_.size()));
    const double least = std::max({matters * first_rad_, standard_errors * error, of_steps});
    for (int k = most_; k > fitted_; --k) {
      if (amplitude(k) > least && is_steady(k)) return k;
    }
    return fitted_;
  }

  /// Adds what gives way to the torque beyond the orders that the motion has: q_k = T_k (a + i k
  /// b), with two numbers for all of them, a servo's stiffness and damping. None where noise
  /// explains it.
  void give_way(OscillationMotion& motion) const {
    const std::size_t first = motion.harmonics.size();
    if (!are_enough() || static_cast<std::size_t>(most_) < first + enough / 2) return;
    const std::vector<Harmonic> torque = orders_of(r_.t_s, r_.torque_Nm, omega_, most_, 0, cycles_);
    std::vector<Harmonic> like_torque(torque.size());
    std::vector<Harmonic> like_rate(torque.size());
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    double squares = 0;
    for (std::size_t at = first; at < torque.size(); ++at) {
      const auto k = static_cast<double>(at + 1);
      like_torque[at] = torque[at];
      like_rate[at] = {k * torque[at].sine, -k * torque[at].cosine};
      Eigen::Matrix2d x;
      x << like_torque[at].cosine, like_rate[at].cosine, like_torque[at].sine, like_rate[at].sine;
      const Eigen::Vector2d left(left_[at].cosine, left_[at].sine);
      normal += x.transpose() * x;
      right += x.transpose() * left;
      squares += left.squaredNorm();
    }
    const Eigen::Vector2d shares = statistics::solve_normal(normal, right);
    // By chance, noise looks like the torque by so much in one of twenty recordings.
    constexpr double least_gain = 3;
    const double gain = shares.dot(right);
    const double freedom = 2.0 * static_cast<double>(torque.size() - first - 1);
    if (!(gain / 2 > least_gain * (squares - gain) / freedom)) return;
    if (!(gain > std::pow(matters * first_rad_, 2))) return;
    for (std::size_t at = first; at < torque.size(); ++at) {
      motion.harmonics.push_back(
          {shares(0) * like_torque[at].cosine + shares(1) * like_rate[at].cosine,
           shares(0) * like_torque[at].sine + shares(1) * like_rate[at].sine});
    }
    motion.of_torque = {std::move(like_torque), std::move(like_rate)};
  }

 private:
  static constexpr int enough = 12;        // orders, for the highest to be noise alone
  static constexpr double matters = 1e-6;  // of the first
  [[nodiscard]] bool are_enough() const { return most_ >= enough; }
  [[nodiscard]] double amplitude(int k) const {
    return amplitude_of(left_[static_cast<std::size_t>(k) - 1]);
  }

  /// Whether both halves of the recording show an order alike: one that drifts and creeps does not.
  [[nodiscard]] bool is_steady(int k) const {
    const auto at = static_cast<std::size_t>(k) - 1;
    if (early_.empty()) return true;
    const double apart =
        amplitude_of({early_[at].cosine - late_[at].cosine, early_[at].sine - late_[at].sine});
    return apart < amplitude(k) / 2;
  }

  const joint::Recording& r_;
  int most_{}, fitted_{};
  double omega_{}, cycles_{}, first_rad_{}, variance_{};
  std::vector<Harmonic> left_, early_, late_;  // of the whole recording and of its halves
};

}  // namespace

bool OscillationMotion::is_near_sine(double encoder_step_rad) const {
  constexpr double largest_share = 0.02;
  return near_sine_rad <= std::max(largest_share * amplitude_rad, encoder_step_rad);
}

double OscillationMotion::share_of_harmonic(std::size_t order) const {
  if (order == 0 || order > harmonics.size() || !(amplitude_rad > 0)) return 0;
  const simulate::HarmonicMotion::Harmonic& h = harmonics[order - 1];
  return std::hypot(h.cosine, h.sine) / amplitude_rad;
}

bool OscillationMotion::has_even_harmonics() const {
  constexpr double least_share = 1e-3;  // of the first: a mean torque moves by as much of friction
  constexpr double standard_errors = 5;
  const double error = residual_rad * std::sqrt(2 / static_cast<double>(samples)) / amplitude_rad;
  return share_of_harmonic(2) > std::max(least_share, standard_errors * error);
}

simulate::HarmonicMotion OscillationMotion::motor_motion(double gear_ratio) const {
  std::vector<simulate::HarmonicMotion::Harmonic> motor = harmonics;
  for (auto& h : motor) {
    h.cosine *= gear_ratio;
    h.sine *= gear_ratio;
  }
  return {gear_ratio * centre_rad, frequency_Hz, std::move(motor)};
}

HarmonicRefit::HarmonicRefit(const std::vector<double>& t_s, OscillationMotion motion)
    : motion_(std::move(motion)) {
  const auto rows = static_cast<Eigen::Index>(t_s.size());
  const auto single = static_cast<Eigen::Index>(motion_.one_by_one);
  const auto series = static_cast<Eigen::Index>(motion_.of_torque.size());
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(rows, 1 + 2 * single + series);
  x.col(0).setOnes();
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double t = t_s[static_cast<std::size_t>(i)] - motion_.start_s;
    const std::complex<double> first = std::polar(1.0, 2 * pi * motion_.frequency_Hz * t);
    std::complex<double> order = first;
    for (Eigen::Index k = 1; k <= static_cast<Eigen::Index>(motion_.harmonics.size()); ++k) {
      if (k <= single) {
        x(i, 2 * k - 1) = order.real();
        x(i, 2 * k) = order.imag();
      }
      for (Eigen::Index s = 0; s < series; ++s) {
        const simulate::HarmonicMotion::Harmonic& h =
            motion_.of_torque[static_cast<std::size_t>(s)][static_cast<std::size_t>(k) - 1];
        x(i, 1 + 2 * single + s) += h.cosine * order.real() + h.sine * order.imag();
      }
      order *= first;
    }
  }
  const Eigen::VectorXd scale = x.colwise().norm().transpose().cwiseMax(1e-300).cwiseInverse();
  x = x * scale.asDiagonal();
  solved_ = scale.asDiagonal() * statistics::solve_normal(x.transpose() * x, x.transpose());
}

OscillationMotion HarmonicRefit::operator()(const std::vector<double>& q_rad) const {
  const Eigen::Map<const Eigen::VectorXd> q(q_rad.data(), solved_.cols());
  const Eigen::VectorXd c = solved_ * (q.array() - motion_.centre_rad).matrix();
  OscillationMotion out = motion_;
  out.centre_rad += c(0);
  for (std::size_t k = 0; k < out.harmonics.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(2 * k + 1);
    if (k < out.one_by_one) {
      out.harmonics[k] = {c(column), c(column + 1)};
      continue;
    }
    out.harmonics[k] = {};
    for (std::size_t s = 0; s < out.of_torque.size(); ++s) {
      const double share = c(static_cast<Eigen::Index>(1 + 2 * out.one_by_one + s));
      out.harmonics[k].cosine += share * out.of_torque[s][k].cosine;
      out.harmonics[k].sine += share * out.of_torque[s][k].sine;
    }
  }
  return out;
}

std::optional<OscillationMotion> fit_oscillation_motion(const joint::Recording& recording) {
  int harmonics = 3;
  if (recording.size() < 20) return std::nullopt;
  const double period = rough_period(recording);
  if (!(period > 0)) return std::nullopt;
  constexpr int rounds = 30;
  constexpr int last_rounds = 5;  // from where the first ones arrived
  SeriesFit fit(recording, harmonics, 2 * pi / period);
  const std::size_t stride = first_stride(recording, period);
  if (stride > 1) fit.improve(stride, rounds);
  fit.improve(1, stride > 1 ? last_rounds : rounds);
  const double near_sine_rad = fit.residual();
  const HigherOrders higher(recording, fit, harmonics);
  const int further = higher.shown();
  if (further > harmonics) {
    fit.take_harmonics(further);
    fit.improve(1, last_rounds);
    harmonics = further;
  }
  const double omega = fit.omega();
  const Eigen::VectorXd& c = fit.coefficients();
  OscillationMotion out;
  out.frequency_Hz = omega / (2 * pi);
  out.centre_rad = recording.q_rad.front() + c(0);
  out.start_s = recording.t_s.front();
  out.residual_rad = fit.residual();
  out.near_sine_rad = near_sine_rad;
  out.samples = recording.size();
  for (int k = 1; k <= harmonics; ++k) out.harmonics.push_back({c(2 * k - 1), c(2 * k)});
  out.one_by_one = out.harmonics.size();
  out.amplitude_rad = std::hypot(out.harmonics.front().cosine, out.harmonics.front().sine);
  const double duration = recording.t_s.back() - recording.t_s.front();
  // A tenth of a sample short of one cycle still is one.
  if (duration * out.frequency_Hz < 1 - 0.1 / static_cast<double>(recording.size())) {
    return std::nullopt;
  }
  higher.give_way(out);
  return out;
}

}  // namespace tribolog::method::motion
