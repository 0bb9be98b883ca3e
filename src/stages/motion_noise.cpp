#include "stages/motion_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "simulate/random_stream.h"

namespace tribolog {
namespace {

constexpr std::size_t repeats = 12;

/// The recording that the traced motion would have given.
Recording recorded_again(const Recording& r, const TracedMotion& motion, RandomStream& random) {
  Recording out = r;
  const double step = motion.is_stepped() ? motion.encoder_step_rad : 0.0;
  const double phase = random.uniform();
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double q = motion.origin_rad + motion.spline->at(r.t_s[i] - r.t_s.front()).value;
    out.q_rad[i] = step > 0 ? step * (std::floor(q / step + phase) - phase + 0.5)
                            : q + motion.noise_rad * random.normal();
  }
  return out;
}

/// One step of the fit to the same torques along these motions.
Eigen::VectorXd step_along(const std::vector<LuGreInput>& loops, const LuGreClimb& climb,
                           double gear_ratio, double q_peak_rad) {
  std::vector<LuGreLoopModel> models;
  for (const LuGreInput& loop : loops) {
    models.emplace_back(*loop.recording, loop.motor_motion(gear_ratio), gear_ratio, q_peak_rad);
  }
  const LinearisedFit fit = LuGreProblem(std::move(models))
                                .linearise(climb.free, climb.point, climb.linear.fit.block_of_row)
                                .fit;
  return -fit.jacobian.colPivHouseholderQr().solve(fit.residuals);
}

}  // namespace

Eigen::MatrixXd shifts_by_motion_noise(const std::vector<LuGreInput>& loops,
                                       const LuGreClimb& climb, double gear_ratio,
                                       double q_peak_rad) {
  const Eigen::Index parameters = climb.linear.r_factor.cols();
  const bool any = std::any_of(loops.begin(), loops.end(),
                               [](const LuGreInput& loop) { return loop.traced != nullptr; });
  if (!any) return Eigen::MatrixXd(parameters, 0);
  Eigen::MatrixXd shifts(parameters, static_cast<Eigen::Index>(repeats));
  for (std::size_t k = 0; k < repeats; ++k) {
    RandomStream random(1, k);
    std::vector<MotionTrace> traces(loops.size());
    std::vector<LuGreInput> again = loops;
    for (std::size_t r = 0; r < loops.size(); ++r) {
      if (loops[r].traced == nullptr) continue;
      MotionTrace& trace = traces[r];
      trace = trace_motion(recorded_again(*loops[r].recording, *loops[r].traced, random));
      // Refused by chance, at the edge of what can be traced: the motion stays as it was.
      if (trace.motion) again[r].traced = &*trace.motion;
    }
    shifts.col(static_cast<Eigen::Index>(k)) = step_along(again, climb, gear_ratio, q_peak_rad);
  }
  return shifts / std::sqrt(static_cast<double>(repeats));
}

}  // namespace tribolog
