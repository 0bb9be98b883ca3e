#pragma once
// The points A to F of one turn of the hysteresis loop, and its mid-line.

#include <cstddef>
#include <optional>
#include <vector>

#include "joint/recording.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "method/motion/oscillation_motion.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

// The mid-line of a steady loop: what remains of the torque when friction has cancelled.
//
// In a steady loop under a motion that is half-wave symmetric, friction is half-wave antisymmetric:
// Tf(t + P/2) = -Tf(t). Its mean over whole cycles is zero whatever the model, and the mean torque
// is gravity's alone. The same holds for the torque of inertia. Readings of single points have no
// such protection.
//
// A second harmonic of the motion breaks the symmetry in time: the joint spends more time on one
// side of the loop than on the other. Friction that depends on the path alone, as in pre-sliding,
// is not affected: its mean over the angle, there and back, is still zero. Where the motion has
// such harmonics samples are therefore weighted by |dq/dt|.

struct LoopMidline {
  statistics::Estimate torque_Nm;  ///< Mean over the steady cycles, motor side.
  double mean_cos{1.0};            ///< Mean of cos(q - q_peak) over the same cycles.
  double mean_q_rad{};
  double cycles{};         ///< Whole cycles in the recording.
  double steady_cycles{};  ///< Those averaged.
  /// Mean distance of the torque from its mean over the same cycles: the loop's friction.
  double friction_Nm{};
  bool by_angle{false};           ///< Mean over the angle, the motion having even harmonics.
  bool start_up_included{false};  ///< Only one cycle was recorded, start-up stroke and all.
  std::vector<double> cycle_means_Nm;
  /// Mid-line over the angle, (rising + falling branch) / 2, for figures.
  std::vector<double> q_rad;
  std::vector<double> midline_Nm;
};

/// @param white_noise_Nm of the torque samples; gives the interval where cycles are too few.
std::optional<LoopMidline> find_loop_midline(const joint::Recording& recording,
                                             const motion::OscillationMotion& motion,
                                             double q_peak_rad, double white_noise_Nm);

// The points A to F of one turn of the hysteresis loop, and reading a noisy torque at an instant.

/// Torque at one instant with the 95 % half width of the reading.
struct TorqueReading {
  double value_Nm{};
  double half_width_Nm{};
};

/// Reads signals of a trace between samples. A noisy torque is read from a parabola fitted to the
/// samples within 1 % of the period (one-sided at the ends); a clean one by cubic interpolation.
class TraceReader {
 public:
  TraceReader(const LoopTrace& trace, double period_s);
  [[nodiscard]] TorqueReading torque(double t_s) const;
  [[nodiscard]] double interpolate(const std::vector<double>& signal, double t_s) const;
  [[nodiscard]] double torque_noise_Nm() const { return noise_Nm_; }

 private:
  [[nodiscard]] std::size_t interval_of(double t_s) const;
  /// By the cubic through the four samples around.
  [[nodiscard]] double smooth_torque(double t_s) const;
  const LoopTrace& trace_;
  double window_s_;
  double noise_Nm_;
  bool is_clean_;  ///< The noise is negligible relative to the torque's range.
};

/// Reads E and F of a turn again, half a period apart about their middle: under a motion that is
/// half-wave symmetric friction is then the same in both, and their mean is gravity's. Where the
/// bristle's speed is largest it is flat, and every error of the motion shifts the two apart.
void put_half_a_period_apart(const LoopTrace& trace, const TraceReader& reader, double period_s,
                             std::vector<LoopPoint>& points);

/// The six points of the turn that begins at the first upward zero of z at or after `first`, in the
/// order A..F; `next` receives the index at which the following turn may be looked for. Absent if
/// the trace ends before the turn is complete.
std::optional<std::vector<LoopPoint>> find_loop_points(const LoopTrace& trace,
                                                       const TraceReader& reader, std::size_t first,
                                                       std::size_t& next);

}  // namespace tribolog::method::hysteresis
