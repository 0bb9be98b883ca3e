#include "stages/cog_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "stages/block_regression.h"
#include "stages/sweep_curves.h"
#include "stages/sweep_samples.h"

namespace tribolog {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr std::size_t fewest_samples = 20;

/// Columns of the regression T = X c. `gravity_cos` and `gravity_sin` may be absent.
struct Design {
  Eigen::MatrixXd x;
  Eigen::VectorXd y;
  Eigen::Index offsets{};  // first column of the offsets
  Eigen::Index offset_count{};
  Eigen::Index direction{-1};  // Coulomb column of a varying sweep
  Eigen::Index speed{-1};
  Eigen::Index acceleration{-1};
  std::vector<std::size_t> offset_of_sample;
};

/// `gravity_columns` columns are left free at the front for cos/sin or the angle alone.
Design make_design(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
                   Eigen::Index gravity_columns) {
  Design d;
  const auto rows = static_cast<Eigen::Index>(samples.size());
  const bool both = samples.both_directions();
  d.offset_of_sample.resize(samples.size(), 0);
  d.offset_count = 1;
  Eigen::Index extra = 0;
  if (samples.constant_speed) {
    // One offset for each stroke direction of each recording: its own friction.
    std::vector<std::pair<std::size_t, double>> seen;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::pair key{samples.recording[i], samples.direction[i]};
      const auto at = std::find(seen.begin(), seen.end(), key);
      d.offset_of_sample[i] = static_cast<std::size_t>(at - seen.begin());
      if (at == seen.end()) seen.push_back(key);
    }
    d.offset_count = static_cast<Eigen::Index>(seen.size());
  } else {
    extra = both ? 3 : 2;  // direction (with both), speed, acceleration
  }
  d.offsets = gravity_columns;
  d.x = Eigen::MatrixXd::Zero(rows, gravity_columns + d.offset_count + extra);
  d.y.resize(rows);
  if (!samples.constant_speed) {
    Eigen::Index next = gravity_columns + d.offset_count;
    if (both) d.direction = next++;
    d.speed = next++;
    d.acceleration = next;
  }
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    d.y(row) = recordings[samples.recording[i]]->torque_Nm[samples.index[i]];
    d.x(row, d.offsets + static_cast<Eigen::Index>(d.offset_of_sample[i])) = 1;
    if (d.direction >= 0) d.x(row, d.direction) = samples.direction[i];
    if (d.speed >= 0) d.x(row, d.speed) = samples.speed_rad_s[i];
    if (d.acceleration >= 0) d.x(row, d.acceleration) = samples.acceleration_rad_s2[i];
  }
  return d;
}

struct GravityFit {
  Estimate q_peak_rad;
  Estimate gravity_Nm;
  /// Chi-square of "there is no gravity" with two degrees of freedom. The amplitude alone cannot
  /// tell: noise too has a positive one.
  double evidence{};
  BlockRegression regression;
};

double angle(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
             std::size_t i) {
  return recordings[samples.recording[i]]->q_rad[samples.index[i]];
}

/// Amplitude and angle together: columns cos(q - q0), sin(q - q0) about the sweep's middle q0.
GravityFit fit_amplitude_and_angle(const std::vector<const Recording*>& recordings,
                                   const SweepSamples& samples, Design& d, double middle,
                                   const std::vector<std::size_t>& blocks) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double q = angle(recordings, samples, i) - middle;
    // 1 - cos q as 2 sin^2(q/2): no cancellation in a sweep of one degree.
    const double half = std::sin(q / 2);
    d.x(static_cast<Eigen::Index>(i), 0) = -2 * half * half;
    d.x(static_cast<Eigen::Index>(i), 1) = std::sin(q);
  }
  GravityFit fit;
  fit.regression = block_regression(d.x, d.y, blocks);
  const double b = fit.regression.coefficients(0);
  const double c = fit.regression.coefficients(1);
  const auto& v = fit.regression.covariance;
  const double g = std::hypot(b, c);
  const double t = fit.regression.t_factor;
  const Eigen::Vector2d bc(b, c);
  const Eigen::Matrix2d v2 = v.topLeftCorner<2, 2>();
  fit.evidence = bc.dot(v2.ldlt().solve(bc));
  const double var_q = (c * c * v(0, 0) - 2 * b * c * v(0, 1) + b * b * v(1, 1)) / std::pow(g, 4);
  const double var_g = (b * b * v(0, 0) + 2 * b * c * v(0, 1) + c * c * v(1, 1)) / (g * g);
  const char* method = "least squares, blocks of neighbouring samples";
  fit.q_peak_rad =
      symmetric_estimate(middle + std::atan2(c, b), t * std::sqrt(std::max(0.0, var_q)), method);
  fit.gravity_Nm = symmetric_estimate(g, t * std::sqrt(std::max(0.0, var_g)), method);
  // The offsets were fitted against cos q - 1: what belongs to gravity is taken out of them.
  for (Eigen::Index k = 0; k < d.offset_count; ++k) {
    fit.regression.coefficients(d.offsets + k) -= b;
  }
  return fit;
}

