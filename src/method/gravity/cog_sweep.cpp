#include "method/gravity/cog_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "joint/degrees.h"
#include "method/gravity/sweep_curves.h"
#include "method/gravity/sweep_readings.h"
#include "method/gravity/sweep_regression.h"
#include "method/motion/sweep_samples.h"
#include "statistics/block_regression.h"

namespace tribolog::method::gravity {
namespace {

constexpr std::size_t fewest_samples = 20;

/// The angle, by whole turns, that is nearest to `middle`.
double nearest_turn(double q, double middle) {
  return q - 2 * std::numbers::pi * std::round((q - middle) / (2 * std::numbers::pi));
}

std::vector<std::size_t> blocks_of_strokes(const motion::SweepSamples& samples) {
  const std::size_t strokes = samples.stroke.back() + 1;
  return statistics::equal_blocks(samples.stroke, std::max<std::size_t>(4, 40 / strokes));
}

/// Friction and offset of a joint that no gravity loads.
void read_without_gravity(const motion::Sweep& sweep, double gear_ratio, CogSweepResult& out) {
  const motion::SweepSamples& samples = sweep.samples;
  const SweepDesign design = sweep_design(sweep, 0);
  SweepGravityFit fit;
  fit.regression = statistics::block_regression(design.x, design.y, blocks_of_strokes(samples));
  out.residual_Nm = fit.regression.residual_sd;
  out.white_Nm = std::sqrt(white_torque_variance(sweep));
  out.method = samples.constant_speed ? Code{"sweep_fit.constant_speed_without_gravity"}
                                      : Code{"sweep_fit.varying_speed_without_gravity"};
  read_friction(design, samples, fit, gear_ratio, out);
  out.stage.state = statistics::StageState::skipped;
  out.stage.reason = {"gravity.stated_none"};
  if (!samples.both_directions()) return;
  const Eigen::VectorXd gradient = offset_gradient(design, samples);
  out.offset_Nm = gradient.dot(fit.regression.coefficients);
  out.torque_offset_Nm = statistics::symmetric_estimate(
      out.offset_Nm, fit.regression.half_width_along(gradient), {"interval.least_squares_blocks"});
}

/// Finds ripple and vibration in the residuals, and fits without them.
SweepGravityFit fit_without_lines(const motion::Sweep& sweep, double gear_ratio, double middle,
                                  const std::vector<std::size_t>& blocks,
                                  const SweepGravityFit& first, SweepDesign& design,
                                  CogSweepResult& out) {
  const double white = white_torque_variance(sweep);
  out.white_Nm = std::sqrt(white);
  const Eigen::VectorXd left =
      rough_residuals(sweep, first.regression.residuals, out, first.q_peak_rad.value);
  const double sd = std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
  const double beyond_white = torque_ripple_Nm(sd, white);
  if (!(beyond_white > 0)) return first;
  ResidualCauses causes = find_residual_causes(sweep, std::vector<double>(left.begin(), left.end()),
                                               gear_ratio, beyond_white, white);
  out.ripple_Nm = causes.ripple.sd_Nm();
  out.ripple = std::move(causes.ripple);
  out.vibration = std::move(causes.vibration);
  out.coloured_Nm = causes.coloured_Nm;
  out.friction_by_angle_Nm = causes.friction.sd_Nm();
  out.friction_of_angle = std::move(causes.friction);
  const Eigen::Map<const Eigen::VectorXd> torque(causes.lines_Nm.data(),
                                                 static_cast<Eigen::Index>(causes.lines_Nm.size()));
  if (torque.isZero(0)) return first;
  design.y -= torque;
  SweepGravityFit fit = fit_amplitude_and_angle(sweep, design, middle, blocks);
  fit.regression.residuals += torque;  // what the smooth fit leaves
  return fit;
}

/// The samples used, and the range of all.
SweepCurves curves_without_fit(const motion::Sweep& sweep) {
  SweepCurves curves;
  curves.used = sweep.used();
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const joint::Recording* recording : sweep.recordings) {
    for (const double q_rad : recording->q_rad) {
      if (!std::isfinite(q_rad)) continue;
      lowest = std::min(lowest, q_rad);
      highest = std::max(highest, q_rad);
    }
  }
  if (lowest < highest) {
    curves.lowest_rad = lowest;
    curves.highest_rad = highest;
  }
  return curves;
}

/// The trough, half a turn from the peak, determines the angle as well as the peak does.
bool crosses_peak_or_trough(const CogSweepResult& sweep) {
  const double middle = (sweep.lowest_rad + sweep.highest_rad) / 2;
  const double away = std::remainder(sweep.q_peak_rad.value - middle, std::numbers::pi);
  return std::abs(away) <= (sweep.highest_rad - sweep.lowest_rad) / 2;
}

/// The equation whose coefficients were fitted.
Code equation_of(bool constant_speed, bool amplitude_known) {
  if (constant_speed) {
    return amplitude_known ? Code{"sweep_fit.constant_speed_known_gravity"}
                           : Code{"sweep_fit.constant_speed"};
  }
  return amplitude_known ? Code{"sweep_fit.varying_speed_known_gravity"}
                         : Code{"sweep_fit.varying_speed"};
}

}  // namespace

