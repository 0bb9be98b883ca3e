#include "stages/lugre_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "stages/block_regression.h"
#include "stages/levenberg_marquardt.h"
#include "stages/linearised_fit.h"
#include "stages/lugre_loop_model.h"

namespace tribolog {
namespace {

using Model = LuGreLoopModel;

Eigen::VectorXd first_guess(const Recording& r, double motor_amplitude, double bends_per_stroke,
                            double angular_frequency) {
  const auto [low, high] = std::minmax_element(r.torque_Nm.begin(), r.torque_Nm.end());
  const double level = std::max(1e-9, (*high - *low) / 2);
  const double stiffness = bends_per_stroke * level / motor_amplitude;
  Eigen::VectorXd p(Model::parameters);
  p(Model::log_stiffness) = std::log(stiffness);
  p(Model::log_static) = std::log(level);
  p(Model::damping) = 0.01 * stiffness / angular_frequency;
  p(Model::viscous) = 0;
  p(Model::gravity) = (*high + *low) / 2;
  p(Model::inertia) = 0;
  p(Model::start_deflection) = 0;
  return p;
}

/// Blocks of half a cycle, in which residuals of a misfitted loop hang together.
std::vector<std::size_t> half_cycle_blocks(const Recording& r, double frequency_Hz) {
  std::vector<std::size_t> blocks(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) {
    blocks[i] = static_cast<std::size_t>((r.t_s[i] - r.t_s.front()) * 2 * frequency_Hz);
  }
  return blocks;
}

}  // namespace

LuGreFit fit_lugre(const Recording& oscillation, const OscillationMotion& motion, double gear_ratio,
                   double q_peak_rad) {
  LuGreFit fit;
  const Model model(oscillation, motion, gear_ratio, q_peak_rad);
  const double motor_amplitude = gear_ratio * motion.amplitude_rad;
  const double omega = 2 * std::numbers::pi * motion.frequency_Hz;
  const LeastSquaresProblem problem{
      model.samples(), [&](const Eigen::VectorXd& p, Eigen::VectorXd& r, Eigen::MatrixXd* j) {
        model.evaluate(p, r, j);
      }};
  LeastSquaresSolution best;
  best.cost = std::numeric_limits<double>::infinity();
  // From nearly elastic to nearly sliding loops.
  for (const double bends : {2.0, 6.0, 20.0}) {
    const LeastSquaresSolution s =
        solve_least_squares(problem, first_guess(oscillation, motor_amplitude, bends, omega));
    fit.iterations += s.evaluations;
    if (s.converged && s.cost < best.cost) best = s;
  }
  if (!best.converged) {
    fit.reason = "the LuGre model could not be fitted to the loop from any of three first guesses";
    return fit;
  }
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  const Model::Vector p = best.parameters;
  model.evaluate(p, residuals, &jacobian);
  const auto blocks = half_cycle_blocks(oscillation, motion.frequency_Hz);
  const BlockRegression around = block_regression(jacobian, -residuals, blocks);
  fit.linearised = std::make_shared<LinearisedFit>(LinearisedFit{p, jacobian, residuals, blocks});
  fit.residual_Nm =
      std::sqrt(residuals.squaredNorm() /
                std::max<double>(1, static_cast<double>(residuals.size()) - Model::parameters));
  const auto half_width = [&](Eigen::Index k) {
    return around.t_factor * std::sqrt(std::max(0.0, around.covariance(k, k)));
  };
  const char* method = "loop fit, blocks of half a cycle";
  const auto positive = [&](Model::Index k) {
    const double h = half_width(k);
    return Estimate{std::exp(p(k)), std::exp(p(k) - h), std::exp(p(k) + h), method};
  };
  fit.bristle_stiffness_Nm_rad = positive(Model::log_stiffness);
  fit.static_Nm = positive(Model::log_static);
  fit.bristle_damping_Nms_rad =
      symmetric_estimate(p(Model::damping), half_width(Model::damping), method);
  fit.viscous_Nms_rad = symmetric_estimate(p(Model::viscous), half_width(Model::viscous), method);
  fit.inertia_kgm2 = symmetric_estimate(p(Model::inertia), half_width(Model::inertia), method);
  fit.gravity_Nm = symmetric_estimate(p(Model::gravity), half_width(Model::gravity), method);
  // The loop shows the deflection at its start within an interval; where that holds zero, the arm
  // started from rest and z = 0 is the simpler truth.
  Model::Vector start_from_rest = p;
  if (std::abs(p(Model::start_deflection)) <= half_width(Model::start_deflection)) {
    start_from_rest(Model::start_deflection) = 0;
  }
  model.bristle(start_from_rest, fit.z_rad, fit.dz_rad_s);
  fit.torque_Nm.resize(oscillation.size());
  for (std::size_t i = 0; i < oscillation.size(); ++i) {
    fit.torque_Nm[i] = oscillation.torque_Nm[i] + residuals(static_cast<Eigen::Index>(i));
  }
  fit.converged = true;
  const double fastest =
      std::abs(*std::max_element(model.speed().begin(), model.speed().end(),
                                 [](double a, double b) { return std::abs(a) < std::abs(b); }));
  fit.reason = fmt::format(
      "the motor stays below {:.3g} rad/s in this loop: Coulomb torque and Stribeck velocity do "
      "not "
      "show in it and are taken from the constant-speed runs",
      fastest);
  const double reach = motor_amplitude * fit.bristle_stiffness_Nm_rad.value / fit.static_Nm.value;
  if (reach < 1) {
    fit.reason += fmt::format(
        "; the loop reaches only {:.0f} % of the way to sliding, so the static torque is "
        "extrapolated: a larger amplitude would show it",
        100 * reach);
  }
  return fit;
}

}  // namespace tribolog
