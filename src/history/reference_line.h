#pragma once
// What a quantity is expected to be: the level of some calibrations of a joint, over temperature
// where that is asked for, and how far single calibrations scatter about it.
//
// Model: x = level + slope (T - T_mean) + e, where e has the variance f u^2 + tau^2: u is the
// standard error that the calibration itself states, tau the scatter between calibrations beyond
// it. Both come from the moving ranges, the differences d of successive residuals, which a slow
// drift or a single step hardly touches (von Neumann 1941; Montgomery, Introduction to Statistical
// Quality Control, section 6.4). With V = sum d^2 / (2 (m - p)), m members and p parameters:
//
//   V >= mean u^2:  f = 1,  tau^2 = V - mean u^2    calibrations scatter more than they state
//   V <  mean u^2:  f = V / mean u^2,  tau = 0      their intervals hold an error that all share,
//                                                   such as that of the model; it hides no change
//                                                   (R. T. Birge, Physical Review 40, 1932)
//
// Either way the scatter is the one that is seen, and wide intervals weigh less.

#include <cstddef>
#include <optional>
#include <vector>

namespace tribolog::history {

/// One calibration's value of a quantity, SI.
struct SeriesPoint {
  double value{};
  double standard_error{};  ///< As its interval states it.
  double temperature_C{};   ///< Where the line has a slope.
};

struct Expectation {
  double value{};
  double variance{};  ///< Of the expectation itself.
};

class ReferenceLine {
 public:
  /// @param members at least 3 of the points, rising; with_slope: at least 4.
  /// @param with_slope the level changes with temperature; needs temperatures that differ.
  /// @return nothing where there are too few members or their temperatures are all the same.
  static std::optional<ReferenceLine> fitted(const std::vector<SeriesPoint>& points,
                                             const std::vector<std::size_t>& members,
                                             bool with_slope);

  [[nodiscard]] Expectation at(double temperature_C) const;
  /// Variance of one calibration with this standard error about the line.
  [[nodiscard]] double variance_of(double standard_error) const;
  /// (value - expected) / sqrt(variance of both).
  [[nodiscard]] double standardised(const SeriesPoint& point) const;

  double level{};        ///< At `mean_temperature_C`.
  double slope_per_K{};  ///< 0 without slope.
  double level_variance{};
  double slope_variance{};
  double mean_temperature_C{};
  double between_variance{};  ///< tau^2
  double stated_variance{};   ///< Mean u^2 of the members.
  double stated_share{1};     ///< f
  double freedom{};           ///< Of the moving ranges; about two thirds of the members.
  std::size_t members{};

  /// Standard deviation of a single calibration with a usual interval.
  [[nodiscard]] double scatter() const;
};

// Whether a quantity of a joint changes slowly all the time: a straight line over time, by least
// squares, with temperature beside it where that is taken into account.
//
// The control chart (control_chart.h) learns from what was before, and so follows a drift that is
// there from the start: it detects a step best. A line through all calibrations is the strongest
// test of a steady drift; the two share the chance of a false alarm. The slope over its standard
// error follows Student's t and is turned into the normal score of the same rank; a drift is
// reported from |score| >= z on, where z leaves a chance of 0.15 % at any one time that one of the
// joint's quantities is reported without a drift (Bonferroni over the quantities).
//
// A step is reported here as well, as a drift; a joint whose chart found a change is not asked.
// Where successive calibrations hang together, as after each other in one week, the chance is
// larger.

/// Fewer calibrations are not asked for a drift.
inline constexpr std::size_t fewest_for_drift = 12;

/// Probability that a drift is reported of a joint without one, at any one time.
inline constexpr double drift_false_alarms = 0.0015;

/// Limit of the score for one of so many quantities.
double drift_limit(std::size_t watched);

struct SlowDrift {
  double score{};           ///< At the last calibration; > 0: rises.
  double per_day{};         ///< Slope, the quantity's unit in a day.
  double standard_error{};  ///< Of the slope.
  double freedom{};
  double at_start{};      ///< The line at the first calibration, and at the mean temperature.
  std::size_t visible{};  ///< The calibration from which on it is reported without a break.
};

/// @param series in the order of time. @param days of each, from any day on.
/// @return nothing where no drift is seen, or where time cannot be separated from temperature.
std::optional<SlowDrift> find_slow_drift(const std::vector<SeriesPoint>& series,
                                         const std::vector<double>& days, bool with_temperature,
                                         std::size_t watched);

}  // namespace tribolog::history
