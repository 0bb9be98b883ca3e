#pragma once
// The motion of a joint driven by a torque: not a sine, often not periodic, with loops of any size.
// A smoothing spline through the recorded angle (smoothing_spline.h), through the edges of its
// steps where the angle is quantised (traced_motion.cpp).
//
// The noise is estimated from the angle: the rounding of an encoder step, step/sqrt(12), or the
// white noise from third differences where that is larger than a step.

#include <memory>
#include <optional>
#include <vector>

#include "base/statement.h"
#include "joint/recording.h"
#include "simulate/motion.h"
#include "statistics/smoothing_spline.h"

namespace tribolog::method::motion {

struct TracedMotion {
  double noise_rad{};           ///< Standard deviation, joint side.
  double encoder_step_rad{};    ///< 0: the angle looks continuous.
  double residual_rad{};        ///< Standard deviation of q less the spline.
  double centre_rad{};          ///< Halfway between the extremes.
  double amplitude_rad{};       ///< Half the distance between them.
  double frequency_Hz{};        ///< Half the number of strokes per second.
  std::vector<double> turns_s;  ///< Times of the reversals between strokes, since the first sample.

  [[nodiscard]] std::size_t strokes() const { return turns_s.size() + 1; }
  /// Whether the noise is that of the encoder's steps.
  [[nodiscard]] bool is_stepped() const { return noise_rad < encoder_step_rad; }
  /// The source of the noise: the step of the encoder, or the scatter of the samples.
  [[nodiscard]] Statement noise_source() const;
  /// Motor-side motion as a function of the time since the first sample.
  [[nodiscard]] std::unique_ptr<simulate::Motion> motor_motion(double gear_ratio) const;

  // The joint's angle from its first sample, against the time since then.
  std::shared_ptr<const statistics::SmoothingSpline> spline;
  double origin_rad{};
};

struct MotionTrace {
  std::optional<TracedMotion> motion;
  Statement refusal;  ///< Why there is none, with the number; empty if there is one.
};

/// Standard deviation of the noise of an angle [rad], joint side: of rounding to the encoder's
/// step, or of the samples where they scatter by more.
double noise_of_angle(const std::vector<double>& q_rad, double encoder_step_rad);

/// Refuses an angle that is too short, does not reverse twice, is sampled too coarsely for its
/// strokes, or is too rough to have a speed.
/// @param found the same motion, traced before: it is smoothed about as much (see SmoothingSpline).
/// @param weighed_from_s since the first sample: what comes before does not choose how much is
/// smoothed. A drive that starts at once moves as the joint never does later.
MotionTrace trace_motion(const joint::Recording& recording, const TracedMotion* found = nullptr,
                         double weighed_from_s = 0);

}  // namespace tribolog::method::motion
