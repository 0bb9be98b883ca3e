#include "method/gravity/cog_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "joint/degrees.h"
#include "method/gravity/sweep_curves.h"
#include "method/gravity/sweep_lines.h"
#include "method/gravity/sweep_readings.h"
#include "method/gravity/sweep_regression.h"
#include "method/gravity/sweep_terms.h"
#include "method/gravity/sweep_widening.h"
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
  read_strokes(samples, fit, out);
  out.stage.state = statistics::StageState::skipped;
  out.stage.reason = {"gravity.stated_none"};
  if (!samples.both_directions()) return;
  const Eigen::VectorXd gradient = offset_gradient(design, samples);
  out.offset_Nm = gradient.dot(fit.regression.coefficients);
  out.torque_offset_Nm = statistics::symmetric_estimate(
      out.offset_Nm, fit.regression.half_width_along(gradient), {"interval.least_squares_blocks"});
}

SweepBlocks blocks_of(const SweepDesign& design, const motion::SweepSamples& samples,
                      const SweepGravityFit& fit) {
  SweepBlocks kept;
  const Eigen::MatrixXd& shifts = fit.block_shifts;
  const Eigen::RowVectorXd coulomb =
      direction_contrast(design, samples).transpose() * fit.regression.block_shifts;
  Eigen::VectorXd gradient = offset_gradient(design, samples);
  if (design.offsets > 1) gradient(0) = -1;
  const Eigen::RowVectorXd offset = gradient.transpose() * fit.regression.block_shifts;
  for (Eigen::Index b = 0; b < shifts.cols(); ++b) {
    kept.shifts.push_back({shifts(0, b), shifts(1, b), coulomb(b), shifts(2, b), offset(b)});
  }
  kept.freedom = fit.freedom;
  return kept;
}

/// Noise that is correlated for longer than a block is larger than the blocks show. Longer blocks,
/// though fewer, show it: the wider of the two intervals is stated.
SweepGravityFit with_longer_blocks_where_coloured(const motion::Sweep& sweep, SweepDesign& design,
                                                  double middle, const SweepGravityFit& fit,
                                                  const CogSweepResult& out) {
  constexpr double noticeable = 0.1;
  if (!(out.coloured_Nm > noticeable * out.white_Nm)) return fit;
  const std::size_t strokes = sweep.samples.stroke.back() + 1;
  constexpr std::size_t in_all = 10;
  const std::size_t per_stroke = std::max<std::size_t>(2, in_all / strokes);
  SweepGravityFit longer = fit_amplitude_and_angle(
      sweep, design, middle, statistics::equal_blocks(sweep.samples.stroke, per_stroke));
  longer.regression.residuals = fit.regression.residuals;
  return longer.q_peak_rad.half_width() > fit.q_peak_rad.half_width() ? longer : fit;
}

/// Strokes over the same angles repeat the model's error there, which blocks of neighbouring
/// samples do not show. Blocks of the angle do: the wider of the two intervals is stated.
SweepGravityFit with_the_wider_blocks(const motion::Sweep& sweep, SweepDesign& design,
                                      double middle, const SweepGravityFit& fit,
                                      const CogSweepResult& range) {
  const motion::SweepSamples& samples = sweep.samples;
  constexpr double cells = 20;
  std::vector<std::size_t> by_angle(samples.size());
  const double width = (range.highest_rad - range.lowest_rad) / cells;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double place = (sweep.q_rad(i) - range.lowest_rad) / width;
    by_angle[i] = static_cast<std::size_t>(std::clamp(place, 0.0, cells - 1));
  }
  SweepGravityFit other = fit_amplitude_and_angle(sweep, design, middle, by_angle);
  other.regression.residuals = fit.regression.residuals;  // those behind the ripple's lines too
  return other.gravity_Nm.half_width() > fit.gravity_Nm.half_width() ? other : fit;
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
/// The twist, where it is a term, shows in CogSweepResult::twist_rad.
Code equation_of(const SweepDesign& design, bool constant_speed, bool amplitude_known) {
  if (constant_speed) {
    return amplitude_known ? Code{"sweep_fit.constant_speed_known_gravity"}
                           : Code{"sweep_fit.constant_speed"};
  }
  if (amplitude_known) return {"sweep_fit.varying_speed_known_gravity"};
  // Only a fit of the amplitude can have a column for the load.
  return design.load >= 0 ? Code{"sweep_fit.varying_speed_with_load"}
                          : Code{"sweep_fit.varying_speed"};
}

}  // namespace

std::string to_string(SweepKind kind) {
  return kind == SweepKind::rough ? "cog_rough" : "cog_precise";
}

std::string to_string(PeakSource source) {
  switch (source) {
    case PeakSource::rough_sweep:
      return to_string(SweepKind::rough);
    case PeakSource::precise_sweep:
      return to_string(SweepKind::precise);
    case PeakSource::runs:
      break;
  }
  return "runs";
}

