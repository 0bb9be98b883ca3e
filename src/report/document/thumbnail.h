#pragma once
// A joint's hysteresis loop and friction curve at the size of a stamp: SVG path data, in pixels.

#include <optional>
#include <string>

#include "calibration/calibration.h"

namespace tribolog::report::document {

inline constexpr int thumbnail_width = 240;
inline constexpr int thumbnail_height = 130;

/// Paths and the ranges that they span, in words. None of them is empty but `fitted`.
struct Thumbnail {
  std::string measured;
  bool is_of_points{};  ///< It is a dot for each point, else a line.
  std::string fitted;   ///< Of the fitted model; empty: there is none.
  std::string zero;     ///< The line of no torque; at the edge where it is outside.
  std::string across;   ///< "0.12° wide"
  std::string up;       ///< "0.43 N·m high"
};

/// Last cycles of the first oscillation, motor torque over joint angle. Absent: none was recorded.
std::optional<Thumbnail> loop_thumbnail(const calibration::Calibration& calibration);

/// Friction torque over motor speed: the runs, and the likeliest law. Absent: there are no runs.
std::optional<Thumbnail> curve_thumbnail(const calibration::Calibration& calibration);

}  // namespace tribolog::report::document
