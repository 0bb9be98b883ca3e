#include "method/gravity/sweep_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Core>

namespace tribolog::method::gravity {
namespace {

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

}  // namespace

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

}  // namespace tribolog::method::gravity
