#include "method/gravity/sweep_terms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Core>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "statistics/distributions.h"
#include "statistics/held_out.h"
#include "statistics/linear_systems.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::gravity {

double TorqueOfAngle::torque_Nm(double q_rad) const {
  const double y = q_rad - about_rad;
  return cosine_Nm * std::cos(2 * y) + sine_Nm * std::sin(2 * y) + spring_Nm * y;
}

SweepDesign design_of_angle(const motion::Sweep& sweep, double middle, bool second, bool spring,
                            const std::optional<double>& inertia_at_joint) {
  SweepDesign d = sweep_design(sweep, 2, false, inertia_at_joint);
  Eigen::Index next = d.x.cols();
  if (second) {
    d.second = next;
    next += 2;
  }
  if (spring) d.spring = next++;
  d.x.conservativeResize(Eigen::NoChange, next);
  for (std::size_t i = 0; i < sweep.samples.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double y = sweep.q_rad(i) - middle;
    if (second) {
      d.x(row, d.second) = std::cos(2 * y);
      d.x(row, d.second + 1) = std::sin(2 * y);
    }
    if (spring) d.x(row, d.spring) = y;
  }
  return d;
}

namespace {

/// Whether a linear combination of coefficients is significant.
bool shows(const SweepGravityFit& fit, const Eigen::VectorXd& gradient,
           double half_widths = surely_shown) {
  return std::abs(gradient.dot(fit.regression.coefficients)) >
         half_widths * fit.regression.half_width_along(gradient);
}

/// In a design with cos 2y and sin 2y: their parts that are even and odd about the peak.
Eigen::VectorXd second_about_peak(const SweepDesign& d, const SweepGravityFit& fit, double middle,
                                  bool even) {
  const double turned = 2 * (fit.q_peak_rad.value - middle);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d.x.cols());
  gradient(d.second) = even ? std::cos(turned) : -std::sin(turned);
  gradient(d.second + 1) = even ? std::sin(turned) : std::cos(turned);
  return gradient;
}

/// Whether a fit with fewer columns leaves no more than chance explains, for residuals correlated
/// like those of the richer fit.
bool describes_as_well(const SweepGravityFit& simple, const SweepDesign& rich_design,
                       const SweepGravityFit& rich) {
  constexpr double largest_gain = 10;  // of a chi-squared number with one degree of freedom
  const Eigen::MatrixXd normal = rich_design.x.transpose() * rich_design.x;
  const Eigen::Index k = rich_design.second;
  const double variance = std::pow(rich.regression.residual_sd, 2);
  const double white =
      variance * statistics::solve_normal(normal, Eigen::VectorXd::Unit(normal.cols(), k))(k, 0);
  const double inflation = std::max(1.0, rich.regression.covariance(k, k) / white);
  const double gain =
      simple.regression.residuals.squaredNorm() - rich.regression.residuals.squaredNorm();
  return gain < largest_gain * inflation * variance;
}

Eigen::VectorXd along(const SweepDesign& d, Eigen::Index column) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d.x.cols());
  gradient(column) = 1;
  return gradient;
}

constexpr std::array kinks_at{0.05, 0.12, 0.25, 0.45, 0.7};  // quantiles of the speed

/// Copies the columns of friction's shape to another design of the same samples.
void take_kinks(const SweepDesign& from, SweepDesign& to) {
  if (from.by_speed < 0) return;
  constexpr auto kinks = static_cast<Eigen::Index>(kinks_at.size());
  to.by_speed = to.x.cols();
  to.x.conservativeResize(Eigen::NoChange, to.by_speed + kinks);
  to.x.rightCols(kinks) = from.x.middleCols(from.by_speed, kinks);
}

/// Whether two fits differ appreciably: by half of an interval, a tenth of a per mille of the
/// amplitude or a hundredth of a degree.
bool matters(const SweepGravityFit& before, const SweepGravityFit& after) {
  constexpr double share = 0.5;
  constexpr double least_share = 1e-4;
  constexpr double least_rad = 0.01 / joint::degrees_per_rad;
  const double angle = std::abs(after.q_peak_rad.value - before.q_peak_rad.value);
  const double amplitude = std::abs(after.gravity_Nm.value - before.gravity_Nm.value);
  return angle > std::max(share * before.q_peak_rad.half_width(), least_rad) ||
         amplitude > std::max(share * before.gravity_Nm.half_width(),
                              least_share * before.gravity_Nm.value);
}

}  // namespace

