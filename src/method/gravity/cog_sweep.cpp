#include "method/gravity/cog_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "joint/degrees.h"
#include "method/gravity/sweep_curves.h"
#include "method/gravity/sweep_regression.h"
#include "method/motion/encoder_resolution.h"
#include "method/motion/sweep_samples.h"
#include "statistics/block_regression.h"
#include "statistics/distributions.h"

namespace tribolog::method::gravity {
namespace {

constexpr std::size_t fewest_samples = 20;

/// The angle, by whole turns, that is nearest to `middle`.
double nearest_turn(double q, double middle) {
  return q - 2 * std::numbers::pi * std::round((q - middle) / (2 * std::numbers::pi));
}

/// Half the mean of the rising offsets less that of the falling ones, as a linear combination of
/// coefficients.
Eigen::VectorXd direction_contrast(const SweepDesign& d, const motion::SweepSamples& samples) {
  Eigen::VectorXd contrast = Eigen::VectorXd::Zero(d.x.cols());
  if (d.direction >= 0) {
    contrast(d.direction) = 1;
    return contrast;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    contrast(d.offsets + static_cast<Eigen::Index>(d.offset_of_sample[i])) = samples.direction[i];
  }
  const auto ups = static_cast<double>((contrast.array() > 0).count());
  const auto downs = static_cast<double>((contrast.array() < 0).count());
  return contrast.unaryExpr([&](double sign) {
    return sign > 0 ? 0.5 / ups : sign < 0 ? -0.5 / downs : 0.0;
  });
}

void read_friction(const SweepDesign& d, const motion::SweepSamples& samples,
                   const SweepGravityFit& fit, double gear_ratio, CogSweepResult& out) {
  const Eigen::VectorXd& c = fit.regression.coefficients;
  const auto half_width = [&](Eigen::Index k) { return fit.regression.half_width(k); };
  constexpr Code method{"interval.least_squares_blocks"};
  if (!samples.constant_speed) {
    out.offset_Nm = c(d.offsets);
    if (d.direction >= 0) {
      out.coulomb_Nm =
          statistics::symmetric_estimate(c(d.direction), half_width(d.direction), method);
    }
    if (d.load >= 0) {
      out.unloaded_coulomb_Nm = out.coulomb_Nm;
      out.load_coulomb_Nm = statistics::symmetric_estimate(c(d.load), half_width(d.load), method);
      const double load = d.x.col(d.load).cwiseAbs().mean();
      Eigen::VectorXd mean = Eigen::VectorXd::Zero(c.size());
      mean(d.direction) = 1;
      mean(d.load) = load;
      out.coulomb_Nm = statistics::symmetric_estimate(
          mean.dot(c), fit.regression.half_width_along(mean), method);
    }
    double fastest_change = 0;
    for (const double a : samples.acceleration_rad_s2) {
      fastest_change = std::max(fastest_change, std::abs(a));
    }
    out.largest_acceleration_rad_s2 = gear_ratio * fastest_change;
    out.viscous_Nms_rad = statistics::symmetric_estimate(c(d.speed) / gear_ratio,
                                                         half_width(d.speed) / gear_ratio, method);
    if (d.acceleration < 0) return;
    out.inertia_kgm2 = statistics::symmetric_estimate(
        c(d.acceleration) / gear_ratio, half_width(d.acceleration) / gear_ratio, method);
    return;
  }
  if (!samples.both_directions()) return;
  const Eigen::VectorXd contrast = direction_contrast(d, samples);
  const double error = std::sqrt(contrast.dot(fit.regression.covariance * contrast));
  double freedom = INFINITY;
  for (Eigen::Index k = 0; k < d.offset_count; ++k) {
    freedom = std::min(freedom, fit.regression.freedom(d.offsets + k));
  }
  out.coulomb_Nm = statistics::symmetric_estimate(
      contrast.dot(c), statistics::student_t_975(freedom) * error, method);
}

/// The part of the two directions' mean torque that is not gravity, as a linear combination of
/// coefficients. The offsets were fitted against cos q - 1; the first coefficient has since been
/// subtracted from them.
Eigen::VectorXd offset_gradient(const SweepDesign& d, const motion::SweepSamples& samples) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d.x.cols());
  if (d.direction >= 0) {
    gradient(d.offsets) = 1;
  } else {
    gradient = direction_contrast(d, samples).cwiseAbs();
  }
  return gradient;
}

