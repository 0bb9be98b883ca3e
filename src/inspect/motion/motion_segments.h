#pragma once
// A recording cut by what the joint is made to do, so that each part can be given the role in which
// an identification uses it.
//
// Strokes (strokes_and_ramps.h) that alternate over the same way belong together. Of few strokes,
// wide and slow, they are a sweep; of several narrow ones an oscillation; strokes as fast at their
// ends as in their middle are runs at constant speed. Where the torque rises steadily while the
// joint stands, it is a break-away ramp. What is left is rest or motion of no use.

#include <cstddef>
#include <string>
#include <vector>

#include "inspect/motion/angle_trace.h"

namespace tribolog::inspect::motion {

enum class MotionKind {
  rest,
  constant_speed,
  slow_sweep,
  oscillation,
  break_away_ramp,
  varying,  ///< Moves, but in no way that a stage reads: transfers, steps, mixed sines.
};

/// "constant speed", for people.
std::string to_string(MotionKind kind);

struct MotionSegment {
  MotionKind kind{};
  std::size_t first{};  ///< Samples of the trace, both included.
  std::size_t last{};
  double from_s{};
  double to_s{};
  double lowest_rad{};
  double highest_rad{};
  double speed_rad_s{};   ///< >= 0; of a sine or an oscillation the fastest, at the middle.
  std::size_t strokes{};  ///< 0 for rest and ramps.
  int direction{};        ///< +1 or -1: strokes of one direction alone; 0: both, or neither.
  double frequency_Hz{};  ///< Of what repeats; else 0.
  bool is_steady{};       ///< Its strokes are of constant speed.
  double effort_rate{};   ///< Of a ramp, in the effort's unit a second.
  bool joint_slid{};      ///< At the end of a ramp.
  std::string phase{};    ///< What the log calls the time in which it is; empty: nothing.

  [[nodiscard]] double duration_s() const { return to_s - from_s; }
  [[nodiscard]] double travel_rad() const { return highest_rad - lowest_rad; }
  [[nodiscard]] double cycles() const { return static_cast<double>(strokes) / 2; }
};

/// Strokes up to this travel that repeat are an oscillation, wider ones a sweep [rad, joint side].
inline constexpr double widest_oscillation_rad = 0.2;

/// Segments in the order of time, from the first sample to the last. Strokes of constant speed are
/// `constant_speed`, slow ones too: which of them are sweeps is seen only beside the other ones
/// (manifest_proposal.h).
std::vector<MotionSegment> cut_by_motion(const AngleTrace& trace);

}  // namespace tribolog::inspect::motion
