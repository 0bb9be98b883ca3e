#include "method/intervals/sweep_resample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "statistics/block_draw.h"
#include "statistics/distributions.h"

namespace tribolog::method::intervals {

SweepShift resample_sweep(statistics::RandomStream& random, const gravity::CogSweepResult& sweep) {
  SweepShift shift;
  if (!sweep.found) return shift;
  const auto& blocks = sweep.resampling.block_shifts;
  const std::vector<double> counts = statistics::centred_counts(random, blocks.size());
  const double scale = statistics::few_blocks_scale(random, sweep.resampling.freedom);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    shift.q_peak_rad += scale * counts[b] * blocks[b][0];
    shift.gravity_Nm += scale * counts[b] * blocks[b][1];
    shift.coulomb_Nm += scale * counts[b] * blocks[b][2];
  }
  return shift;
}

SweepShift resample_precise_sweep(statistics::RandomStream& random,
                                  const gravity::CogSweepResult& precise,
                                  const gravity::Ripple& ripple, double gravity_shift_Nm) {
  SweepShift shift = resample_sweep(random, precise);
  const auto& resampling = precise.resampling;
  shift.q_peak_rad += resampling.amplitude_lever * gravity_shift_Nm;
  const std::size_t lines = std::min(ripple.lines.size(), resampling.ripple_lever.size());
  for (std::size_t k = 0; k < lines; ++k) {
    shift.q_peak_rad += resampling.ripple_lever[k] * ripple.lines[k].amplitude_Nm *
                        std::cos(2 * std::numbers::pi * random.uniform());
  }
  return shift;
}

std::vector<double> resample_runs(statistics::RandomStream& random,
                                  const viscous::ViscousCurvesResult& curves) {
  std::vector<double> shifts;
  shifts.reserve(curves.runs.size());
  for (const viscous::ConstantSpeedRun& run : curves.runs) {
    const std::vector<double>& blocks = run.block_friction_Nm;
    if (blocks.size() >= 2) {
      const double scale =
          statistics::few_blocks_scale(random, static_cast<double>(blocks.size()) - 1);
      shifts.push_back(scale * statistics::resampled_mean_shift(
                                   blocks, statistics::centred_counts(random, blocks.size())));
    } else {
      const double sd = run.torque_half_width_Nm / statistics::normal_975;
      shifts.push_back(std::isfinite(sd) ? sd * random.normal() : 0.0);
    }
  }
  return shifts;
}

}  // namespace tribolog::method::intervals