/// Reads that linear combination, with its interval.
void read_offset(const SweepDesign& d, const motion::SweepSamples& samples,
                 const SweepGravityFit& fit, CogSweepResult& out) {
  if (!samples.both_directions()) return;
  Eigen::VectorXd gradient = offset_gradient(d, samples);
  out.offset_Nm = gradient.dot(fit.regression.coefficients);
  gradient(0) = -1;
  out.torque_offset_Nm = statistics::symmetric_estimate(
      out.offset_Nm, fit.regression.half_width_along(gradient), {"interval.least_squares_blocks"});
  if (d.drift < 0) return;
  out.offset_drift_Nm = statistics::symmetric_estimate(2 * fit.regression.coefficients(d.drift),
                                                       2 * fit.regression.half_width(d.drift),
                                                       {"interval.least_squares_blocks"});
}

void read_strokes(const motion::SweepSamples& samples, const SweepGravityFit& fit,
                  CogSweepResult& out) {
  constexpr std::size_t fewest = 4;
  std::vector<double> sum(samples.stroke.back() + 1);
  std::vector<double> count(sum.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum[samples.stroke[i]] +=
        samples.direction[i] * fit.regression.residuals(static_cast<Eigen::Index>(i));
    count[samples.stroke[i]] += 1;
  }
  if (sum.size() < fewest) return;
  double squares = 0;
  double strokes = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    if (count[k] == 0) continue;
    squares += std::pow(sum[k] / count[k], 2);
    strokes += 1;
  }
  out.strokes_apart_Nm = std::sqrt(squares / strokes);
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
  out.stage.reason = {"gravity.stated_none"};
  if (!samples.both_directions()) return;
  const Eigen::VectorXd gradient = offset_gradient(design, samples);
  out.offset_Nm = gradient.dot(fit.regression.coefficients);
  out.torque_offset_Nm = statistics::symmetric_estimate(
      out.offset_Nm, fit.regression.half_width_along(gradient), {"interval.least_squares_blocks"});
}

/// Lines of so few periods over the sweep that gravity has absorbed part of them and biased their
/// period: they are fitted together with it, with three columns each: cosine, sine, and the
/// derivative with respect to their period.
class SlowLines {
 public:
  static constexpr Eigen::Index columns = 3;

  SlowLines(const motion::Sweep& sweep, double gear_ratio, CogSweepResult& out, SweepDesign& design)
      : first_(design.x.cols()) {
    constexpr double fewest_periods = 2;
    constexpr double most_periods = 15;
    constexpr std::size_t most_lines = 3;
    const double range = gear_ratio * (out.highest_rad - out.lowest_rad);
    middle_ = gear_ratio * (out.highest_rad + out.lowest_rad) / 2;
    for (std::size_t i = 0; i < sweep.samples.size(); ++i) {
      motor_rad_.push_back(gear_ratio * sweep.q_rad(i));
    }
    // Over a short range gravity is nearly a parabola, and looks like any slow line.
    const bool tells_them = out.highest_rad - out.lowest_rad >= least_range_for_second_rad;
    for (RippleLine& line : out.ripple.lines) {
      if (!tells_them) break;
      const double periods = line.periods_per_turn * range / (2 * std::numbers::pi);
      if (periods < fewest_periods || periods > most_periods || lines_.size() == most_lines) {
        continue;
      }
      // Two that differ by less than a period over the sweep would be fitted against each other.
      const auto is_near = [&](const RippleLine* other) {
        return std::abs(other->periods_per_turn - line.periods_per_turn) * range <
               2 * std::numbers::pi;
      };
      if (std::any_of(lines_.begin(), lines_.end(), is_near)) continue;
      lines_.push_back(&line);
    }
    if (lines_.empty()) return;
    design.x.conservativeResize(Eigen::NoChange,
                                first_ + columns * static_cast<Eigen::Index>(lines_.size()));
  }
  [[nodiscard]] bool any() const { return !lines_.empty(); }
  /// Whether one of them is slower than the motor turns: nothing in it repeats so, it is the shape
  /// of a torque of the joint's angle that no term describes.
  [[nodiscard]] bool any_slower_than_motor() const {
    return std::any_of(lines_.begin(), lines_.end(),
                       [](const RippleLine* line) { return line->periods_per_turn < 0.9; });
  }

