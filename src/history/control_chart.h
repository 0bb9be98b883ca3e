#pragma once
// Whether a quantity of a joint has moved, and from when on: a self-starting two-sided CUSUM.
//
// Each calibration is held against what the ones before it let expect (reference_line.h), so that
// neither level nor scatter has to be known beforehand: the standardised difference follows
// Student's t and is turned into the normal score z of the same rank (D. M. Hawkins, "Self-starting
// CUSUM charts for location and scale", The Statistician 36, 1987; with temperature these are the
// recursive residuals of Brown, Durbin and Evans, 1975). The scores feed the tabular CUSUM
// (E. S. Page, Biometrika 41, 1954; Montgomery, section 9.1)
//
//   C+ = max(0, C+ + z - k),   C- = max(0, C- - z - k),   alarm at C >= h
//
// k = 0.5: aims at shifts of one standard deviation of a single calibration.
//
// h = 9.3 + ln(number of quantities watched on the joint). By Siegmund's formula (D. Siegmund,
// Sequential Analysis, 1985) ARL = (exp(2 k b) - 2 k b - 1) / (4 k^2), b = h + 1.166, this is a
// false alarm in about 35 000 calibrations of the joint, all its quantities together. That the
// scatter is estimated, from few calibrations, and that its estimates hang together, costs a part
// of it: simulated are, with those of reference_line.h, 0.4 % of the joints within their first 20
// calibrations and 2 % within 100. A fleet of thousands of joints can still be followed up; a lower
// h would find more and drown it.
//
// A score counts as 4 at most, so that no single odd calibration raises an alarm. One whose whole
// score, against those that are not odd, is 4.5 or more (seven in a million by chance) stands
// apart: it is reported as such, and the reference at the end is without it.
//
// The change began, as far as the alarm can know, at that of the calibrations since the sum last
// left zero from which on a shift is likeliest: the largest (sum of d)^2 / n of their standardised
// differences d from what was before (D. V. Hinkley, Biometrika 57, 1970).
//
// What it cannot see: a change that is there from the first calibration on; and of a drift that
// began among the calibrations it learned from, only what follows.
//
// An alarm freezes the reference to what lay before the change. It stands until the values are
// back: Page's test again, of no change against the change that was found, with a chance of 1 in
// 1000 to say so wrongly.

#include <cstddef>
#include <optional>
#include <vector>

#include "history/reference_line.h"

namespace tribolog::history {

/// Calibrations that are only learned from: a scatter from fewer is hardly known.
inline constexpr std::size_t fewest_learned = 6;
inline constexpr double cusum_allowance = 0.5;
inline constexpr double largest_score = 4;
inline constexpr double apart_score = 4.5;

/// As simulated, one false alarm of a joint in so many calibrations or more.
inline constexpr std::size_t calibrations_per_false_alarm = 2000;

/// h for a chart that is one of so many on its joint.
double cusum_limit(std::size_t watched);

struct ChartSettings {
  std::size_t learned{fewest_learned};  ///< The first so many; at least fewest_learned.
  std::size_t watched{1};               ///< Quantities of the joint that have a chart.
  bool with_slope{false};               ///< Temperature is taken into account.
};

struct ChartPoint {
  bool is_judged{false};  ///< false: learned from, or nothing to hold it against.
  bool is_apart{false};   ///< By itself, whatever the others do.
  double score{};         ///< -4 to 4.
  double above{};         ///< C+, at most twice the limit.
  double below{};         ///< C-
};

/// A change that raised an alarm.
struct Excursion {
  int direction{};                  ///< 1: risen, -1: fallen.
  std::size_t start{};              ///< The calibration with which it began; see above.
  std::size_t alarm{};              ///< At which it reached the limit.
  std::optional<std::size_t> back;  ///< First of those that are back at the reference.
};

struct ControlChart {
  double limit{};
  std::vector<ChartPoint> points;          ///< One for each of the series.
  std::vector<Excursion> excursions;       ///< In time.
  std::optional<ReferenceLine> reference;  ///< All calibrations in no excursion; absent: too few.

  [[nodiscard]] std::size_t judged() const;
  /// The one that stands, if one does.
  [[nodiscard]] const Excursion* warning() const;
};

/// @param series in the order of time.
ControlChart make_control_chart(const std::vector<SeriesPoint>& series,
                                const ChartSettings& settings);

}  // namespace tribolog::history
