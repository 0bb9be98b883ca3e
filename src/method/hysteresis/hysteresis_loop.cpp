#include "method/hysteresis/hysteresis_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/requirements.h"
#include "method/hysteresis/loop_points.h"
#include "method/hysteresis/loop_start.h"
#include "method/hysteresis/position_mean.h"
#include "method/hysteresis/presliding_travel.h"
#include "method/motion/encoder_resolution.h"
#include "method/motion/followed_motion.h"
#include "method/motion/moving_part.h"
#include "statistics/distributions.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::hysteresis {
namespace {

/// Says, from the reversals of the sweep, whether an oscillation would have been resolved.
void explain_without_oscillation(const motion::Sweep& sweep, const gravity::CogSweepResult& rough,
                                 double gear_ratio, HysteresisResult& out) {
  out.stage.state = statistics::StageState::skipped;
  out.stage.reason = {"loop.no_oscillation"};
  if (!rough.found || sweep.recordings.empty()) return;
  const auto [step, is_of_print] = motion::angle_step(sweep.recordings.front()->q_rad, gear_ratio);
  const std::optional<double> travel = presliding_travel_rad(sweep, rough, gear_ratio);
  if (step <= 0 || !travel) return;
  out.encoder_step_rad = step;
  out.step_is_of_print = is_of_print;
  out.presliding_travel_rad = travel;
  const double steps = *travel / step;
  if (steps < motion::fewest_steps_in_presliding) {
    out.stage.state = statistics::StageState::not_identifiable;
    out.stage.reason = {"loop.presliding_not_resolved",
                        {{"step_rad", step},
                         {"steps", steps},
                         {"travel_rad", *travel},
                         {"needed", motion::fewest_steps_in_presliding}}};
  }
}

LoopTrace make_trace(const joint::Recording& r) {
  return {r.name, r.t_s, r.q_rad, r.torque_Nm, r.z_rad, r.dz_rad_s, {}, {}, {}};
}

using Turns = std::vector<std::vector<LoopPoint>>;

/// The points of all whole turns of the trace from `first` on.
/// @param period_s of a motion that is half-wave symmetric; 0 of another.
Turns read_turns(const LoopTrace& trace, const TraceReader& reader, std::size_t first,
                 double period_s) {
  Turns turns;
  std::size_t next = first;
  while (auto points = find_loop_points(trace, reader, next, next)) {
    if (period_s > 0) put_half_a_period_apart(trace, reader, period_s, *points);
    turns.push_back(*points);
  }
  return turns;
}

/// The turns averaged point by point.
std::vector<LoopPoint> average_turns(const Turns& turns) {
  if (turns.empty()) return {};
  std::vector<LoopPoint> mean = turns.front();
  const auto n = static_cast<double>(turns.size());
  for (std::size_t k = 0; k < mean.size(); ++k) {
    double q = 0, torque = 0, z = 0, dz = 0, half_width = 0, squares = 0;
    for (const auto& turn : turns) {
      q += turn[k].q_rad / n;
      torque += turn[k].torque_Nm / n;
      z += turn[k].z_rad / n;
      dz += turn[k].dz_rad_s / n;
      half_width += (turn[k].torque_high_Nm - turn[k].torque_low_Nm) / 2 / n;
    }
    for (const auto& turn : turns) squares += std::pow(turn[k].torque_Nm - torque, 2);
    // Turns scatter independently; with too few of them the reading's own width is all there is.
    half_width = n >= 3 ? statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n)
                        : half_width / std::sqrt(n);
    mean[k] = {mean[k].name,        mean[k].t_s,         q, torque,
               torque - half_width, torque + half_width, z, dz};
  }
  return mean;
}

