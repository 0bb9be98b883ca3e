#include "method/intervals/loop_resample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/requirements.h"
#include "statistics/block_regression.h"
#include "statistics/distributions.h"
#include "statistics/levenberg_marquardt.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {
namespace {

/// The cycle of each row, that of its first sample; a remainder at the end belongs to the last.
std::vector<std::size_t> cycle_of_row(const std::vector<double>& t_s, std::size_t samples_in_row,
                                      double frequency_Hz, std::size_t cycles) {
  std::vector<std::size_t> cycle;
  for (std::size_t i = 0; i < t_s.size(); i += samples_in_row) {
    cycle.push_back(
        std::min(cycles - 1, static_cast<std::size_t>((t_s[i] - t_s.front()) * frequency_Hz)));
  }
  return cycle;
}

/// counts[first], counts[first + 1], ...
std::vector<double> from(const std::vector<double>& counts, std::size_t first, std::size_t size) {
  std::vector<double> out(size, 0.0);
  for (std::size_t k = 0; k < size && first + k < counts.size(); ++k) out[k] = counts[first + k];
  return out;
}

/// Correlation of the residuals of two means at the same positions; 0 where the positions differ.
double residual_correlation(const hysteresis::PositionMean& a, const hysteresis::PositionMean& b) {
  if (a.residuals_Nm.size() != b.residuals_Nm.size()) return 0;
  const auto n = static_cast<Eigen::Index>(a.residuals_Nm.size());
  const Eigen::Map<const Eigen::VectorXd> x(a.residuals_Nm.data(), n);
  const Eigen::Map<const Eigen::VectorXd> y(b.residuals_Nm.data(), n);
  const double size = x.norm() * y.norm();
  return size > 0 ? x.dot(y) / size : 0.0;
}

/// The fit's positions, where it has a gravity torque that can be resampled; else null.
const hysteresis::PositionMean* positions_of_fit(const hysteresis::Hysteresis& loop) {
  return loop.lugre && loop.lugre->positions ? &*loop.lugre->positions : nullptr;
}

}  // namespace

LoopResampler::LoopResampler(const hysteresis::Hysteresis& loop, const gravity::Ripple& ripple)
    : loop_(loop), hysteresis_(loop.result), ripple_(ripple) {
  if (!hysteresis_.found) return;
  cycles_ = loop.cycles.means_Nm.size() + 1;
  for (const auto& turn : loop.cycles.turn_torques_Nm) {
    for (std::size_t k = 0; k < turn.size(); ++k) turns_[k].push_back(turn[k]);
  }
  prepare_fit();
}

void LoopResampler::prepare_fit() {
  const auto& lugre = loop_.lugre;
  if (!lugre || !lugre->fit.converged || !lugre->linearised) return;
  const statistics::LinearisedFit& fit = *lugre->linearised;
  const hysteresis::LoopTrace& trace = loop_.traces.front();
  // A loop that a torque drove has strokes, not cycles: its fit keeps its own blocks.
  const std::size_t rows = (trace.t_s.size() + fit.samples_in_row - 1) / fit.samples_in_row;
  fit_by_cycles_ = hysteresis_.oscillations.size() == 1 && !lugre->fit.loops.front().traced &&
                   fit.residuals.size() == static_cast<Eigen::Index>(rows);
  const statistics::BlockRegression around = statistics::block_regression(
      fit.jacobian, -fit.residuals,
      fit_by_cycles_ ? cycle_of_row(trace.t_s, fit.samples_in_row,
                                    hysteresis_.oscillations.front().frequency_Hz, cycles_)
                     : fit.block_of_row);
  const auto readings = static_cast<Eigen::Index>(fit.readings.size());
  reading_shifts_.resize(readings, around.block_shifts.cols());
  further_shifts_.resize(readings, fit.further_shifts.cols());
  for (Eigen::Index k = 0; k < readings; ++k) {
    const statistics::LinearisedReading& reading = fit.readings[static_cast<std::size_t>(k)];
    reading_shifts_.row(k) = reading.gradient.transpose() * around.block_shifts;
    if (fit.further_shifts.cols() > 0) {
      further_shifts_.row(k) = reading.gradient.transpose() * fit.further_shifts;
    }
    reading_freedom_.push_back(around.freedom_along(reading.gradient));
  }
  const auto index_of = [&](hysteresis::LuGreParameterName name) {
    const auto at = std::find(lugre->readings.begin(), lugre->readings.end(), name);
    return static_cast<std::size_t>(at - lugre->readings.begin());
  };
  const std::size_t level = index_of(hysteresis::LuGreParameterName::static_torque);
  const std::size_t stiffness = index_of(hysteresis::LuGreParameterName::bristle_stiffness);
  if (std::max(level, stiffness) < fit.readings.size()) reach_ = {level, stiffness};
  if (fit_by_cycles_ && fit.gravity_columns.size() == 1) {
    gravity_shifts_ = around.block_shifts.row(fit.gravity_columns.front());
  }
  if (loop_.cycles.positions && lugre->positions) {
    position_correlation_ = residual_correlation(*loop_.cycles.positions, *lugre->positions);
  }
}

