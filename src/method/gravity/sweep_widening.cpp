#include "method/gravity/sweep_widening.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "method/gravity/sweep_readings.h"
#include "method/gravity/sweep_terms.h"
#include "method/motion/encoder_resolution.h"

namespace tribolog::method::gravity {
namespace {

/// Effect of a change of the first two coefficients on amplitude (along them) and angle (across).
struct Lever {
  Eigen::Vector2d on_gravity, on_angle;
  Lever(const SweepGravityFit& fit, double middle) {
    const double from_middle = fit.q_peak_rad.value - middle;
    on_gravity = {std::cos(from_middle), std::sin(from_middle)};
    on_angle = Eigen::Vector2d(-on_gravity(1), on_gravity(0)) / fit.gravity_Nm.value;
  }
};

/// Widens an interval to hold another.
void hold(statistics::Estimate& e, const statistics::Estimate& other) {
  const double reach = std::max(std::abs(other.low - e.value), std::abs(other.high - e.value));
  if (reach <= e.half_width()) return;
  e = statistics::symmetric_estimate(
      e.value, reach, {"interval.widened_by_torque_of_angle", {{"interval", e.method}}});
}

}  // namespace

std::optional<InPlaceOfOffset> torque_in_place_of_offset(const motion::Sweep& sweep,
                                                         const SweepDesign& design, double middle,
                                                         const SweepGravityFit& fit,
                                                         const std::vector<std::size_t>& blocks,
                                                         const CogSweepResult& out) {
  if (out.of_angle || !out.torque_offset_Nm || !out.constant_speed ||
      out.highest_rad - out.lowest_rad < least_range_for_second_rad) {
    return std::nullopt;
  }
  // One that chance gives is within its interval.
  if (std::abs(out.torque_offset_Nm->value) <= out.torque_offset_Nm->half_width())
    return std::nullopt;
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

std::optional<UnseenSpring> unseen_spring(const motion::Sweep& sweep, const SweepDesign& design,
                                          double middle, const SweepGravityFit& fit,
                                          const std::vector<std::size_t>& blocks,
                                          const CogSweepResult& out) {
  if (out.of_angle || !out.constant_speed || !out.both_directions) return std::nullopt;
  SweepDesign with = design_of_angle(sweep, middle, false, true, design.inertia_at_joint);
  const SweepGravityFit of_spring = fit_amplitude_and_angle(sweep, with, middle, blocks);
  const double largest_Nm = std::abs(of_spring.regression.coefficients(with.spring)) +
                            of_spring.regression.half_width(with.spring);
  const Eigen::Vector2d effect = effect_on_coefficients(design, with.x.col(with.spring)).head<2>();
  const double shift = largest_Nm * std::abs(Lever(fit, middle).on_angle.dot(effect));
  if (!std::isfinite(shift)) return std::nullopt;
  return UnseenSpring{largest_Nm, shift};
}

statistics::Estimate widened(const statistics::Estimate& e, double by, Code why) {
  return statistics::symmetric_estimate(e.value, std::hypot(e.half_width(), by),
                                        {why, {{"interval", e.method}}});
}

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

void hold_rivals(const std::vector<SweepGravityFit>& rivals, SweepGravityFit& fit) {
  for (const SweepGravityFit& rival : rivals) {
    hold(fit.q_peak_rad, rival.q_peak_rad);
    hold(fit.gravity_Nm, rival.gravity_Nm);
    if (fit.twist_rad && rival.twist_rad) hold(*fit.twist_rad, *rival.twist_rad);
  }
}

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

}  // namespace tribolog::method::gravity