/// A reading scatters like the same reading of the steady turns, by more than the noise of the
/// torque: the instant of reading is uncertain too. A belongs to the start-up stroke, which has no
/// counterpart.
void widen_by_scatter(const std::vector<LoopPoint>& steady, std::size_t turns,
                      std::vector<LoopPoint>& points) {
  if (turns < 3) return;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].name == Estimator::A) continue;
    const double half_width = (steady[k].torque_high_Nm - steady[k].torque_low_Nm) / 2 *
                              std::sqrt(static_cast<double>(turns));
    points[k].torque_low_Nm = points[k].torque_Nm - half_width;
    points[k].torque_high_Nm = points[k].torque_Nm + half_width;
  }
}

struct LoopResult {
  joint::Recording recording;
  std::optional<motion::OscillationMotion> motion;  ///< Where the angle swings with a period.
  std::optional<motion::TracedMotion>
      traced;                  ///< Where harmonics do not follow it, or there are none.
  double followed_from_s{};    ///< Since the first sample: the motion holds from here.
  Statement why_not_followed;  ///< Where no model can be driven by the angle.
  Oscillation oscillation;
  LoopTrace trace;
  std::optional<LoopMidline> midline;  ///< Of a loop with a period.
};

/// Combines the mid-lines of all recordings that have one into one estimate of the gravity torque.
void combine_midlines(const std::vector<LoopResult>& loops, const gravity::Ripple& ripple,
                      double gear_ratio, Hysteresis& made) {
  HysteresisResult& out = made.result;
  std::vector<statistics::Estimate> at_peak;
  std::vector<double> angle;
  for (const LoopResult& loop : loops) {
    if (!loop.midline) continue;
    out.midline_friction_Nm += loop.midline->friction_Nm;
    out.midline_by_angle = out.midline_by_angle || loop.midline->by_angle;
    at_peak.push_back(statistics::scaled(loop.midline->torque_Nm, 1 / loop.midline->mean_cos));
    angle.push_back(gear_ratio * loop.oscillation.centre_rad);
  }
  if (!at_peak.empty()) out.midline_friction_Nm /= static_cast<double>(at_peak.size());
  if (loops.size() == 1) {
    const std::optional<LoopMidline>& midline = loops.front().midline;
    if (midline) out.midline_Nm = midline->torque_Nm;
  } else if (!at_peak.empty()) {
    const PositionMean positions =
        mean_over_positions(at_peak, angle, ripple, {"interval.scatter_of_cycles_and_recordings"});
    out.midline_Nm = positions.gravity_Nm;
    const auto first = std::find_if(loops.begin(), loops.end(),
                                    [](const LoopResult& loop) { return bool(loop.midline); });
    if (first->midline->mean_cos < 0) {
      // At the trough: the torque as it is there.
      out.midline_mean_cos = -1;
      out.midline_Nm = statistics::scaled(*out.midline_Nm, -1);
    }
    out.positions_hold_ripple = positions.freedom > 0;
  }
}

/// Finds the motion of a recording, by harmonics or else by a spline; returns why not, if neither.
Statement follow_the_angle(double encoder_step, LoopResult& loop) {
  motion::FollowedMotion followed = motion::follow_the_angle(loop.recording, encoder_step);
  loop.motion = std::move(followed.harmonic);
  loop.traced = std::move(followed.traced);
  loop.followed_from_s = followed.from_s;
  if (followed.is_followed) return {};
  if (!loop.motion) {
    return {"loop.no_whole_cycle",
            {{"recording", loop.recording.name}, {"why", followed.why_not_traced}}};
  }
  return {"loop.angle_not_periodic",
          {{"recording", loop.recording.name},
           {"residual_rad", loop.motion->residual_rad},
           {"amplitude_rad", loop.motion->amplitude_rad},
           {"why", followed.why_not_traced}}};
}