/// The angle alone, the amplitude being known: Gauss-Newton on T = offset + G cos(q - q_peak).
GravityFit fit_angle(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
                     Design& d, double middle, const Estimate& gravity,
                     const std::vector<std::size_t>& blocks) {
  const Eigen::VectorXd torque = d.y;
  double q_peak = middle;
  GravityFit fit;
  for (int iteration = 0; iteration < 20; ++iteration) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double q = angle(recordings, samples, i) - q_peak;
      const auto row = static_cast<Eigen::Index>(i);
      d.y(row) = torque(row) - gravity.value * std::cos(q);
      d.x(row, 0) = gravity.value * std::sin(q);
    }
    fit.regression = block_regression(d.x, d.y, blocks);
    const double step = std::clamp(fit.regression.coefficients(0), -0.5, 0.5);
    q_peak += step;
    if (std::abs(step) < 1e-13) break;
  }
  const double from_noise =
      fit.regression.t_factor * std::sqrt(std::max(0.0, fit.regression.covariance(0, 0)));
  // An amplitude off by a share shifts the angle by that share of its distance from the middle.
  const double from_amplitude = (q_peak - middle) * gravity.half_width() / gravity.value;
  fit.q_peak_rad = symmetric_estimate(q_peak, std::hypot(from_noise, from_amplitude),
                                      "least squares with the amplitude of the rough sweep");
  fit.gravity_Nm = gravity;
  fit.evidence = std::numeric_limits<double>::infinity();  // the rough sweep has shown it
  return fit;
}

/// The representative of an angle that is nearest to `middle`.
double nearest_turn(double q, double middle) {
  return q - 2 * std::numbers::pi * std::round((q - middle) / (2 * std::numbers::pi));
}

void find_argmax(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
                 CogSweepResult& out) {
  std::size_t best = 0;
  const auto torque = [&](std::size_t i) {
    return recordings[samples.recording[i]]->torque_Nm[samples.index[i]];
  };
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (torque(i) > torque(best)) best = i;
  }
  out.argmax_rad = angle(recordings, samples, best);
  out.argmax_torque_Nm = torque(best);
  // Among N noisy samples the largest exceeds the curve by about sd sqrt(2 ln N); the curve may lie
  // lower by as much at the true peak's neighbours. Never narrower than the sampling.
  const double excess =
      out.residual_Nm * std::sqrt(2 * std::log(static_cast<double>(samples.size())));
  const double spacing =
      std::abs(samples.speed_rad_s[best]) *
      (recordings[samples.recording[best]]->t_s[1] - recordings[samples.recording[best]]->t_s[0]);
  const double reach =
      std::acos(std::clamp(1 - excess / out.gravity_Nm.value, -1.0, 1.0)) + spacing;
  out.argmax_low_rad = std::max(out.argmax_rad - reach, std::min(out.lowest_rad, out.argmax_rad));
  out.argmax_high_rad = std::min(out.argmax_rad + reach, std::max(out.highest_rad, out.argmax_rad));
  const double edge = 0.01 * (out.highest_rad - out.lowest_rad);
  out.argmax_at_end =
      out.argmax_rad - out.lowest_rad < edge || out.highest_rad - out.argmax_rad < edge;
}

