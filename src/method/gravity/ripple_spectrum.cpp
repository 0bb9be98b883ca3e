#include "method/gravity/ripple_spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <optional>

#include <unsupported/Eigen/FFT>

#include "statistics/random_stream.h"

namespace tribolog::method::gravity {
namespace {

using std::numbers::pi;

// A line whose power is this many times the noise's has a probability of exp(-14) at one period.
constexpr double line_evidence = 14;
constexpr std::size_t most_lines = 6;
constexpr std::size_t most_bins = 1U << 16;

/// Residual over the motor's angle in bins of equal width.
struct BinnedResidual {
  double start_rad{}, width_rad{};
  std::vector<double> mean, count;
  double samples{};

  [[nodiscard]] double angle(std::size_t bin) const {
    return start_rad + (static_cast<double>(bin) + 0.5) * width_rad;
  }
};

BinnedResidual bin_residual(const std::vector<double>& angle, const std::vector<double>& residual,
                            double bins_per_turn) {
  const auto [low, high] = std::minmax_element(angle.begin(), angle.end());
  BinnedResidual out;
  out.start_rad = *low;
  out.width_rad = 2 * pi / bins_per_turn;
  const double wanted = std::floor((*high - *low) / out.width_rad) + 1;
  const auto bins = static_cast<std::size_t>(std::min(wanted, static_cast<double>(most_bins)));
  out.mean.assign(bins, 0.0);
  out.count.assign(bins, 0.0);
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const auto bin = static_cast<std::size_t>((angle[i] - *low) / out.width_rad);
    if (bin >= bins) continue;
    out.mean[bin] += residual[i];
    out.count[bin] += 1;
    out.samples += 1;
  }
  for (std::size_t b = 0; b < bins; ++b) out.mean[b] /= std::max(1.0, out.count[b]);
  return out;
}

/// Amplitude and phase of one period, by least squares.
RippleLine line_at(const BinnedResidual& r, double periods_per_turn) {
  double cc = 0, ss = 0, cs = 0, cy = 0, sy = 0;
  const std::complex<double> step = std::polar(1.0, periods_per_turn * r.width_rad);
  std::complex<double> turn = std::polar(1.0, periods_per_turn * r.angle(0));
  for (std::size_t b = 0; b < r.mean.size(); ++b, turn *= step) {
    const double c = turn.real();
    const double s = turn.imag();
    const double w = r.count[b];
    cc += w * c * c;
    ss += w * s * s;
    cs += w * c * s;
    cy += w * c * r.mean[b];
    sy += w * s * r.mean[b];
  }
  const double det = cc * ss - cs * cs;
  if (!(det > 0)) return {periods_per_turn, 0, 0};
  const double a = (ss * cy - cs * sy) / det;
  const double b = (cc * sy - cs * cy) / det;
  return {periods_per_turn, std::hypot(a, b), std::atan2(-b, a)};
}

/// Mean power of the spectrum about an index, without the line there: from the median.
double power_around(const std::vector<std::complex<double>>& spectrum, std::size_t k,
                    std::size_t padding) {
  const std::size_t lobe = 3 * padding;  // of a line, to each side
  const std::size_t reach = 20 * lobe;
  std::vector<double> around;
  const std::size_t first = k > reach ? k - reach : 1;
  const std::size_t last = std::min(k + reach, spectrum.size() / 2);
  for (std::size_t i = first; i <= last; ++i) {
    if (i + lobe < k || i > k + lobe) around.push_back(std::norm(spectrum[i]));
  }
  if (around.empty()) return 0;
  const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
  std::nth_element(around.begin(), middle, around.end());
  return *middle / std::numbers::ln2;
}

/// The strongest line of the spectrum, refined between its neighbours.
/// @param out_of_neighbours it has to stand out from those too.
std::optional<RippleLine> strongest_line(const BinnedResidual& r, const RippleSearch& search,
                                         bool out_of_neighbours = false) {
  constexpr std::size_t padding = 4;
  std::size_t size = 1;
  while (size < padding * r.mean.size()) size *= 2;
  std::vector<double> padded(size, 0.0);
  const double typical = r.samples / static_cast<double>(r.mean.size());
  for (std::size_t b = 0; b < r.mean.size(); ++b) padded[b] = r.mean[b] * r.count[b] / typical;
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> fft;
  fft.fwd(spectrum, padded);
  const double per_index = search.bins_per_turn / static_cast<double>(size);
  const double turns = static_cast<double>(r.mean.size()) / search.bins_per_turn;
  const double slowest = std::max(search.fewest_periods / turns, search.least_periods_per_turn);
  const auto first = static_cast<std::size_t>(std::ceil(slowest / per_index));
  std::size_t best = 0;
  // Bins resolve periods up to a few of them; towards half their number sines look alike.
  const auto last = static_cast<std::size_t>(search.most_periods_per_turn / per_index);
  for (std::size_t k = first; k <= last; ++k) {
    if (best == 0 || std::norm(spectrum[k]) > std::norm(spectrum[best])) best = k;
  }
  if (best == 0) return std::nullopt;
  if (out_of_neighbours &&
      std::norm(spectrum[best]) < line_evidence * power_around(spectrum, best, padding)) {
    return std::nullopt;
  }
  double low = (static_cast<double>(best) - 1) * per_index;
  double high = (static_cast<double>(best) + 1) * per_index;
  for (int step = 0; step < 40; ++step) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    (line_at(r, a).amplitude_Nm < line_at(r, b).amplitude_Nm ? low : high) =
        line_at(r, a).amplitude_Nm < line_at(r, b).amplitude_Nm ? a : b;
  }
  return line_at(r, (low + high) / 2);
}