double LoopResampler::draw_ripple(statistics::RandomStream& random) const {
  double torque = ripple_.rest_Nm > 0 ? ripple_.rest_Nm * random.normal() : 0.0;
  for (const gravity::RippleLine& line : ripple_.lines) {
    torque += line.amplitude_Nm * std::cos(2 * std::numbers::pi * random.uniform());
  }
  return torque;
}

LoopShift LoopResampler::draw(statistics::RandomStream& random) const {
  LoopShift shift;
  if (!hysteresis_.found) return shift;
  const std::vector<double> counts = statistics::centred_counts(random, cycles_);
  const double freedom = std::max(1.0, static_cast<double>(cycles_) - 2);
  const double scale = statistics::few_blocks_scale(random, freedom);
  const double ripple = draw_ripple(random);
  draw_gravity(random, counts, scale, ripple, shift);
  draw_points(random, counts, scale, ripple, shift);
  draw_fit(random, counts, scale, shift);
  draw_angles(random, shift);
  return shift;
}

void LoopResampler::draw_gravity(statistics::RandomStream& random,
                                 const std::vector<double>& counts, double scale, double ripple_Nm,
                                 LoopShift& shift) const {
  const std::vector<double>& means = loop_.cycles.means_Nm;
  const double half_width = hysteresis_.midline_Nm ? hysteresis_.midline_Nm->half_width() : 0.0;
  const hysteresis::PositionMean* fit = positions_of_fit(loop_);
  const double common = random.normal();
  const double own = random.normal();
  double few_positions = 1;
  if (hysteresis_.positions_hold_ripple) {
    const double f = present(loop_.cycles.positions).freedom;
    few_positions = statistics::few_blocks_scale(random, f);
    shift.midline_Nm = half_width / statistics::student_t_975(f) * common * few_positions;
  } else if (means.size() >= 3 && hysteresis_.oscillations.size() == 1) {
    shift.midline_Nm =
        scale * statistics::resampled_mean_shift(means, from(counts, 1, means.size())) + ripple_Nm;
  } else {
    shift.midline_Nm = half_width / statistics::normal_975 * common + ripple_Nm;
  }
  if (fit == nullptr) return;
  const double fit_half_width = fit->gravity_Nm.half_width();
  if (fit->freedom > 0) {
    const double r = position_correlation_;
    const bool same = hysteresis_.positions_hold_ripple &&
                      present(loop_.cycles.positions).freedom == fit->freedom;
    const double few = same ? few_positions : statistics::few_blocks_scale(random, fit->freedom);
    shift.fit_gravity_Nm = fit_half_width / statistics::student_t_975(fit->freedom) * few *
                           (r * common + std::sqrt(std::max(0.0, 1 - r * r)) * own);
  } else if (gravity_shifts_.size() > 0) {
    const Eigen::Map<const Eigen::VectorXd> drawn(counts.data(), gravity_shifts_.size());
    shift.fit_gravity_Nm =
        scale * gravity_shifts_.dot(drawn) + ripple_Nm / hysteresis_.midline_mean_cos;
  } else {
    shift.fit_gravity_Nm = fit_half_width / statistics::normal_975 * common + ripple_Nm;
  }
}