/// Without cycles and noise of the torque.
Oscillation oscillation_of(const LoopResult& loop, double encoder_step) {
  if (loop.motion) {
    return {loop.motion->centre_rad,
            loop.motion->amplitude_rad,
            loop.motion->frequency_Hz,
            0,
            0,
            encoder_step,
            false,
            loop.motion->share_of_harmonic(2),
            loop.motion->share_of_harmonic(3)};
  }
  const motion::TracedMotion& traced = present(loop.traced);
  return {traced.centre_rad,
          traced.amplitude_rad,
          traced.frequency_Hz,
          std::floor(static_cast<double>(traced.strokes()) / 2),
          0,
          encoder_step};
}

/// A motion that begins with its full speed shows the bristle's damping in its first samples alone,
/// and there a lag moves the torque from one to the next.
double start_that_a_lag_hides_s(const joint::Recording& loop, const LoopTiming& timing) {
  constexpr double intervals = 4;  // over which a lag of part of a sample spreads a jump
  if (timing.half_width_s == 0) return 0;
  return timing.half_width_s + intervals * statistics::median_interval(loop.t_s);
}

/// Fits LuGre to all loops together; the fit provides the bristle state of those that recorded
/// none.
void observe_bristle(std::vector<LoopResult>& loops, double gear_ratio, double q_peak,
                     const gravity::Ripple& ripple, const KnownOfLoops& known, Hysteresis& made) {
  std::vector<LuGreInput> inputs;
  std::vector<LoopTrace*> traces;
  Statement not_followed;
  for (LoopResult& loop : loops) {
    if (!loop.why_not_followed.empty()) {
      if (not_followed.empty()) not_followed = loop.why_not_followed;
      continue;
    }
    inputs.push_back({&loop.recording, loop.motion ? &*loop.motion : nullptr,
                      loop.traced ? &*loop.traced : nullptr,
                      loop.oscillation.step_is_of_print ? 0 : loop.oscillation.encoder_step_rad,
                      std::max({loop.followed_from_s,
                                settled_from_s(loop.recording, 1 / loop.oscillation.frequency_Hz),
                                start_that_a_lag_hides_s(loop.recording, known.effects.timing)})});
    traces.push_back(&loop.trace);
  }
  FittedLuGre lugre;
  if (!inputs.empty()) lugre = fit_lugre(inputs, gear_ratio, q_peak, ripple, known);
  lugre.fit.reason.add(not_followed);
  if (!loops.front().trace.z_rad.empty()) {
    made.result.bristle_source = {"loop.bristle_recorded"};
  } else if (lugre.fit.gravity_Nm && traces.front() == &loops.front().trace) {
    made.result.bristle_source = {"loop.bristle_fitted"};
  }
  for (std::size_t r = 0; r < lugre.signals.size(); ++r) {
    LuGreSignals& signals = lugre.signals[r];
    traces[r]->model_torque_Nm = std::move(signals.torque_Nm);
    if (!traces[r]->z_rad.empty()) continue;
    traces[r]->z_rad = std::move(signals.z_rad);
    traces[r]->dz_rad_s = std::move(signals.dz_rad_s);
  }
  lugre.signals.clear();
  made.lugre = std::move(lugre);
}

}  // namespace

