#pragma once
// The history of one result as a line of the size of a word: SVG path data, in whole half pixels.

#include <string>

#include "history/fleet.h"

namespace tribolog::report::timeline {

/// Twice the size in pixels.
inline constexpr int sparkline_width = 184;
inline constexpr int sparkline_height = 52;

/// Paths; empty: not drawn. From left to right runs the time of the whole fleet. The height is the
/// cell's own and holds the whole band, so that noise stays small.
struct Sparkline {
  std::string band;     ///< Where the latest would be no outlier of its own history.
  std::string others;   ///< Median of the others; at the edge where it is farther away.
  std::string history;  ///< The results, and the interval of the latest.
  std::string latest;   ///< A dot.
};

Sparkline sparkline_of(const history::FleetCell& cell, const history::Fleet& fleet);

}  // namespace tribolog::report::timeline
