#include "method/hysteresis/motion_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "base/parallel_for.h"
#include "statistics/random_stream.h"

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

/// The beginnings of recordings, as much of each.
class Beginnings {
 public:
  /// @param most_samples of all together.
  Beginnings(const std::vector<LuGreInput>& whole, double most_samples) : inputs_(whole) {
    double all = 0;
    for (const LuGreInput& loop : whole) all += static_cast<double>(loop.recording->size());
    share_ = std::min(1.0, most_samples / all);
    if (share_ == 1) return;
    recordings_.reserve(whole.size());
    for (LuGreInput& loop : inputs_) {
      recordings_.push_back(beginning_of(*loop.recording));
      loop.recording = &recordings_.back();
    }
  }
  Beginnings(const Beginnings&) = delete;
  Beginnings& operator=(const Beginnings&) = delete;

  [[nodiscard]] const std::vector<LuGreInput>& inputs() const { return inputs_; }
  /// 1: they are whole.
  [[nodiscard]] double share() const { return share_; }

 private:
  [[nodiscard]] Recording beginning_of(const Recording& r) const {
    constexpr double fewest = 1000;
    const auto size = static_cast<double>(r.size());
    const auto count = static_cast<std::ptrdiff_t>(std::min(size, std::max(fewest, share_ * size)));
    Recording out;
    out.name = r.name;
    out.role = r.role;
    out.t_s.assign(r.t_s.begin(), r.t_s.begin() + count);
    out.q_rad.assign(r.q_rad.begin(), r.q_rad.begin() + count);
    out.torque_Nm.assign(r.torque_Nm.begin(), r.torque_Nm.begin() + count);
    return out;
  }

  double share_{1};
  std::vector<Recording> recordings_;
  std::vector<LuGreInput> inputs_;
};

/// One step of the fit to the same torques along these motions.
Eigen::VectorXd step_along(const std::vector<LuGreInput>& loops, const LuGreClimb& climb,
                           double gear_ratio, double q_peak_rad) {
  std::vector<LuGreLoopModel> models;
  for (const LuGreInput& loop : loops) {
    models.emplace_back(*loop.recording, loop.motor_motion(gear_ratio), gear_ratio, q_peak_rad);
  }
  const LinearisedFit fit =
      LuGreProblem(std::move(models)).linearise(climb.free, climb.point, {}).fit;
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
  constexpr double most_samples = 50'000;
  const Beginnings parts(loops, most_samples);
  const std::vector<LuGreInput>& inputs = parts.inputs();
  Eigen::MatrixXd shifts(parameters, static_cast<Eigen::Index>(repeats));
  parallel_for(repeats, [&](std::size_t k) {
    RandomStream random(1, k);
    std::vector<MotionTrace> traces(inputs.size());
    std::vector<LuGreInput> again = inputs;
    for (std::size_t r = 0; r < inputs.size(); ++r) {
      if (inputs[r].traced == nullptr) continue;
      MotionTrace& trace = traces[r];
      const TracedMotion& traced = *inputs[r].traced;
      trace = trace_motion(recorded_again(*inputs[r].recording, traced, random), &traced);
      // Refused by chance, at the edge of what can be traced: the motion stays as it was.
      if (trace.motion) again[r].traced = &*trace.motion;
    }
    shifts.col(static_cast<Eigen::Index>(k)) = step_along(again, climb, gear_ratio, q_peak_rad);
  });
  if (parts.share() < 1) {
    // The part alone would be fitted somewhere else: that is its torques' noise, not the motion's.
    shifts.colwise() -= step_along(inputs, climb, gear_ratio, q_peak_rad);
    Eigen::VectorXd scale = Eigen::VectorXd::Constant(parameters, std::sqrt(parts.share()));
    for (std::size_t r = 0; climb.free.starts && r < loops.size(); ++r) {
      scale(LuGreProblem::gravity_column(climb.free, r) + 1) = 1;
    }
    shifts = scale.asDiagonal() * shifts;
  }
  return shifts / std::sqrt(static_cast<double>(repeats));
}

}  // namespace tribolog