Hysteresis identify_hysteresis(const std::vector<const joint::Recording*>& oscillations,
                               const motion::Sweep& sweep, const gravity::CogSweepResult& rough,
                               double gear_ratio,
                               const std::optional<statistics::Estimate>& q_peak_rad,
                               const KnownOfLoops& known) {
  Hysteresis made;
  HysteresisResult& out = made.result;
  out.stage.name = "hysteresis";
  if (oscillations.empty()) {
    explain_without_oscillation(sweep, rough, gear_ratio, out);
    return made;
  }
  std::vector<LoopResult> loops;
  for (const joint::Recording* whole : oscillations) {
    LoopResult loop;
    loop.recording = motion::moving_part(*whole);
    const joint::Recording& recording = loop.recording;
    out.samples_at_rest += whole->size() - recording.size();
    const auto [step, is_of_print] = motion::angle_step(recording.q_rad, gear_ratio);
    // Rounding by the print lies on top of a step that is not known.
    loop.why_not_followed = follow_the_angle(is_of_print ? 0.0 : step, loop);
    if (!loop.motion && !loop.traced) {
      out.stage.reason.add(loop.why_not_followed);
      continue;
    }
    loop.trace = make_trace(recording);
    loop.oscillation = oscillation_of(loop, step);
    loop.oscillation.step_is_of_print = is_of_print;
    const double width = 2 * loop.oscillation.amplitude_rad;
    if (step > 0 && width < motion::fewest_steps_in_presliding * step) {
      out.stage.reason.add({"loop.width_not_resolved",
                            {{"recording", recording.name},
                             {"step_rad", step},
                             {"steps", width / step},
                             {"width_rad", width},
                             {"needed", motion::fewest_steps_in_presliding}}});
      out.encoder_step_rad = step;
      out.step_is_of_print = is_of_print;
      continue;
    }
    if (loop.motion) {
      const double q_peak = q_peak_rad ? q_peak_rad->value : loop.motion->centre_rad;
      const TraceReader reader(loop.trace, 1 / loop.motion->frequency_Hz);
      loop.midline = find_loop_midline(recording, *loop.motion, q_peak, reader.torque_noise_Nm());
      if (!loop.midline) continue;
      loop.oscillation.cycles = loop.midline->cycles;
      loop.oscillation.steady_cycles = loop.midline->steady_cycles;
      loop.trace.midline_q_rad = loop.midline->q_rad;
      loop.trace.midline_Nm = loop.midline->midline_Nm;
      if (loop.midline->start_up_included) {
        out.stage.reason.add({"loop.start_up_in_midline", {{"recording", recording.name}}});
      }
    }
    loops.push_back(std::move(loop));
  }
  if (loops.empty()) {
    out.stage.state = statistics::StageState::not_identifiable;
    return made;
  }

  const double q_peak = q_peak_rad ? q_peak_rad->value : loops.front().oscillation.centre_rad;
  observe_bristle(loops, gear_ratio, q_peak, rough.ripple, known, made);

  out.found = true;
  out.stage.state =
      out.stage.reason.empty() ? statistics::StageState::done : statistics::StageState::partial;
  const LoopResult& first = loops.front();
  combine_midlines(loops, rough.ripple, gear_ratio, made);
  out.midline_q_rad = first.oscillation.centre_rad;
  if (first.midline) {
    made.steady_cycles = first.midline->cycle_means_Nm.size();
    out.midline_q_rad = first.midline->mean_q_rad;
    if (loops.size() == 1) out.midline_mean_cos = first.midline->mean_cos;
  }
  const auto [low, high] =
      std::minmax_element(first.trace.torque_Nm.begin(), first.trace.torque_Nm.end());
  out.loop_height_Nm = *high - *low;
  if (!first.trace.z_rad.empty()) {
    const TraceReader reader(first.trace, 1 / first.oscillation.frequency_Hz);
    std::size_t next = 0;
    if (auto points = find_loop_points(first.trace, reader, 0, next)) {
      out.points = *points;
      const bool is_symmetric = first.motion && !first.motion->has_even_harmonics();
      const Turns turns =
          read_turns(first.trace, reader, next, is_symmetric ? 1 / first.motion->frequency_Hz : 0);
      out.steady_points = average_turns(turns);
      widen_by_scatter(out.steady_points, turns.size(), out.points);
      if (out.steady_points.empty()) out.steady_points = out.points;
    }
  } else {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason.add({"loop.no_bristle_deflection",
                          {{"why", made.lugre ? made.lugre->fit.reason : Statement{}}}});
  }
  for (LoopResult& loop : loops) {
    out.oscillations.push_back(loop.oscillation);
    made.traces.push_back(std::move(loop.trace));
  }
  return made;
}

}  // namespace tribolog::method::hysteresis
