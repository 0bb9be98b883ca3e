#pragma once
// What a motion is cut into: strokes, from one stand or reversal to the next, and break-away ramps.

#include <cstddef>
#include <vector>

#include "inspect/motion/angle_trace.h"

namespace tribolog::inspect::motion {

// Found from the largest scale down, so that one recording may hold a sweep over the whole range
// and an oscillation ten thousand times smaller. At each scale the angle is cut at its turning
// points, wiggles below a twentieth of the range passed over; where it stays at a turning point
// longer than a reversal takes, it rests. Each rest is then looked at in the same way on the scale
// of its own range, down to the noise floor. No threshold is an angle or a time: the cut is the
// same in degrees and radians, in seconds and milliseconds.

struct AngleStroke {
  std::size_t first{};  ///< Sample with which it leaves its stand or turns.
  std::size_t last{};   ///< Sample with which it comes to its stand or turns.
  double travel_rad{};  ///< Signed.
  /// Whether it begins where the one before ends, without a rest in between.
  bool follows_on{};
};

/// Strokes of one scale within one stretch of time, in the order of time.
using StrokeFamily = std::vector<AngleStroke>;

/// @param noise_floor_rad changes below it are no motion.
/// @return families, larger scales first; none in a trace at rest.
std::vector<StrokeFamily> find_strokes(const AngleTrace& trace, double noise_floor_rad);

// Strokes that belong together: there and back over the same way, in the same time.

// Whether a stroke runs at constant speed, and how fast.
//
// The speed is taken from the angle: the mean slope between two marks of the travel. The speed that
// a controller logs is not trusted: some are two-point differences, which at low speed are steps of
// the encoder.

struct StrokeShape {
  double speed_rad_s{};  ///< Mean between 30 and 70 % of the travel, >= 0.
  /// As fast near its ends as in the middle: between 10 and 25 %, and 75 and 90 % of its travel, at
  /// least 0.87 of that; a sine is at 0.75 there, a speed that rises and falls linearly at 0.61. Or
  /// so at one end alone, and even in the middle: a run that creeps at first, or at last.
  bool is_steady{};
};

StrokeShape shape_of(const AngleTrace& trace, const AngleStroke& stroke);

struct StrokeGroup {
  std::vector<AngleStroke> strokes;  ///< In the order of time.
  std::vector<StrokeShape> shapes;   ///< Of each.
  bool is_steady{};                  ///< More than half of them.
  /// Most of a chain of strokes without rest belongs to none: mixed sines, for example.
  bool is_irregular{};

  [[nodiscard]] std::size_t first() const { return strokes.front().first; }
  [[nodiscard]] std::size_t last() const { return strokes.back().last; }
  [[nodiscard]] double travel_rad() const;   ///< Median of the strokes.
  [[nodiscard]] double speed_rad_s() const;  ///< Median of the strokes.
};

/// Groups in the order of time; a stroke like none of its neighbours is a group of its own. Travel
/// and time agree within 0.7 to 1.4 from one stroke to the next, speed of steady ones within 8 %; a
/// rest between is at most half as long as the shorter stroke. A half stroke at the start or the
/// end of a sine belongs to it, and so does a smaller one with which a narrow oscillation begins.
std::vector<StrokeGroup> group_strokes(const AngleTrace& trace, const StrokeFamily& family,
                                       double widest_oscillation_rad);

// Break-away ramps: the joint stands, the torque rises at a steady rate, until the joint slides or
// the ramp ends.

struct TorqueRamp {
  std::size_t first{};
  std::size_t last{};
  double rate{};      ///< Of the effort, in its unit a second; signed.
  bool joint_slid{};  ///< It moved far more in the second half than in the first.
};

/// The ramps of a log's effort.
class TorqueRampFinder {
 public:
  /// @param trace outlives the finder.
  /// @param floor_rad noise floor of the angle.
  TorqueRampFinder(const AngleTrace& trace, double floor_rad);

  /// @param first, last stretch looked at.
  /// @return ramps of a second or longer that rise by 3 % of the effort's range or more, and by a
  /// tenth where the joint does not move; none without effort.
  [[nodiscard]] std::vector<TorqueRamp> between(std::size_t first, std::size_t last) const;

 private:
  const AngleTrace& trace_;
  double floor_rad_;
  double floor_{};  ///< Noise floor of the effort.
  double range_{};  ///< Of the effort.
};

/// The ramps of two seconds or longer that noise of a hundredth of the effort's range or more hides
/// from TorqueRampFinder, each within one rest of the joint.
class NoisyRampFinder {
 public:
  /// @param trace outlives the finder.
  /// @param floor_rad noise floor of the angle.
  NoisyRampFinder(const AngleTrace& trace, double floor_rad);

  /// @param first, last stretch looked at.
  [[nodiscard]] std::vector<TorqueRamp> between(std::size_t first, std::size_t last) const;

 private:
  const AngleTrace& trace_;
  double rest_rad_;  ///< Within which the joint rests.
  double noise_{};   ///< White, of the effort.
  double range_{};   ///< Of the effort.
};

}  // namespace tribolog::inspect::motion