void take_out(const RippleLine& line, BinnedResidual& r) {
  for (std::size_t b = 0; b < r.mean.size(); ++b) {
    if (r.count[b] == 0) continue;
    r.mean[b] -= line.amplitude_Nm * std::cos(line.periods_per_turn * r.angle(b) + line.phase_rad);
  }
}

}  // namespace

double Ripple::torque_Nm(double motor_angle_rad) const {
  double sum = 0;
  for (const RippleLine& line : lines) {
    sum += line.amplitude_Nm * std::cos(line.periods_per_turn * motor_angle_rad + line.phase_rad);
  }
  return sum;
}

double Ripple::half_width_Nm() const {
  std::vector<double> amplitudes;
  for (const RippleLine& line : lines) amplitudes.push_back(line.amplitude_Nm);
  return random_phase_half_width(amplitudes, rest_Nm);
}

double Ripple::sd_Nm() const {
  double squares = rest_Nm * rest_Nm;
  for (const RippleLine& line : lines) squares += line.amplitude_Nm * line.amplitude_Nm / 2;
  return std::sqrt(squares);
}

std::optional<RippleLine> find_strongest_line(const std::vector<double>& motor_angle_rad,
                                              const std::vector<double>& residual_Nm,
                                              double white_variance, const RippleSearch& search) {
  if (motor_angle_rad.empty()) return std::nullopt;
  const BinnedResidual binned = bin_residual(motor_angle_rad, residual_Nm, search.bins_per_turn);
  std::optional<RippleLine> line = strongest_line(binned, search, true);
  if (!line) return std::nullopt;
  const double noise = 2 * std::max(white_variance, 1e-300) / binned.samples;
  if (line->amplitude_Nm * line->amplitude_Nm / 2 / noise < line_evidence) return std::nullopt;
  const double half_bin = line->periods_per_turn * binned.width_rad / 2;
  line->amplitude_Nm *= half_bin / std::sin(half_bin);  // a bin averages over its width
  return line;
}

Ripple find_ripple(const std::vector<double>& motor_angle_rad,
                   const std::vector<double>& residual_Nm, double ripple_Nm, double white_variance,
                   const RippleSearch& search) {
  Ripple out;
  out.rest_Nm = ripple_Nm;
  if (!(ripple_Nm > 0) || motor_angle_rad.empty()) return out;
  constexpr double least_share = 0.02;  // of the ripple's variance
  BinnedResidual binned = bin_residual(motor_angle_rad, residual_Nm, search.bins_per_turn);
  double left = ripple_Nm * ripple_Nm;
  while (out.lines.size() < most_lines) {
    const std::optional<RippleLine> found = strongest_line(binned, search);
    if (!found) break;
    const double power = found->amplitude_Nm * found->amplitude_Nm / 2;
    const double noise = 2 * std::max(white_variance, 1e-300) / binned.samples;
    if (power < least_share * ripple_Nm * ripple_Nm || power / noise < line_evidence) break;
    take_out(*found, binned);
    RippleLine line = *found;
    // A bin averages over its width.
    const double half_bin = line.periods_per_turn * binned.width_rad / 2;
    line.amplitude_Nm *= half_bin / std::sin(half_bin);
    out.lines.push_back(line);
    left -= power;
  }
  std::sort(out.lines.begin(), out.lines.end(), [](const RippleLine& a, const RippleLine& b) {
    return a.amplitude_Nm > b.amplitude_Nm;
  });
  // What the lines leave within the error of the two variances is nothing.
  constexpr double nothing = 0.02;
  out.rest_Nm = left > nothing * ripple_Nm * ripple_Nm ? std::sqrt(left) : 0.0;
  return out;
}

statistics::Estimate with_ripple(const statistics::Estimate& torque_Nm, const Ripple& ripple) {
  const double half_width = ripple.half_width_Nm();
  if (!(half_width > 0)) return torque_Nm;
  return statistics::symmetric_estimate(
      torque_Nm.value, std::hypot(torque_Nm.half_width(), half_width),
      {"interval.widened_by_sweep_ripple", {{"interval", torque_Nm.method}}});
}

double random_phase_half_width(const std::vector<double>& amplitudes, double normal_sd) {
  double sum = 0;
  for (const double a : amplitudes) sum += a;
  if (sum == 0) return 1.959963984540054 * normal_sd;
  constexpr std::size_t draws = 4000;  // the quantile to about 1 %
  statistics::RandomStream random(4000, 1);
  std::vector<double> sizes(draws);
  for (double& size : sizes) {
    double value = normal_sd > 0 ? normal_sd * random.normal() : 0.0;
    for (const double a : amplitudes) value += a * std::cos(2 * pi * random.uniform());
    size = std::abs(value);
  }
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.95 * draws);
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

}  // namespace tribolog::method::gravity
