#include "method/intervals/run_resample.h"

#include <cmath>

#include "statistics/block_draw.h"
#include "statistics/student_t.h"

namespace tribolog::bootstrap {

std::vector<double> resample_runs(RandomStream& random, const ViscousCurvesResult& curves) {
  std::vector<double> shifts;
  shifts.reserve(curves.runs.size());
  for (const ConstantSpeedRun& run : curves.runs) {
    const std::vector<double>& blocks = run.block_friction_Nm;
    if (blocks.size() >= 2) {
      const double scale = few_blocks_scale(random, static_cast<double>(blocks.size()) - 1);
      shifts.push_back(scale * resampled_mean_shift(blocks, centred_counts(random, blocks.size())));
    } else {
      const double sd = run.torque_half_width_Nm / normal_975;
      shifts.push_back(std::isfinite(sd) ? sd * random.normal() : 0.0);
    }
  }
  return shifts;
}

}  // namespace tribolog::bootstrap