void read_friction(const Design& d, const SweepSamples& samples, const GravityFit& fit,
                   double gear_ratio, CogSweepResult& out) {
  const Eigen::VectorXd& c = fit.regression.coefficients;
  const auto half_width = [&](Eigen::Index k) {
    return fit.regression.t_factor * std::sqrt(std::max(0.0, fit.regression.covariance(k, k)));
  };
  const char* method = "least squares, blocks of neighbouring samples";
  if (!samples.constant_speed) {
    out.offset_Nm = c(d.offsets);
    if (d.direction >= 0) {
      out.coulomb_Nm = symmetric_estimate(c(d.direction), half_width(d.direction), method);
    }
    out.viscous_Nms_rad =
        symmetric_estimate(c(d.speed) / gear_ratio, half_width(d.speed) / gear_ratio, method);
    out.inertia_kgm2 = symmetric_estimate(c(d.acceleration) / gear_ratio,
                                          half_width(d.acceleration) / gear_ratio, method);
    return;
  }
  // Mean of the rising and of the falling offsets.
  double up = 0;
  double down = 0;
  double variance = 0;
  std::vector<double> direction_of(static_cast<std::size_t>(d.offset_count), 0.0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    direction_of[d.offset_of_sample[i]] = samples.direction[i];
  }
  const auto ups = static_cast<double>(std::count(direction_of.begin(), direction_of.end(), 1.0));
  const auto downs = static_cast<double>(direction_of.size()) - ups;
  for (std::size_t k = 0; k < direction_of.size(); ++k) {
    const Eigen::Index column = d.offsets + static_cast<Eigen::Index>(k);
    (direction_of[k] > 0 ? up : down) += c(column);
    variance +=
        fit.regression.covariance(column, column) / std::pow(direction_of[k] > 0 ? ups : downs, 2);
  }
  if (ups > 0 && downs > 0) {
    up /= ups;
    down /= downs;
    out.offset_Nm = (up + down) / 2;
    out.coulomb_Nm = symmetric_estimate(
        (up - down) / 2, fit.regression.t_factor * std::sqrt(std::max(0.0, variance)) / 2, method);
  }
}

/// Variance of the white noise from third differences of neighbouring samples, in which everything
/// slower than a few samples drops out.
double white_variance(const std::vector<const Recording*>& recordings,
                      const SweepSamples& samples) {
  double squares = 0;
  double count = 0;
  for (std::size_t i = 3; i < samples.size(); ++i) {
    const bool neighbours = samples.recording[i - 3] == samples.recording[i] &&
                            samples.index[i - 3] + 3 == samples.index[i];
    if (!neighbours) continue;
    const double* t = &recordings[samples.recording[i]]->torque_Nm[samples.index[i] - 3];
    const double third = t[3] - 3 * t[2] + 3 * t[1] - t[0];
    squares += third * third;
    count += 1;
  }
  constexpr double gain = 20;  // 1 + 9 + 9 + 1
  return count > 0 ? squares / (gain * count) : 0.0;
}

/// What the residual holds beyond white noise; 0 below what sampling of the two variances explains.
double ripple_of(double residual_sd, double white) {
  constexpr double least_share = 0.05;
  const double rest = residual_sd * residual_sd - white;
  return rest > least_share * white ? std::sqrt(rest) : 0.0;
}

CogSweepResult skipped(const std::string& name, std::string reason, StageState state) {
  CogSweepResult out;
  out.stage = {name, state, std::move(reason)};
  return out;
}

}  // namespace

