#pragma once
// Whether a quantity of a joint changes slowly all the time: a straight line over time, by least
// squares, with temperature beside it where that is taken into account.
//
// The control chart (control_chart.h) learns from what was before, and so follows a drift that is
// there from the start: it tells a step best. A line through all calibrations is the strongest test
// of a steady drift; the two share the chance of a false alarm. The slope over its standard error
// follows Student's t and is turned into the normal score of the same rank; a drift is told from
// |score| >= z on, where z leaves a chance of 0.15 % at any one time that one of the joint's
// quantities is told of without a drift (Bonferroni over the quantities).
//
// A step is told here as well, as a drift; a joint whose chart found a change is not asked. Where
// successive calibrations hang together, as after each other in one week, the chance is larger.

#include <cstddef>
#include <optional>
#include <vector>

#include "history/reference_line.h"

namespace tribolog::history {

/// Fewer calibrations are not asked for a drift.
inline constexpr std::size_t fewest_for_drift = 12;

/// Chance that a drift is told of a joint that has none, at any one time.
inline constexpr double drift_false_alarms = 0.0015;

/// Limit of the score for one of so many quantities.
double drift_limit(std::size_t watched);

struct SlowDrift {
  double score{};           ///< At the last calibration; > 0: rises.
  double per_day{};         ///< Slope, the quantity's unit in a day.
  double standard_error{};  ///< Of the slope.
  double freedom{};
  double at_start{};      ///< The line at the first calibration, and at the mean temperature.
  std::size_t visible{};  ///< The calibration from which on it is told without a break.
};

/// @param series in the order of time. @param days of each, from any day on.
/// @return nothing where no drift is told, or where time cannot be told from temperature.
std::optional<SlowDrift> find_slow_drift(const std::vector<SeriesPoint>& series,
                                         const std::vector<double>& days, bool with_temperature,
                                         std::size_t watched);

}  // namespace tribolog::history