SweepGravityFit with_torque_of_angle_where_it_shows(const motion::Sweep& sweep, SweepDesign& design,
                                                    double middle, double range_rad,
                                                    const std::vector<std::size_t>& blocks,
                                                    const SweepGravityFit& fit, double& left_Nm,
                                                    std::vector<SweepGravityFit>& rivals) {
  if (!sweep.samples.both_directions() || range_rad < least_range_for_second_rad) return fit;

  SweepDesign second = design_of_angle(sweep, middle, true, false, design.inertia_at_joint);
  take_kinks(design, second);
  const SweepGravityFit with_second = fit_amplitude_and_angle(sweep, second, middle, blocks);
  const Eigen::VectorXd odd = second_about_peak(second, with_second, middle, false);
  const Eigen::VectorXd even = second_about_peak(second, with_second, middle, true);
  const bool is_even = shows(with_second, even);
  const bool is_odd = shows(with_second, odd);
  // A gear that gives under its load is the odd part, with the sign of gravity.
  const bool is_twist = design.twist >= 0 && odd.dot(with_second.regression.coefficients) > 0;
  const auto fit_spring = [&](SweepDesign& spring) {
    spring = design_of_angle(sweep, middle, false, true, design.inertia_at_joint);
    take_kinks(design, spring);
    return fit_amplitude_and_angle(sweep, spring, middle, blocks);
  };
  // No gear twists against its load: a spring is the likelier of the two.
  const bool hints_at_spring =
      fit.twist_rad && fit.twist_rad->value < -hinted_at * fit.twist_rad->half_width();
  const auto hold_hinted_spring = [&] {
    SweepDesign spring;
    if (hints_at_spring) rivals.push_back(fit_spring(spring));
  };
  if (!is_even && (!is_odd || is_twist)) {
    const bool hints_at_odd = design.twist < 0 && shows(with_second, odd, hinted_at);
    if (hints_at_odd || shows(with_second, even, hinted_at)) rivals.push_back(with_second);
    hold_hinted_spring();
    return fit;
  }
  SweepGravityFit chosen = with_second;
  if (design.twist >= 0 && !is_twist) {
    SweepDesign spring;
    SweepGravityFit of_spring = fit_spring(spring);
    constexpr double half_widths = 1;
    if (shows(of_spring, along(spring, spring.spring), half_widths) &&
        describes_as_well(of_spring, second, with_second)) {
      // Over less than half a turn neither is certain: the interval holds both.
      rivals.push_back(with_second);
      chosen = std::move(of_spring);
      second = std::move(spring);
    }
  }
  if (!matters(fit, chosen)) {
    hold_hinted_spring();
    return fit;
  }
  constexpr double largest_share = 0.05;
  const double amplitude_Nm = present(torque_of_angle(sweep, second, middle, chosen)).amplitude_Nm;
  if (amplitude_Nm > largest_share * fit.gravity_Nm.value) {
    left_Nm = amplitude_Nm;
    return fit;
  }
  design = std::move(second);
  return chosen;
}

std::optional<TorqueOfAngle> torque_of_angle(const motion::Sweep& sweep, const SweepDesign& d,
                                             double middle, const SweepGravityFit& fit) {
  if (d.second < 0 && d.spring < 0) return std::nullopt;
  const Eigen::VectorXd& c = fit.regression.coefficients;
  TorqueOfAngle out;
  out.about_rad = middle;
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(c.size());
  const double y = fit.q_peak_rad.value - middle;
  if (d.second >= 0) {
    out.cosine_Nm = c(d.second);
    out.sine_Nm = c(d.second + 1);
    slope(d.second) = -2 * std::sin(2 * y);
    slope(d.second + 1) = 2 * std::cos(2 * y);
  }
  if (d.spring >= 0) {
    out.spring_Nm = c(d.spring);
    slope(d.spring) = 1;
  }
  double smallest = INFINITY;
  double largest = -INFINITY;
  for (std::size_t i = 0; i < sweep.samples.size(); ++i) {
    const double torque = out.torque_Nm(sweep.q_rad(i));
    smallest = std::min(smallest, torque);
    largest = std::max(largest, torque);
  }
  out.amplitude_Nm = (largest - smallest) / 2;
  // As uncertain as the angle at least, which holds a rival.
  out.slope_half_width_Nm_rad = std::max(fit.regression.half_width_along(slope),
                                         fit.gravity_Nm.value * fit.q_peak_rad.half_width());
  return out;
}

namespace {

constexpr std::size_t fewest_strokes = 4;
constexpr double standard_errors = 2.0;

void fill_load_column(const motion::Sweep& sweep, double q_peak, SweepDesign& d) {
  const motion::SweepSamples& samples = sweep.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    d.x(static_cast<Eigen::Index>(i), d.load) =
        samples.direction[i] * std::abs(std::cos(sweep.q_rad(i) - q_peak));
  }
}