std::string to_string(SweepKind kind) {
  return kind == SweepKind::rough ? "cog_rough" : "cog_precise";
}

std::string to_string(PeakSource source) {
  if (source == PeakSource::model) return "model";
  return to_string(source == PeakSource::rough_sweep ? SweepKind::rough : SweepKind::precise);
}

CogSweep identify_cog_sweep(SweepKind kind, const motion::Sweep& sweep, double gear_ratio,
                            bool has_gravity, const std::optional<KnownGravity>& known) {
  const bool precise = kind == SweepKind::precise;
  CogSweep made;
  CogSweepResult& out = made.result;
  if (sweep.recordings.empty()) {
    const Code not_recorded =
        precise ? Code{"gravity.no_precise_sweep"} : Code{"gravity.no_rough_sweep"};
    out.stage = {to_string(kind), statistics::StageState::skipped,
                 has_gravity ? not_recorded : Code{"gravity.stated_none"}};
    return made;
  }
  made.curves = curves_without_fit(sweep);
  const motion::SweepSamples& samples = sweep.samples;
  out.samples_used = samples.size();
  out.samples_left_out = samples.left_out;
  out.constant_speed = samples.constant_speed;
  out.both_directions = samples.both_directions();
  out.stage = {to_string(kind), statistics::StageState::not_identifiable, {}};
  if (samples.size() < fewest_samples) {
    out.stage.reason = {"gravity.too_few_samples",
                        {{"samples", samples.size()}, {"needed", fewest_samples}}};
    return made;
  }
  out.lowest_rad = out.highest_rad = sweep.q_rad(0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double q = sweep.q_rad(i);
    out.lowest_rad = std::min(out.lowest_rad, q);
    out.highest_rad = std::max(out.highest_rad, q);
  }
  const double range = out.highest_rad - out.lowest_rad;
  if (!(range > 1e-6)) {
    out.stage.reason = {"gravity.hardly_moves", {{"travel_rad", range}}};
    return made;
  }

  if (!has_gravity) {
    read_without_gravity(sweep, gear_ratio, out);
    return made;
  }
  const double middle = (out.lowest_rad + out.highest_rad) / 2;
  SweepDesign design = sweep_design(sweep, known ? 1 : 2);
  const std::vector<std::size_t> blocks = blocks_of_strokes(samples);
  // Half a turn from the peak the same amplitude bends the torque the other way.
  const bool near_trough = known && std::cos(middle - known->q_peak_rad) < 0;
  const double start = near_trough ? middle + std::numbers::pi : middle;
  SweepGravityFit fit = known ? fit_angle(sweep, design, start, known->amplitude_Nm, blocks)
                              : fit_amplitude_and_angle(sweep, design, middle, blocks);
  out.residual_Nm = fit.regression.residual_sd;
  if (known) {
    out.ripple_Nm = torque_ripple_Nm(out.residual_Nm, white_torque_variance(sweep));
  } else {
    fit = fit_without_lines(sweep, gear_ratio, middle, blocks, fit, design, out);
  }
  const double turn = nearest_turn(fit.q_peak_rad.value, middle) - fit.q_peak_rad.value;
  out.q_peak_rad = {fit.q_peak_rad.value + turn, fit.q_peak_rad.low + turn,
                    fit.q_peak_rad.high + turn, fit.q_peak_rad.method};
  out.gravity_Nm = fit.gravity_Nm;
  out.method = equation_of(samples.constant_speed, known.has_value());
  read_friction(design, samples, fit, gear_ratio, out);
  read_offset(design, samples, fit, out);
  // 13.8 would be a chance of 0.1 % without gravity if the covariance were known; it is estimated
  // from few blocks, hence twice that. Not-a-number (a perfect fit) passes.
  constexpr double least_evidence = 27;
  const bool shows_amplitude = fit.gravity_Nm.low > 0;
  if (!shows_amplitude || fit.evidence < least_evidence) {
    out.stage.reason = {"gravity.not_shown",
                        {{"gravity_Nm", out.gravity_Nm.value},
                         {"low_Nm", out.gravity_Nm.low},
                         {"high_Nm", out.gravity_Nm.high},
                         {"travel_deg", range * joint::degrees_per_rad}}};
    return made;
  }
  find_torque_maximum(sweep, out);
  out.found = true;
  out.stage.state = statistics::StageState::done;
  if (!out.both_directions) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = {"gravity.one_direction"};
  } else if (!precise && !crosses_peak_or_trough(out)) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = {"gravity.peak_not_crossed",
                        {{"lowest_deg", out.lowest_rad * joint::degrees_per_rad},
                         {"highest_deg", out.highest_rad * joint::degrees_per_rad},
                         {"peak_deg", out.q_peak_rad.value * joint::degrees_per_rad}}};
  }
  add_fit_curves(sweep, fit.regression.residuals, out, made.curves);
  return made;
}

}  // namespace tribolog::method::gravity
