#include "method/motion/oscillation_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <Eigen/Dense>

#include "method/motion/encoder_resolution.h"

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
    solution_ = scale.asDiagonal() * normal.ldlt().solve(right);
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

/// Highest order that the angle shows beyond its noise, from `harmonics` on: a servo's motion is no
/// sine where the contact bends over.
int further_harmonics(const joint::Recording& r, const SeriesFit& fit, int harmonics) {
  constexpr int highest = 31;
  constexpr double samples_a_period = 8;  // of the highest
  constexpr double standard_errors = 6;
  constexpr double share_of_step = 0.3;  // an encoder's steps leave less in any order
  const double duration = r.t_s.back() - r.t_s.front();
  const double per_period = static_cast<double>(r.size() - 1) / duration * 2 * pi / fit.omega();
  const int most = std::min(highest, static_cast<int>(per_period / samples_a_period));
  if (most <= harmonics) return harmonics;
  SeriesFit whole = fit;
  whole.take_harmonics(most);
  whole.improve(1, 2);
  const double error = whole.residual() * std::sqrt(2 / static_cast<double>(r.size()));
  constexpr double matters = 1e-6;  // of the first
  const Eigen::VectorXd& first = fit.coefficients();
  const double least = std::max({matters * std::hypot(first(1), first(2)), standard_errors * error,
                                 share_of_step * angle_step(r.q_rad, 1).step_rad});
  for (int k = most; k > harmonics; --k) {
    const Eigen::VectorXd& c = whole.coefficients();
    if (std::hypot(c(2 * k - 1), c(2 * k)) > least) return k;
  }
  return harmonics;
}

}  // namespace

bool OscillationMotion::follows_the_angle(double encoder_step_rad) const {
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
  const auto harmonics = static_cast<Eigen::Index>(motion_.harmonics.size());
  Eigen::MatrixXd x(rows, 1 + 2 * harmonics);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double t = t_s[static_cast<std::size_t>(i)] - motion_.start_s;
    x(i, 0) = 1;
    for (Eigen::Index k = 1; k <= harmonics; ++k) {
      const double phase = 2 * pi * motion_.frequency_Hz * static_cast<double>(k) * t;
      x(i, 2 * k - 1) = std::cos(phase);
      x(i, 2 * k) = std::sin(phase);
    }
  }
  solved_ = (x.transpose() * x).ldlt().solve(x.transpose());
}

OscillationMotion HarmonicRefit::operator()(const std::vector<double>& q_rad) const {
  const Eigen::Map<const Eigen::VectorXd> q(q_rad.data(), solved_.cols());
  const Eigen::VectorXd c = solved_ * (q.array() - motion_.centre_rad).matrix();
  OscillationMotion out = motion_;
  out.centre_rad += c(0);
  for (std::size_t k = 0; k < out.harmonics.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(2 * k + 1);
    out.harmonics[k] = {c(column), c(column + 1)};
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
  const int further = further_harmonics(recording, fit, harmonics);
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
  out.amplitude_rad = std::hypot(out.harmonics.front().cosine, out.harmonics.front().sine);
  const double duration = recording.t_s.back() - recording.t_s.front();
  // A tenth of a sample short of one cycle still is one.
  if (duration * out.frequency_Hz < 1 - 0.1 / static_cast<double>(recording.size())) {
    return std::nullopt;
  }
  return out;
}

}  // namespace tribolog::method::motion
