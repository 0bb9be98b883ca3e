#pragma once
// The points A to F of one turn of the hysteresis loop, and reading a noisy torque at an instant.

#include <cstddef>
#include <optional>
#include <vector>

#include "method/hysteresis/hysteresis_loop.h"

namespace tribolog {

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
  bool is_clean_;  ///< The noise is next to nothing of the torque's range.
};

/// The six points of the turn that begins at the first upward zero of z at or after `first`, in the
/// order A..F; `next` receives the index at which the following turn may be looked for. Absent if
/// the trace ends before the turn is complete.
std::optional<std::vector<LoopPoint>> find_loop_points(const LoopTrace& trace,
                                                       const TraceReader& reader, std::size_t first,
                                                       std::size_t& next);

}  // namespace tribolog