  /// Torque of the lines with their current parameters.
  [[nodiscard]] Eigen::VectorXd torque_Nm() const {
    Eigen::VectorXd torque = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(motor_rad_.size()));
    for (const RippleLine* line : lines_) {
      for (Eigen::Index i = 0; i < torque.size(); ++i) {
        torque(i) += line->amplitude_Nm *
                     std::cos(line->periods_per_turn * motor_rad_[static_cast<std::size_t>(i)] +
                              line->phase_rad);
      }
    }
    return torque;
  }
  /// Gauss-Newton on their periods. @param design with the lines in its torque.
  void settle(SweepDesign& design) {
    constexpr int rounds = 6;
    constexpr double settled = 1e-6;
    for (int k = 0; k < rounds; ++k) {
      fill(design);
      const Eigen::VectorXd c = effect_on_coefficients(design, design.y);
      if (take(c) < settled) break;
    }
    fill(design);
  }
  /// @param c all coefficients of the design.
  /// @return the largest relative change of a period.
  double take(const Eigen::VectorXd& c) {
    constexpr double largest_step = 0.05;
    double largest = 0;
    Eigen::Index column = first_;
    for (RippleLine* line : lines_) {
      line->amplitude_Nm = std::hypot(c(column), c(column + 1));
      line->phase_rad = std::atan2(-c(column + 1), c(column));
      const double step = std::clamp(c(column + 2), -largest_step, largest_step);
      // About the sweep's middle the phase stays.
      line->phase_rad -= step * line->periods_per_turn * middle_;
      line->periods_per_turn *= 1 + step;
      largest = std::max(largest, std::abs(step));
      column += columns;
    }
    return largest;
  }
  [[nodiscard]] Eigen::VectorXd fitted_Nm(const SweepDesign& design,
                                          const Eigen::VectorXd& c) const {
    const Eigen::Index count = columns * static_cast<Eigen::Index>(lines_.size());
    return design.x.middleCols(first_, count) * c.segment(first_, count);
  }

 private:
  void fill(SweepDesign& design) const {
    Eigen::Index column = first_;
    for (const RippleLine* line : lines_) {
      for (std::size_t i = 0; i < motor_rad_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double angle = line->periods_per_turn * motor_rad_[i];
        design.x(row, column) = std::cos(angle);
        design.x(row, column + 1) = std::sin(angle);
        design.x(row, column + 2) = -line->amplitude_Nm * line->periods_per_turn *
                                    (motor_rad_[i] - middle_) * std::sin(angle + line->phase_rad);
      }
      column += columns;
    }
  }

  Eigen::Index first_;
  double middle_{};
  std::vector<double> motor_rad_;
  std::vector<RippleLine*> lines_;
};