void LoopResampler::draw_points(statistics::RandomStream& random, const std::vector<double>& counts,
                                double scale, double ripple_Nm, LoopShift& shift) const {
  const std::size_t turns = turns_.front().size();
  for (std::size_t k = 0; k < hysteresis_.points.size(); ++k) {
    const hysteresis::LoopPoint& p = hysteresis_.points[k];
    // The scatter of one reading: that of the steady turns, or of the noise where there are none.
    const bool by_turns = p.name != hysteresis::Estimator::A && turns >= 3;
    const double t = by_turns ? statistics::student_t_975(static_cast<double>(turns) - 1)
                              : statistics::normal_975;
    const double sd = (p.torque_high_Nm - p.torque_low_Nm) / 2 / t;
    shift.points_Nm[k] = (by_turns ? scale : 1.0) * sd * random.normal() + ripple_Nm;
    shift.steady_points_Nm[k] =
        turns >= 3 ? scale * statistics::resampled_mean_shift(turns_[k], from(counts, 1, turns)) +
                         ripple_Nm
                   : shift.points_Nm[k];
  }
}

void LoopResampler::draw_fit(statistics::RandomStream& random, const std::vector<double>& counts,
                             double scale, LoopShift& shift) const {
  if (reading_freedom_.empty()) return;
  const auto blocks = static_cast<std::size_t>(reading_shifts_.cols());
  const std::vector<double> drawn =
      fit_by_cycles_ ? counts : statistics::centred_counts(random, blocks);
  const Eigen::VectorXd shifts =
      reading_shifts_ *
      Eigen::Map<const Eigen::VectorXd>(drawn.data(), static_cast<Eigen::Index>(blocks));
  Eigen::VectorXd normal(further_shifts_.cols());
  for (double& n : normal) n = random.normal();
  const Eigen::VectorXd further = further_shifts_ * normal;
  for (std::size_t k = 0; k < reading_freedom_.size(); ++k) {
    const double few =
        fit_by_cycles_ ? scale : statistics::few_blocks_scale(random, reading_freedom_[k]);
    const auto i = static_cast<Eigen::Index>(k);
    shift.lugre.push_back(few * shifts(i) + further(i));
  }
}

void LoopResampler::draw_angles(statistics::RandomStream& random, LoopShift& shift) const {
  // The way from a turn of the motion to a point is a multiple of the bristles' reach Ts / s0.
  double reach = 0;
  if (reach_) reach = shift.lugre[reach_->first] - shift.lugre[reach_->second];
  // Whether the encoder rounds or cuts is not known: a whole step to either side.
  const double step = hysteresis_.oscillations.front().encoder_step_rad;
  const std::vector<hysteresis::LoopPoint>& points = hysteresis_.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool dropping =
        points[k].name == hysteresis::Estimator::B || points[k].name == hysteresis::Estimator::F;
    const double turn = points[dropping ? 2 : 3].q_rad;  // C or D
    const bool at_turn = points[k].name == hysteresis::Estimator::A ||
                         points[k].name == hysteresis::Estimator::C ||
                         points[k].name == hysteresis::Estimator::D;
    shift.angle_rad[k] =
        (at_turn ? 0.0 : (points[k].q_rad - turn) * reach) + step * (2 * random.uniform() - 1);
  }
}

}  // namespace tribolog::method::intervals