/// The design with a column for the load, not filled.
SweepDesign with_load_column(const SweepDesign& design) {
  SweepDesign with = design;
  with.load = with.x.cols();
  with.x.conservativeResize(Eigen::NoChange, with.load + 1);
  return with;
}

/// A term of friction at varying speed is tried where there are strokes enough to hold one out.
bool can_hold_out_strokes(const SweepDesign& design, const motion::SweepSamples& samples) {
  const bool has_strokes = !samples.stroke.empty() && samples.stroke.back() + 1 >= fewest_strokes;
  return design.direction >= 0 && !samples.constant_speed && has_strokes;
}

/// Whether the mean of `without - with` over the strokes exceeds twice its standard error.
bool pays(const std::vector<double>& without, const std::vector<double>& with) {
  const statistics::ErrorDifference gain = statistics::difference(without, with);
  return gain.mean > standard_errors * gain.standard_error;
}

}  // namespace

SweepGravityFit with_kinks_where_they_pay(const motion::Sweep& sweep, SweepDesign& design,
                                          double middle_rad, const std::vector<std::size_t>& blocks,
                                          const SweepGravityFit& fit) {
  const motion::SweepSamples& samples = sweep.samples;
  if (!can_hold_out_strokes(design, samples)) return fit;
  std::vector<double> speed(samples.speed_rad_s);
  for (double& v : speed) v = std::abs(v);
  std::sort(speed.begin(), speed.end());
  SweepDesign with = design;
  with.by_speed = with.x.cols();
  constexpr auto kinks = static_cast<Eigen::Index>(kinks_at.size());
  with.x.conservativeResize(Eigen::NoChange, with.by_speed + kinks);
  for (Eigen::Index k = 0; k < kinks; ++k) {
    const double kink = speed[static_cast<std::size_t>(kinks_at.at(static_cast<std::size_t>(k)) *
                                                       static_cast<double>(speed.size()))];
    for (Eigen::Index i = 0; i < with.x.rows(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      with.x(i, with.by_speed + k) =
          samples.direction[at] * std::max(0.0, std::abs(samples.speed_rad_s[at]) - kink);
    }
  }
  Eigen::MatrixXd line(with.x.rows(), 2);
  line << with.x.col(design.direction), with.x.col(design.speed);
  const Eigen::MatrixXd bent = with.x.rightCols(kinks);
  with.x.rightCols(kinks) =
      bent - line * statistics::solve_normal(line.transpose() * line, line.transpose() * bent);
  const auto without = statistics::held_out_errors(design.x, design.y, samples.stroke);
  const auto held_out = statistics::held_out_errors(with.x, with.y, samples.stroke);
  if (!pays(without, held_out)) return fit;
  // In a sine the speed is a function of the angle, and so is the load: the better one is taken.
  SweepDesign loaded = with_load_column(design);
  fill_load_column(sweep, fit.q_peak_rad.value, loaded);
  const auto with_load = statistics::held_out_errors(loaded.x, loaded.y, samples.stroke);
  const auto sum = [](const std::vector<double>& errors) {
    return std::accumulate(errors.begin(), errors.end(), 0.0);
  };
  if (pays(without, with_load) && sum(with_load) < sum(held_out)) return fit;
  SweepGravityFit better = fit_amplitude_and_angle(sweep, with, middle_rad, blocks);
  design = with;
  return better;
}

SweepGravityFit with_load_where_it_pays(const motion::Sweep& sweep, SweepDesign& design,
                                        double middle_rad, const std::vector<std::size_t>& blocks,
                                        const SweepGravityFit& fit) {
  const motion::SweepSamples& samples = sweep.samples;
  if (!can_hold_out_strokes(design, samples)) return fit;
  SweepDesign with = with_load_column(design);
  double q_peak = fit.q_peak_rad.value;
  SweepGravityFit better;
  for (int iteration = 0; iteration < 10; ++iteration) {
    fill_load_column(sweep, q_peak, with);
    better = fit_amplitude_and_angle(sweep, with, middle_rad, blocks);
    const double step = better.q_peak_rad.value - q_peak;
    q_peak = better.q_peak_rad.value;
    if (std::abs(step) < 1e-9) break;
  }
  if (!(better.regression.coefficients(with.load) > 0)) return fit;
  if (!pays(statistics::held_out_errors(design.x, design.y, samples.stroke),
            statistics::held_out_errors(with.x, with.y, samples.stroke))) {
    return fit;
  }
  design = with;
  return better;
}

}  // namespace tribolog::method::gravity