/// Finds ripple and vibration in the residual, and fits without them.
/// @param rivals receives the fit with them, where they are the shape of something else.
SweepGravityFit fit_without_lines(const motion::Sweep& sweep, double gear_ratio, double middle,
                                  const std::vector<std::size_t>& blocks,
                                  const SweepGravityFit& first, SweepDesign& design,
                                  CogSweepResult& out, std::vector<SweepGravityFit>& rivals) {
  const double white = white_torque_variance(sweep);
  const double beyond_white = torque_ripple_Nm(first.regression.residual_sd, white);
  out.white_Nm = std::sqrt(white);
  if (!(beyond_white > 0)) return first;
  const Eigen::VectorXd& left = first.regression.residuals;
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
  SlowLines slow(sweep, gear_ratio, out, design);
  const Eigen::VectorXd taken = torque - slow.torque_Nm();
  design.y -= taken;
  if (slow.any()) slow.settle(design);
  if (slow.any_slower_than_motor()) rivals.push_back(first);
  SweepGravityFit fit = fit_amplitude_and_angle(sweep, design, middle, blocks);
  fit.regression.residuals += taken;  // what the smooth fit leaves
  if (slow.any()) {
    fit.regression.residuals += slow.fitted_Nm(design, fit.regression.coefficients);
    static_cast<void>(slow.take(fit.regression.coefficients));
  }
  return fit;
}

/// Effect of a change of the first two coefficients on amplitude (along them) and angle (across).
struct Lever {
  Eigen::Vector2d on_gravity, on_angle;
  Lever(const SweepGravityFit& fit, double middle) {
    const double from_middle = fit.q_peak_rad.value - middle;
    on_gravity = {std::cos(from_middle), std::sin(from_middle)};
    on_angle = Eigen::Vector2d(-on_gravity(1), on_gravity(0)) / fit.gravity_Nm.value;
  }
};

/// A torque of twice the angle in place of an offset.
struct InPlaceOfOffset {
  double amplitude_Nm{};
  double on_gravity_Nm{};  ///< What it adds to the gravity of a fit that takes it for the offset.
};

/// Whether the offset found may equally be a torque of the angle that is not found: with a term of
/// twice the angle in the fit it may vanish. Over less than half a turn the two look alike, and
/// shift gravity in opposite senses.
std::optional<InPlaceOfOffset> torque_in_place_of_offset(const motion::Sweep& sweep,
                                                         const SweepDesign& design, double middle,
                                                         const SweepGravityFit& fit,
                                                         const std::vector<std::size_t>& blocks,
                                                         const CogSweepResult& out) {
  if (out.of_angle || !out.torque_offset_Nm || !out.constant_speed ||
      out.highest_rad - out.lowest_rad < least_range_for_second_rad) {
    return std::nullopt;
  }
  // One that chance gives is held as it is.
  if (std::abs(out.torque_offset_Nm->value) <= surely_shown * out.torque_offset_Nm->half_width()) {
    return std::nullopt;
  }
  SweepDesign second = design_of_angle(sweep, middle, true, false);
  const SweepGravityFit rival = fit_amplitude_and_angle(sweep, second, middle, blocks);
  Eigen::VectorXd gradient = offset_gradient(second, sweep.samples);
  const double offset = gradient.dot(rival.regression.coefficients);
  gradient(0) = -1;
  if (std::abs(offset) > surely_shown * rival.regression.half_width_along(gradient)) {
    return std::nullopt;
  }
  // Even about the peak: what is odd shifts neither the offset nor gravity.
  Eigen::VectorXd twice(static_cast<Eigen::Index>(sweep.samples.size()));
  for (Eigen::Index i = 0; i < twice.size(); ++i) {
    twice(i) = std::cos(2 * (sweep.q_rad(static_cast<std::size_t>(i)) - fit.q_peak_rad.value));
  }
  const Eigen::VectorXd effect = effect_on_coefficients(design, twice);
  const double on_offset = offset_gradient(design, sweep.samples).dot(effect);
  if (on_offset == 0) return std::nullopt;
  const double amplitude = std::abs(out.torque_offset_Nm->value / on_offset);
  const Lever lever(fit, middle);
  return InPlaceOfOffset{amplitude, amplitude * std::abs(lever.on_gravity.dot(effect.head<2>()))};
}

statistics::Estimate widened(const statistics::Estimate& e, double by, Code why) {
  return statistics::symmetric_estimate(e.value, std::hypot(e.half_width(), by),
                                        {why, {{"interval", e.method}}});
}

