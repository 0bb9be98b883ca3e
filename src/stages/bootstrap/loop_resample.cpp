#include "stages/bootstrap/loop_resample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stages/block_regression.h"
#include "stages/bootstrap/block_draw.h"
#include "stages/linearised_fit.h"
#include "stages/lugre_loop_model.h"
#include "stages/student_t.h"

namespace tribolog::bootstrap {
namespace {

constexpr double normal_975 = 1.959963984540054;

/// The cycle of each sample; what is left over at the end belongs to the last.
std::vector<std::size_t> cycle_of_sample(const std::vector<double>& t_s, double frequency_Hz,
                                         std::size_t cycles) {
  std::vector<std::size_t> cycle(t_s.size());
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    cycle[i] =
        std::min(cycles - 1, static_cast<std::size_t>((t_s[i] - t_s.front()) * frequency_Hz));
  }
  return cycle;
}

/// counts[first], counts[first + 1], ...
std::vector<double> from(const std::vector<double>& counts, std::size_t first, std::size_t size) {
  std::vector<double> out(size, 0.0);
  for (std::size_t k = 0; k < size && first + k < counts.size(); ++k) out[k] = counts[first + k];
  return out;
}

}  // namespace

LoopResampler::LoopResampler(const HysteresisResult& hysteresis, const Ripple& ripple)
    : hysteresis_(hysteresis), ripple_(ripple) {
  if (!hysteresis.found) return;
  cycles_ = hysteresis.cycle_means_Nm.size() + 1;
  for (const auto& turn : hysteresis.turn_torques_Nm) {
    for (std::size_t k = 0; k < turn.size(); ++k) turns_[k].push_back(turn[k]);
  }
  const auto& lugre = hysteresis.lugre;
  if (!lugre || !lugre->converged || !lugre->linearised || hysteresis.traces.empty()) return;
  const LinearisedFit& fit = *lugre->linearised;
  const LoopTrace& trace = hysteresis.traces.front();
  const bool of_this_loop = fit.residuals.size() == static_cast<Eigen::Index>(trace.t_s.size());
  const BlockRegression around = block_regression(
      fit.jacobian, -fit.residuals,
      of_this_loop
          ? cycle_of_sample(trace.t_s, hysteresis.oscillations.front().frequency_Hz, cycles_)
          : fit.block_of_row);
  lugre_shifts_ = around.block_shifts;
}

double LoopResampler::draw_ripple(RandomStream& random) const {
  double torque = ripple_.rest_Nm > 0 ? ripple_.rest_Nm * random.normal() : 0.0;
  for (const RippleLine& line : ripple_.lines) {
    torque += line.amplitude_Nm * std::cos(2 * std::numbers::pi * random.uniform());
  }
  return torque;
}

LoopShift LoopResampler::draw(RandomStream& random) const {
  LoopShift shift;
  if (!hysteresis_.found) return shift;
  const std::vector<double> counts = centred_counts(random, cycles_);
  const double freedom = std::max(1.0, static_cast<double>(cycles_) - 2);
  const double scale = few_blocks_scale(random, freedom);
  const double ripple = draw_ripple(random);
  const std::vector<double>& means = hysteresis_.cycle_means_Nm;
  const double half_width = hysteresis_.midline_Nm ? hysteresis_.midline_Nm->half_width() : 0.0;
  if (hysteresis_.position_freedom > 0) {
    const double f = hysteresis_.position_freedom;
    shift.midline_Nm =
        half_width / student_t_975(f) * random.normal() * few_blocks_scale(random, f);
  } else if (means.size() >= 3 && hysteresis_.oscillations.size() == 1) {
    shift.midline_Nm = scale * resampled_mean_shift(means, from(counts, 1, means.size())) + ripple;
  } else {
    shift.midline_Nm = half_width / normal_975 * random.normal() + ripple;
  }

  const std::size_t turns = turns_.front().size();
  for (std::size_t k = 0; k < hysteresis_.points.size(); ++k) {
    const LoopPoint& p = hysteresis_.points[k];
    // The scatter of one reading: that of the steady turns, or of the noise where there are none.
    const bool by_turns = p.name != 'A' && turns >= 3;
    const double t = by_turns ? student_t_975(static_cast<double>(turns) - 1) : normal_975;
    const double sd = (p.torque_high_Nm - p.torque_low_Nm) / 2 / t;
    shift.points_Nm[k] = (by_turns ? scale : 1.0) * sd * random.normal() + ripple;
    shift.steady_points_Nm[k] =
        turns >= 3 ? scale * resampled_mean_shift(turns_[k], from(counts, 1, turns)) + ripple
                   : shift.points_Nm[k];
  }
  if (lugre_shifts_.size() > 0) {
    const auto blocks = static_cast<std::size_t>(lugre_shifts_.cols());
    const std::vector<double> drawn = blocks == cycles_ ? counts : centred_counts(random, blocks);
    shift.lugre =
        scale * lugre_shifts_ *
        Eigen::Map<const Eigen::VectorXd>(drawn.data(), static_cast<Eigen::Index>(blocks));
    shift.lugre(LuGreLoopModel::gravity) += ripple;
  }
  draw_angles(random, shift);
  return shift;
}

void LoopResampler::draw_angles(RandomStream& random, LoopShift& shift) const {
  // The way from a turn of the motion to a point is a multiple of the bristles' reach Ts / s0.
  double reach = 0;
  if (shift.lugre.size() > LuGreLoopModel::log_static) {
    reach = shift.lugre(LuGreLoopModel::log_static) - shift.lugre(LuGreLoopModel::log_stiffness);
  }
  // Whether the encoder rounds or cuts is not known: a whole step to either side.
  const double step = hysteresis_.oscillations.front().encoder_step_rad;
  const std::vector<LoopPoint>& points = hysteresis_.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool dropping = points[k].name == 'B' || points[k].name == 'F';
    const double turn = points[dropping ? 2 : 3].q_rad;  // C or D
    const bool at_turn = points[k].name == 'A' || points[k].name == 'C' || points[k].name == 'D';
    shift.angle_rad[k] =
        (at_turn ? 0.0 : (points[k].q_rad - turn) * reach) + step * (2 * random.uniform() - 1);
  }
}

}  // namespace tribolog::bootstrap
