#include "stages/oscillation_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace tribolog {
namespace {

using std::numbers::pi;

/// Mean period from the upward crossings of the middle, each counted after a swing of a quarter of
/// the range to both sides, so that noise at the crossing does not count twice. 0: less than one.
double rough_period(const Recording& r) {
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

}  // namespace

bool OscillationMotion::follows_the_angle(double encoder_step_rad) const {
  constexpr double largest_share = 0.02;
  return residual_rad <= std::max(largest_share * amplitude_rad, encoder_step_rad);
}

HarmonicMotion OscillationMotion::motor_motion(double gear_ratio) const {
  std::vector<HarmonicMotion::Harmonic> motor = harmonics;
  for (auto& h : motor) {
    h.cosine *= gear_ratio;
    h.sine *= gear_ratio;
  }
  return {gear_ratio * centre_rad, frequency_Hz, std::move(motor)};
}

std::optional<OscillationMotion> fit_oscillation_motion(const Recording& recording, int harmonics) {
  if (recording.size() < 20) return std::nullopt;
  const double period = rough_period(recording);
  if (!(period > 0)) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(recording.size());
  const double t0 = recording.t_s.front();
  const double origin = recording.q_rad.front();
  double omega = 2 * pi / period;
  Eigen::VectorXd c;
  Eigen::MatrixXd x(n, 2 + 2 * harmonics);
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) y(i) = recording.q_rad[static_cast<std::size_t>(i)] - origin;
  double residual = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    // Linear in centre and harmonics; the last column is the derivative by the frequency.
    for (Eigen::Index i = 0; i < n; ++i) {
      const double t = recording.t_s[static_cast<std::size_t>(i)] - t0;
      x(i, 0) = 1;
      double by_omega = 0;
      for (int k = 1; k <= harmonics; ++k) {
        const double cosine = std::cos(k * omega * t);
        const double sine = std::sin(k * omega * t);
        x(i, 2 * k - 1) = cosine;
        x(i, 2 * k) = sine;
        if (c.size() > 0) by_omega += k * t * (c(2 * k) * cosine - c(2 * k - 1) * sine);
      }
      x(i, 1 + 2 * harmonics) = by_omega;
    }
    const bool with_frequency = c.size() > 0;
    const Eigen::Index columns = with_frequency ? 2 + 2 * harmonics : 1 + 2 * harmonics;
    const Eigen::MatrixXd used = x.leftCols(columns);
    // Columns differ by orders of magnitude only through time; the normal equations carry that.
    const Eigen::VectorXd scale = used.colwise().norm().cwiseMax(1e-300).cwiseInverse();
    const Eigen::MatrixXd normal =
        scale.asDiagonal() * (used.transpose() * used) * scale.asDiagonal();
    const Eigen::VectorXd right = scale.asDiagonal() * (used.transpose() * y);
    const Eigen::VectorXd solution = scale.asDiagonal() * normal.ldlt().solve(right);
    residual = std::sqrt((y - used * solution).squaredNorm() / static_cast<double>(n));
    c = solution.head(1 + 2 * harmonics);
    if (with_frequency) {
      const double step = std::clamp(solution(1 + 2 * harmonics), -0.05 * omega, 0.05 * omega);
      omega += step;
      if (std::abs(step) < 1e-13 * omega) break;
    }
  }
  OscillationMotion out;
  out.frequency_Hz = omega / (2 * pi);
  out.centre_rad = origin + c(0);
  out.start_s = t0;
  out.residual_rad = residual;
  for (int k = 1; k <= harmonics; ++k) out.harmonics.push_back({c(2 * k - 1), c(2 * k)});
  out.amplitude_rad = std::hypot(out.harmonics.front().cosine, out.harmonics.front().sine);
  const double duration = recording.t_s.back() - t0;
  // A tenth of a sample short of one cycle still is one.
  if (duration * out.frequency_Hz < 1 - 0.1 / static_cast<double>(n)) return std::nullopt;
  return out;
}

}  // namespace tribolog