/// Ripple of few periods a motor turn looks like gravity, or like a twist of the gear, where the
/// motor makes less than a few turns: widens angle and amplitude by the effect of ripple as large
/// as that seen, of any such period and at any phase. @param times factor on that size.
void widen_by_slow_ripple(const motion::Sweep& sweep, const SweepDesign& design, double gear_ratio,
                          double middle, const CogSweepResult& out, double times,
                          SweepGravityFit& fit) {
  constexpr double fewest_turns = 3;
  constexpr double fewest_periods = 3;
  const double turns = gear_ratio * (out.highest_rad - out.lowest_rad) / (2 * std::numbers::pi);
  if (turns >= fewest_turns || out.ripple.lines.empty()) return;
  const Lever lever(fit, middle);
  double on_gravity = 0;
  double on_angle = 0;
  const auto rows = static_cast<Eigen::Index>(sweep.samples.size());
  for (double order = 1; order * turns <= fewest_periods; ++order) {
    Eigen::VectorXd cosine(rows);
    Eigen::VectorXd sine(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double phase = order * gear_ratio * sweep.q_rad(static_cast<std::size_t>(i));
      cosine(i) = std::cos(phase);
      sine(i) = std::sin(phase);
    }
    const Eigen::Vector2d c = effect_on_coefficients(design, cosine).head<2>();
    const Eigen::Vector2d s = effect_on_coefficients(design, sine).head<2>();
    on_gravity = std::max(on_gravity, std::hypot(lever.on_gravity.dot(c), lever.on_gravity.dot(s)));
    on_angle = std::max(on_angle, std::hypot(lever.on_angle.dot(c), lever.on_angle.dot(s)));
  }
  const double unseen = times * out.ripple.half_width_Nm();
  constexpr Code why{"interval.widened_by_sweep_ripple"};
  fit.q_peak_rad = widened(fit.q_peak_rad, unseen * on_angle, why);
  fit.gravity_Nm = widened(fit.gravity_Nm, unseen * on_gravity, why);
}

/// Coarse steps of the torque bias amplitude and angle as much as rounding the fitted curve does;
/// noise of half a step or more averages that out (Widrow: by exp(-2 pi^2 (sd/step)^2)).
void widen_by_torque_step(const motion::Sweep& sweep, const SweepDesign& design, double middle,
                          SweepGravityFit& fit) {
  double step = 0;
  for (const joint::Recording* r : sweep.recordings)
    step = std::max(step, motion::common_step(r->torque_Nm));
  if (!(step > 0)) return;
  const double rounding = step * step / 12;
  const double variance = std::max(0.0, white_torque_variance(sweep) - rounding);
  const double left = std::exp(-2 * std::pow(std::numbers::pi / step, 2) * variance);
  const Eigen::VectorXd smooth = design.y - fit.regression.residuals;
  const Eigen::VectorXd rounded =
      step * (smooth / step).unaryExpr([](double x) { return std::round(x); });
  const Eigen::Vector2d pulled = left * effect_on_coefficients(design, rounded - smooth).head<2>();
  const Lever lever(fit, middle);
  const auto widen = [](statistics::Estimate& e, double by) {
    const statistics::Estimate wide = widened(e, by, "interval.widened_by_torque_step");
    if (wide.half_width() > 1.01 * e.half_width()) e = wide;
  };
  widen(fit.q_peak_rad, lever.on_angle.dot(pulled));
  widen(fit.gravity_Nm, lever.on_gravity.dot(pulled));
}

/// Widens an interval to hold another.
void hold(statistics::Estimate& e, const statistics::Estimate& other) {
  const double reach = std::max(std::abs(other.low - e.value), std::abs(other.high - e.value));
  if (reach <= e.half_width()) return;
  e = statistics::symmetric_estimate(
      e.value, reach, {"interval.widened_by_torque_of_angle", {{"interval", e.method}}});
}

