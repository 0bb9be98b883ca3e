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

}  // namespace tribolog::history