CogSweep identify_cog_sweep(SweepKind kind, const motion::Sweep& sweep, double gear_ratio,
                            const KnownOfSweep& known) {
  const std::optional<statistics::Estimate>& gravity_Nm = known.gravity_Nm;
  const bool precise = kind == SweepKind::precise;
  CogSweep made;
  CogSweepResult& out = made.result;
  if (sweep.recordings.empty()) {
    const Code not_recorded =
        precise ? Code{"gravity.no_precise_sweep"} : Code{"gravity.no_rough_sweep"};
    out.stage = {to_string(kind), statistics::StageState::skipped,
                 known.has_no_gravity ? Code{"gravity.stated_none"} : not_recorded};
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

  if (known.has_no_gravity) {
    read_without_gravity(sweep, gear_ratio, out);
    return made;
  }
  const double middle = (out.lowest_rad + out.highest_rad) / 2;
  const bool amplitude_known = gravity_Nm.has_value() && gravity_Nm->value > 0;
  // In a sweep of varying speed the inertia's torque has nearly the same shape.
  const bool knows_inertia = !amplitude_known && !samples.constant_speed && known.inertia_kgm2;
  const bool tells_twist = !amplitude_known && (samples.constant_speed || knows_inertia) &&
                           range >= least_range_for_twist_rad;
  std::optional<double> inertia_at_joint;
  if (knows_inertia) inertia_at_joint = gear_ratio * known.inertia_kgm2->value;
  const double known_twist = known.twist_rad ? known.twist_rad->value : 0.0;
  SweepDesign design = sweep_design(sweep, amplitude_known ? 1 : 2, tells_twist, inertia_at_joint);
  const std::size_t strokes = samples.stroke.back() + 1;
  const std::vector<std::size_t> blocks = blocks_of_strokes(samples);
  if (amplitude_known && known.of_angle) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      design.y(static_cast<Eigen::Index>(i)) -= known.of_angle->torque_Nm(sweep.q_rad(i));
    }
  }
  // Half a turn from the peak the same amplitude bends the torque the other way.
  const bool near_trough = known.q_peak_rad && std::cos(middle - *known.q_peak_rad) < 0;
  const double start = near_trough ? middle + std::numbers::pi : middle;
  SweepGravityFit fit = amplitude_known
                            ? fit_angle(sweep, design, start, *gravity_Nm, known_twist, blocks)
                            : fit_amplitude_and_angle(sweep, design, middle, blocks);
  std::vector<SweepGravityFit> rivals;
  out.residual_Nm = fit.regression.residual_sd;
  if (amplitude_known) {
    out.ripple_Nm = torque_ripple_Nm(out.residual_Nm, white_torque_variance(sweep));
  } else {
    if (!precise) {
      fit = with_kinks_where_they_pay(sweep, design, middle, blocks, fit);
      fit = with_torque_of_angle_where_it_shows(sweep, design, middle, range, blocks, fit,
                                                out.torque_of_angle_left_Nm, rivals);
    }
    fit = with_load_where_it_pays(sweep, design, middle, blocks, fit);
    out.residual_Nm = fit.regression.residual_sd;
    fit = fit_without_lines(sweep, gear_ratio, middle, blocks, fit, design, out, rivals);
    fit = with_longer_blocks_where_coloured(sweep, design, middle, fit, out);
    if (!samples.constant_speed && strokes > 2) {
      fit = with_the_wider_blocks(sweep, design, middle, fit, out);
    }
  }
  bool shows_amplitude = fit.gravity_Nm.low > 0;
  if (!amplitude_known) {
    widen_by_slow_ripple(sweep, design, gear_ratio, middle, out, 1, fit);
    shows_amplitude = fit.gravity_Nm.low > 0;
    // The slowest orders are as a rule the largest: three times those seen, in all.
    widen_by_slow_ripple(sweep, design, gear_ratio, middle, out, std::sqrt(8.0), fit);
    widen_by_torque_step(sweep, design, middle, fit);
    if (knows_inertia) {
      widen_by_inertia(sweep, design, gear_ratio * known.inertia_kgm2->half_width(), middle, fit);
      out.inertia_kgm2 = known.inertia_kgm2;
    }
    hold_rivals(rivals, fit);
  }
  const double turn = nearest_turn(fit.q_peak_rad.value, middle) - fit.q_peak_rad.value;
  out.q_peak_rad = {fit.q_peak_rad.value + turn, fit.q_peak_rad.low + turn,
                    fit.q_peak_rad.high + turn, fit.q_peak_rad.method};
  out.gravity_Nm = fit.gravity_Nm;
  out.twist_rad = fit.twist_rad;
  out.of_angle = torque_of_angle(sweep, design, middle, fit);
  made.blocks = blocks_of(design, samples, fit);
  if (amplitude_known) {
    made.blocks.amplitude_lever = -(fit.q_peak_rad.value - start) / gravity_Nm->value;
    if (known.of_angle) {
      out.q_peak_rad =
          widened(out.q_peak_rad, known.of_angle->slope_half_width_Nm_rad / gravity_Nm->value,
                  "interval.widened_by_torque_of_angle");
    }
    if (known.twist_rad) widen_by_twist(sweep, design, *known.twist_rad, out, made.blocks);
    widen_by_ripple(sweep, design, gear_ratio, known.ripple, out, made.blocks);
  }
  out.method = equation_of(design, samples.constant_speed, amplitude_known);
  read_friction(design, samples, fit, gear_ratio, out);
  read_strokes(samples, fit, out);
  read_offset(design, samples, fit, out);

  if (!amplitude_known && !precise)
    out.unseen_spring = unseen_spring(sweep, design, middle, fit, blocks, out);
  const auto in_place_of_offset =
      amplitude_known ? std::nullopt
                      : torque_in_place_of_offset(sweep, design, middle, fit, blocks, out);
  if (in_place_of_offset) {
    out.offset_of_angle_Nm = in_place_of_offset->amplitude_Nm;
    out.gravity_Nm = statistics::symmetric_estimate(
        out.gravity_Nm.value, out.gravity_Nm.half_width() + in_place_of_offset->on_gravity_Nm,
        {"interval.widened_by_torque_of_angle", {{"interval", out.gravity_Nm.method}}});
  }
  // 13.8 would be a chance of 0.1 % without gravity if the covariance were known; it is estimated
  // from few blocks, hence twice that. Not-a-number (a perfect fit) passes.
  constexpr double least_evidence = 27;
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