CogSweepResult identify_cog_sweep(const std::string& name,
                                  const std::vector<const Recording*>& recordings,
                                  double gear_ratio, const std::optional<Estimate>& gravity_Nm) {
  const bool precise = name == "cog_precise";
  if (recordings.empty()) {
    return skipped(name,
                   precise ? "no precise_sweep was recorded; a slow sweep of about 1° to each side "
                             "of the gravity peak would be one"
                           : "no rough_sweep was recorded; a slow sweep over the joint's range in "
                             "both directions would give the angle of the centre of gravity and "
                             "the gravity torque",
                   StageState::skipped);
  }
  CogSweepResult out;
  out.recordings = recordings;
  const SweepSamples samples = select_sweep_samples(recordings);
  out.samples_used = samples.size();
  out.samples_left_out = samples.left_out;
  out.constant_speed = samples.constant_speed;
  out.both_directions = samples.both_directions();
  for (const Recording* recording : recordings) out.used.emplace_back(recording->size(), false);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    out.used[samples.recording[i]][samples.index[i]] = true;
  }
  out.stage = {name, StageState::not_identifiable, ""};
  if (samples.size() < fewest_samples) {
    out.stage.reason =
        fmt::format("only {} samples of the sweep move steadily; at least {} are needed",
                    samples.size(), fewest_samples);
    return out;
  }
  out.lowest_rad = out.highest_rad = angle(recordings, samples, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double q = angle(recordings, samples, i);
    out.lowest_rad = std::min(out.lowest_rad, q);
    out.highest_rad = std::max(out.highest_rad, q);
  }
  const double range = out.highest_rad - out.lowest_rad;
  if (!(range > 1e-6)) {
    out.stage.reason = fmt::format("the joint moves by {:.2g} rad only", range);
    return out;
  }

  const double middle = (out.lowest_rad + out.highest_rad) / 2;
  const bool amplitude_known = gravity_Nm.has_value() && gravity_Nm->value > 0;
  Design design = make_design(recordings, samples, amplitude_known ? 1 : 2);
  const std::size_t strokes = samples.stroke.back() + 1;
  const std::vector<std::size_t> blocks =
      equal_blocks(samples.stroke, std::max<std::size_t>(4, 40 / strokes));
  GravityFit fit = amplitude_known
                       ? fit_angle(recordings, samples, design, middle, *gravity_Nm, blocks)
                       : fit_amplitude_and_angle(recordings, samples, design, middle, blocks);
  const double turn = nearest_turn(fit.q_peak_rad.value, middle) - fit.q_peak_rad.value;
  out.q_peak_rad = {fit.q_peak_rad.value + turn, fit.q_peak_rad.low + turn,
                    fit.q_peak_rad.high + turn, fit.q_peak_rad.method};
  out.gravity_Nm = fit.gravity_Nm;
  out.residual_Nm = fit.regression.residual_sd;
  out.ripple_Nm = ripple_of(out.residual_Nm, white_variance(recordings, samples));
  out.method = samples.constant_speed
                   ? "T = offset of each direction + G cos(q - q_peak)"
                   : "T = offset + Coulomb sgn(q') + viscous q' + inertia q'' + G cos(q - q_peak)";
  if (amplitude_known) out.method += ", G from the rough sweep";
  read_friction(design, samples, fit, gear_ratio, out);

  // 13.8 would be a chance of 0.1 % without gravity if the covariance were known; it is estimated
  // from few blocks, hence twice that. Not-a-number (a perfect fit) passes.
  constexpr double least_evidence = 27;
  if (!(out.gravity_Nm.low > 0) || fit.evidence < least_evidence) {
    out.stage.reason = fmt::format(
        "gravity does not show: amplitude {:.3g} N·m with a 95 % interval from {:.3g} to {:.3g} "
        "N·m over {:.1f}° of travel; sweep further, or load the joint",
        out.gravity_Nm.value, out.gravity_Nm.low, out.gravity_Nm.high, range * degrees);
    return out;
  }
  find_argmax(recordings, samples, out);
  out.found = true;
  out.stage.state = StageState::done;
  if (!out.both_directions) {
    out.stage.state = StageState::partial;
    out.stage.reason =
        "only one direction was recorded: friction does not cancel, and a friction that changes "
        "with the angle would be taken for gravity";
  } else if (!precise &&
             (out.q_peak_rad.value < out.lowest_rad || out.q_peak_rad.value > out.highest_rad)) {
    out.stage.state = StageState::partial;
    out.stage.reason = fmt::format(
        "the sweep from {:.1f}° to {:.1f}° does not cross the gravity peak, which is "
        "extrapolated to {:.1f}°; the arg-max of the paper is not valid there",
        out.lowest_rad * degrees, out.highest_rad * degrees, out.q_peak_rad.value * degrees);
  }
  add_fit_curves(recordings, samples, fit.regression.residuals, out);
  return out;
}

}  // namespace tribolog
