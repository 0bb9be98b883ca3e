#include "method/intervals/sweep_resample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "statistics/distributions.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {

gravity::SweepShift resample_sweep(statistics::RandomStream& random,
                                   const gravity::CogSweep& sweep) {
  gravity::SweepShift shift;
  if (!sweep.result.found) return shift;
  const auto& blocks = sweep.blocks.shifts;
  const std::vector<double> counts = statistics::centred_counts(random, blocks.size());
  const double scale = statistics::few_blocks_scale(random, sweep.blocks.freedom);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const double times = scale * counts[b];
    shift.q_peak_rad += times * blocks[b].q_peak_rad;
    shift.gravity_Nm += times * blocks[b].gravity_Nm;
    shift.coulomb_Nm += times * blocks[b].coulomb_Nm;
    shift.twist_rad += times * blocks[b].twist_rad;
    shift.offset_Nm += times * blocks[b].offset_Nm;
  }
  return shift;
}

gravity::SweepShift resample_precise_sweep(statistics::RandomStream& random,
                                           const gravity::CogSweep& precise,
                                           const gravity::Ripple& ripple,
                                           const gravity::SweepShift& rough) {
  gravity::SweepShift shift = resample_sweep(random, precise);
  const gravity::SweepBlocks& levers = precise.blocks;
  shift.q_peak_rad +=
      levers.amplitude_lever * rough.gravity_Nm + levers.twist_lever * rough.twist_rad;
  const std::size_t lines = std::min(ripple.lines.size(), levers.ripple_lever.size());
  for (std::size_t k = 0; k < lines; ++k) {
    shift.q_peak_rad += levers.ripple_lever[k] * ripple.lines[k].amplitude_Nm *
                        std::cos(2 * std::numbers::pi * random.uniform());
  }
  return shift;
}

std::vector<double> resample_runs(statistics::RandomStream& random,
                                  const viscous::ViscousCurves& curves) {
  std::vector<double> shifts;
  const std::vector<viscous::ConstantSpeedRun>& runs = curves.result.runs;
  shifts.reserve(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<double>& blocks = curves.block_friction_Nm[r];
    if (blocks.size() >= 2) {
      const double scale =
          statistics::few_blocks_scale(random, static_cast<double>(blocks.size()) - 1);
      shifts.push_back(scale * statistics::resampled_mean_shift(
                                   blocks, statistics::centred_counts(random, blocks.size())));
    } else {
      const double sd = runs[r].torque_half_width_Nm / statistics::normal_975;
      shifts.push_back(std::isfinite(sd) ? sd * random.normal() : 0.0);
    }
  }
  return shifts;
}

}  // namespace tribolog::method::intervals
