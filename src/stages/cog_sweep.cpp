#include "stages/cog_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "stages/block_regression.h"
#include "stages/sweep_curves.h"
#include "stages/sweep_load.h"
#include "stages/sweep_noise.h"
#include "stages/sweep_regression.h"
#include "stages/sweep_samples.h"
#include "stages/torque_maximum.h"

namespace tribolog {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr std::size_t fewest_samples = 20;

/// The representative of an angle that is nearest to `middle`.
double nearest_turn(double q, double middle) {
  return q - 2 * std::numbers::pi * std::round((q - middle) / (2 * std::numbers::pi));
}

void read_friction(const SweepDesign& d, const SweepSamples& samples, const SweepGravityFit& fit,
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
    if (d.load >= 0) {
      out.unloaded_coulomb_Nm = out.coulomb_Nm;
      out.load_coulomb_Nm = symmetric_estimate(c(d.load), half_width(d.load), method);
      const double load = d.x.col(d.load).cwiseAbs().mean();
      const auto& v = fit.regression.covariance;
      const double variance = v(d.direction, d.direction) + 2 * load * v(d.direction, d.load) +
                              load * load * v(d.load, d.load);
      out.coulomb_Nm =
          symmetric_estimate(c(d.direction) + load * c(d.load),
                             fit.regression.t_factor * std::sqrt(std::max(0.0, variance)), method);
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
  out.lowest_rad = out.highest_rad = angle_of(recordings, samples, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double q = angle_of(recordings, samples, i);
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
  SweepDesign design = sweep_design(recordings, samples, amplitude_known ? 1 : 2);
  const std::size_t strokes = samples.stroke.back() + 1;
  const std::vector<std::size_t> blocks =
      equal_blocks(samples.stroke, std::max<std::size_t>(4, 40 / strokes));
  SweepGravityFit fit = amplitude_known
                            ? fit_angle(recordings, samples, design, middle, *gravity_Nm, blocks)
                            : fit_amplitude_and_angle(recordings, samples, design, middle, blocks);
  if (!amplitude_known) {
    fit = with_load_where_it_pays(recordings, samples, design, middle, blocks, fit);
  }
  const double turn = nearest_turn(fit.q_peak_rad.value, middle) - fit.q_peak_rad.value;
  out.q_peak_rad = {fit.q_peak_rad.value + turn, fit.q_peak_rad.low + turn,
                    fit.q_peak_rad.high + turn, fit.q_peak_rad.method};
  out.gravity_Nm = fit.gravity_Nm;
  out.residual_Nm = fit.regression.residual_sd;
  out.ripple_Nm = torque_ripple_Nm(out.residual_Nm, white_torque_variance(recordings, samples));
  out.method = samples.constant_speed
                   ? "T = offset of each direction + G cos(q - q_peak)"
                   : "T = offset + Coulomb sgn(q') + viscous q' + inertia q'' + G cos(q - q_peak)";
  if (design.load >= 0) out.method += " + Coulomb of the load sgn(q') |cos(q - q_peak)|";
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
  find_torque_maximum(recordings, samples, out);
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