/// Widens the intervals to hold what fits give that the data do not exclude.
void hold_rivals(const std::vector<SweepGravityFit>& rivals, SweepGravityFit& fit) {
  for (const SweepGravityFit& rival : rivals) {
    hold(fit.q_peak_rad, rival.q_peak_rad);
    hold(fit.gravity_Nm, rival.gravity_Nm);
    if (fit.twist_rad && rival.twist_rad) hold(*fit.twist_rad, *rival.twist_rad);
  }
}

/// How far the error of an inertia that was subtracted moves angle and amplitude.
void widen_by_inertia(const motion::Sweep& sweep, const SweepDesign& design, double half_width,
                      double middle, SweepGravityFit& fit) {
  const std::vector<double>& acceleration = sweep.samples.acceleration_rad_s2;
  const Eigen::Map<const Eigen::VectorXd> of_inertia(
      acceleration.data(), static_cast<Eigen::Index>(acceleration.size()));
  const Eigen::Vector2d moved = half_width * effect_on_coefficients(design, of_inertia).head<2>();
  const Lever lever(fit, middle);
  constexpr Code why{"interval.widened_by_inertia"};
  fit.q_peak_rad = widened(fit.q_peak_rad, lever.on_angle.dot(moved), why);
  fit.gravity_Nm = widened(fit.gravity_Nm, lever.on_gravity.dot(moved), why);
}

/// How far the error of a twist taken from another sweep moves the angle.
void widen_by_twist(const motion::Sweep& sweep, const SweepDesign& design,
                    const statistics::Estimate& twist_rad, CogSweepResult& out, SweepBlocks& kept) {
  const auto rows = static_cast<Eigen::Index>(sweep.samples.size());
  Eigen::VectorXd slope(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double x = sweep.q_rad(static_cast<std::size_t>(i)) - out.q_peak_rad.value;
    const double link = link_from_peak_rad(x, twist_rad.value);
    slope(i) = out.gravity_Nm.value * std::sin(link) * std::cos(link) /
               (1 - twist_rad.value * std::sin(link));
  }
  kept.twist_lever = -effect_on_coefficients(design, slope)(0);
  out.q_peak_rad = statistics::symmetric_estimate(
      out.q_peak_rad.value,
      std::hypot(out.q_peak_rad.half_width(), kept.twist_lever * twist_rad.half_width()),
      {"interval.widened_by_twist", {{"interval", out.q_peak_rad.method}}});
}

/// How far the ripple of another sweep moves the angle, each line at any phase.
void widen_by_ripple(const motion::Sweep& sweep, const SweepDesign& design, double gear_ratio,
                     const Ripple& ripple, CogSweepResult& out, SweepBlocks& kept) {
  const motion::SweepSamples& samples = sweep.samples;
  std::vector<double> amplitudes;
  const auto rows = static_cast<Eigen::Index>(samples.size());
  for (const RippleLine& line : ripple.lines) {
    Eigen::VectorXd cosine(rows);
    Eigen::VectorXd sine(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double phase =
          line.periods_per_turn * gear_ratio * sweep.q_rad(static_cast<std::size_t>(i));
      cosine(i) = std::cos(phase);
      sine(i) = std::sin(phase);
    }
    kept.ripple_lever.push_back(std::hypot(effect_on_coefficients(design, cosine)(0),
                                           effect_on_coefficients(design, sine)(0)));
    amplitudes.push_back(line.amplitude_Nm * kept.ripple_lever.back());
  }
  if (amplitudes.empty()) return;
  out.q_peak_rad = statistics::symmetric_estimate(
      out.q_peak_rad.value,
      std::hypot(out.q_peak_rad.half_width(), random_phase_half_width(amplitudes, 0)),
      {"interval.widened_by_rough_sweep_ripple", {{"interval", out.q_peak_rad.method}}});
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
    out.stage = {to_string(kind), statistics::StageState::skipped,
                 precise ? Code{"gravity.no_precise_sweep"} : Code{"gravity.no_rough_sweep"}};
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
