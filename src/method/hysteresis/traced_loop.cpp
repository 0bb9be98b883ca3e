#include "method/hysteresis/traced_loop.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "base/parallel_for.h"
#include "method/hysteresis/loop_shape.h"
#include "method/motion/oscillation_motion.h"
#include "simulate/motion.h"
#include "statistics/distributions.h"
#include "statistics/linear_systems.h"
#include "statistics/random_stream.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::hysteresis {

namespace {

constexpr std::size_t repeats = 12;

/// An angle as read by an encoder whose steps begin anywhere.
double stepped(double q, double step, double phase) {
  return step * (std::floor(q / step + phase) - phase + 0.5);
}

/// The angles that the harmonic motion would have given: with the encoder's steps elsewhere, and
/// with white noise where the residual is larger than they explain.
std::vector<double> angles_again(const LuGreInput& loop, double phase,
                                 statistics::RandomStream& random) {
  const simulate::HarmonicMotion motion = loop.motion->motor_motion(1);
  const double step = loop.encoder_step_rad;
  const double noise = std::sqrt(
      std::max(0.0, loop.motion->residual_rad * loop.motion->residual_rad - step * step / 12));
  std::vector<double> out;
  out.reserve(loop.recording->size());
  for (const double t : loop.recording->t_s) {
    const double q = motion.angle(t - loop.motion->start_s) + noise * random.normal();
    out.push_back(step > 0 ? stepped(q, step, phase) : q);
  }
  return out;
}

/// The recording that the traced motion would have given.
joint::Recording recorded_again(const joint::Recording& r, const motion::TracedMotion& motion,
                                double phase, statistics::RandomStream& random) {
  joint::Recording out = r;
  const double step = motion.is_stepped() ? motion.encoder_step_rad : 0.0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double q = motion.origin_rad + motion.spline->at(r.t_s[i] - r.t_s.front()).value;
    out.q_rad[i] = step > 0 ? stepped(q, step, phase) : q + motion.noise_rad * random.normal();
  }
  return out;
}

/// The beginnings of recordings, the same share of each.
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
  /// Share of the recordings; 1: whole.
  [[nodiscard]] double share() const { return share_; }

 private:
  [[nodiscard]] joint::Recording beginning_of(const joint::Recording& r) const {
    constexpr double fewest = 1000;
    const auto size = static_cast<double>(r.size());
    const auto count = static_cast<std::ptrdiff_t>(std::min(size, std::max(fewest, share_ * size)));
    joint::Recording out;
    out.name = r.name;
    out.role = r.role;
    out.t_s.assign(r.t_s.begin(), r.t_s.begin() + count);
    out.q_rad.assign(r.q_rad.begin(), r.q_rad.begin() + count);
    out.torque_Nm.assign(r.torque_Nm.begin(), r.torque_Nm.begin() + count);
    return out;
  }

  double share_{1};
  std::vector<joint::Recording> recordings_;
  std::vector<LuGreInput> inputs_;
};

/// Along a harmonic motion, which noise changes smoothly, a few samples of a cycle show as much.
LuGreGrain grain_of(const LuGreInput& loop) {
  constexpr double enough_per_cycle = 60;
  const std::vector<double>& t = loop.recording->t_s;
  if (loop.traced != nullptr) return {};
  const double per_cycle =
      static_cast<double>(t.size() - 1) / ((t.back() - t.front()) * loop.frequency_Hz());
  return {static_cast<std::size_t>(std::max(1.0, per_cycle / enough_per_cycle))};
}

/// One step of the fit to the same torques along these motions.
Eigen::VectorXd step_along(const std::vector<LuGreInput>& loops, const LuGreClimb& climb,
                           double gear_ratio, double q_peak_rad) {
  std::vector<LuGreLoopModel> models;
  for (const LuGreInput& loop : loops) {
    models.push_back(loop.model(gear_ratio, q_peak_rad, grain_of(loop)));
  }
  const statistics::LinearisedFit fit =
      LuGreProblem(std::move(models)).linearise(climb.free, climb.point, {}).fit;
  return -statistics::least_squares(fit.jacobian, fit.residuals);
}

}  // namespace

Eigen::MatrixXd shifts_by_motion_noise(const std::vector<LuGreInput>& loops,
                                       const LuGreClimb& climb, double gear_ratio,
                                       double q_peak_rad) {
  const Eigen::Index parameters = climb.linear.r_factor.cols();
  constexpr double most_samples = 50'000;
  const Beginnings parts(loops, most_samples);
  const std::vector<LuGreInput>& inputs = parts.inputs();
  std::vector<std::optional<motion::HarmonicRefit>> refits(inputs.size());
  for (std::size_t r = 0; r < inputs.size(); ++r) {
    if (inputs[r].traced == nullptr) refits[r].emplace(inputs[r].recording->t_s, *inputs[r].motion);
  }
  Eigen::MatrixXd shifts(parameters, static_cast<Eigen::Index>(repeats));
  parallel_for(repeats, [&](std::size_t k) {
    statistics::RandomStream random(1, k);
    // One encoder reads all recordings: loops a whole number of steps apart are off alike.
    const double phase = (static_cast<double>(k) + random.uniform()) / repeats;
    std::vector<motion::MotionTrace> traces(inputs.size());
    std::vector<motion::OscillationMotion> harmonic(inputs.size());
    std::vector<LuGreInput> again = inputs;
    for (std::size_t r = 0; r < inputs.size(); ++r) {
      if (refits[r]) {
        harmonic[r] = (*refits[r])(angles_again(inputs[r], phase, random));
        again[r].motion = &harmonic[r];
        continue;
      }
      motion::MotionTrace& trace = traces[r];
      const motion::TracedMotion& traced = *inputs[r].traced;
      trace = motion::trace_motion(recorded_again(*inputs[r].recording, traced, phase, random),
                                   &traced);
      // Refused by chance, at the edge of what can be traced: the motion stays as it was.
      if (trace.motion) again[r].traced = &*trace.motion;
    }
    shifts.col(static_cast<Eigen::Index>(k)) = step_along(again, climb, gear_ratio, q_peak_rad);
  });
  // Some of the samples alone would be fitted somewhere else: that is their torques' noise, not the
  // motion's.
  shifts.colwise() -= step_along(inputs, climb, gear_ratio, q_peak_rad);
  if (parts.share() < 1) {
    Eigen::VectorXd scale = Eigen::VectorXd::Constant(parameters, std::sqrt(parts.share()));
    for (std::size_t r = 0; climb.free.starts && r < loops.size(); ++r) {
      scale(LuGreProblem::gravity_column(climb.free, r) + 1) = 1;
    }
    shifts = scale.asDiagonal() * shifts;
  }
  // Their covariance is known with as many degrees of freedom as there are repeats.
  const auto freedom = static_cast<double>(repeats);
  const double widened = statistics::student_t_975(freedom) / statistics::normal_975;
  return widened * shifts / std::sqrt(freedom);
}

namespace {

/// A residual of more than this many times what noise explains is not that of a LuGre joint. For a
/// LuGre joint smoothing removes part of the angle's noise, and the factor is below one.
constexpr double misfit_factor = 1.5;

/// Nor does a misfit count that is smaller than this share of the torque's range: no drive follows
/// a friction model more closely.
constexpr double smallest_misfit_share = 1e-4;

/// The strokes that begin at a reversal.
std::vector<StrokeSamples> strokes_behind_turns(const joint::Recording& r,
                                                const motion::TracedMotion& motion) {
  std::vector<StrokeSamples> strokes;
  const auto index_of = [&](double since_s) {
    const auto it = std::lower_bound(r.t_s.begin(), r.t_s.end(), r.t_s.front() + since_s);
    return static_cast<std::size_t>(it - r.t_s.begin());
  };
  for (std::size_t k = 0; k < motion.turns_s.size(); ++k) {
    const bool is_last = k + 1 == motion.turns_s.size();
    strokes.push_back({std::min(index_of(motion.turns_s[k]), r.size() - 1),
                       is_last ? r.size() : index_of(motion.turns_s[k + 1])});
  }
  return strokes;
}

}  // namespace

TracedLoop describe_traced_loop(const joint::Recording& recording,
                                const motion::TracedMotion& motion,
                                const std::vector<double>& model_Nm,
                                const std::vector<double>& slope_Nm_rad, double gear_ratio) {
  TracedLoop out;
  out.noise_rad = motion.noise_rad;
  out.noise_source = motion.noise_source();
  out.strokes = motion.strokes();
  double squares = 0;
  for (const double slope : slope_Nm_rad) squares += slope * slope;
  out.explained_Nm = std::hypot(
      gear_ratio * motion.noise_rad * std::sqrt(squares / static_cast<double>(slope_Nm_rad.size())),
      statistics::white_sd_beside_jumps(statistics::third_differences(recording.torque_Nm)));
  const auto [low, high] =
      std::minmax_element(recording.torque_Nm.begin(), recording.torque_Nm.end());
  out.explained_Nm = std::max(out.explained_Nm, smallest_misfit_share * (*high - *low));
  const std::vector<StrokeSamples> strokes = strokes_behind_turns(recording, motion);
  out.turn_stiffness_Nm_rad =
      stiffness_behind_turns(recording.q_rad, recording.torque_Nm, recording.torque_Nm, strokes);
  out.model_turn_stiffness_Nm_rad =
      stiffness_behind_turns(recording.q_rad, recording.torque_Nm, model_Nm, strokes);
  return out;
}

Statement described_misfit(const std::string& recording, const TracedLoop& loop,
                           double residual_Nm) {
  if (residual_Nm <= misfit_factor * loop.explained_Nm) return {};
  Statement misfit{"lugre.misfit",
                   {{"recording", recording},
                    {"residual_Nm", residual_Nm},
                    {"explained_Nm", loop.explained_Nm}}};
  if (loop.turn_stiffness_Nm_rad && loop.model_turn_stiffness_Nm_rad) {
    misfit.add({"lugre.misfit_behind_reversals",
                {{"model_Nm_rad", loop.model_turn_stiffness_Nm_rad->value},
                 {"measured_Nm_rad", loop.turn_stiffness_Nm_rad->value}}});
  }
  return misfit;
}

}  // namespace tribolog::method::hysteresis
