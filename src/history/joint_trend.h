#pragma once
// The calibrations of a joint over time: each quantity with its control chart.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "calibration/archived_calibration.h"
#include "history/control_chart.h"

namespace tribolog::history {

/// Which calibrations are only learned from. Those before are shown and not used.
struct Baseline {
  std::size_t count{fewest_learned};  ///< The first so many that can be used.
  std::string from;                   ///< "2026-01-31..."; with `to`: instead of the count.
  std::string to;                     ///< A day is meant whole.
  [[nodiscard]] bool is_by_date() const { return !from.empty() || !to.empty(); }
};

/// A smaller span of temperatures gives no line: it would be a guess.
inline constexpr double least_temperature_span_K = 2;

enum class LeftOut {
  none,
  before_baseline,
  not_usable,      ///< The calibration's own verdict on the quantity.
  other_gear,      ///< Another gear ratio than the latest calibration has.
  other_payload,   ///< Another payload than the latest, and the quantity holds it.
  no_temperature,  ///< Not stated, where the others' is taken into account.
};

/// How temperature was treated.
enum class TemperatureUse {
  corrected,     ///< By a straight line, fitted along.
  hardly_felt,   ///< The quantity hardly depends on it.
  too_even,      ///< It varied by less than least_temperature_span_K.
  not_recorded,  ///< By fewer than half of the calibrations.
};

struct HistoryPoint {
  std::string id;
  std::string measured_at;        ///< "2026-01-31T12:00:00Z"
  statistics::Estimate estimate;  ///< SI, motor side.
  std::optional<double> temperature_C;
  LeftOut left_out{LeftOut::none};
  std::optional<double> corrected;  ///< Of a charted point: brought to the reference's temperature.
  ChartPoint chart;                 ///< Of a charted point.
};

enum class TrendState {
  too_few,    ///< Nothing can be said yet.
  steady,     ///< No change is visible.
  apart,      ///< None, but single calibrations are far from the others.
  recovered,  ///< There was one; the values are back.
  warning,    ///< One stands.
};
Statement statement_of(TrendState state);

/// When a drift that goes on as it did reaches a limit.
struct LimitDates {
  double percent{};      ///< The limit, of the reference, either way.
  std::string expected;  ///< "2027-08-14"
  std::string earliest;  ///< By the ends of the drift's interval, 95 %.
  std::string latest;    ///< Empty: by its slow end never, or not in this millennium.
};

/// A change that was found, in the quantity's unit.
struct FoundChange {
  bool is_slow{};     ///< A steady drift over all calibrations (reference_line.h); else a shift.
  int direction{};    ///< 1: risen.
  std::string from;   ///< Date from which it is visible; of a drift the first calibration's.
  std::string alarm;  ///< Date on which enough calibrations showed it.
  std::string back;   ///< Date of the first that is back; empty: it stands.
  std::size_t calibrations_to_alarm{};
  statistics::Estimate size;          ///< Mean of the last three of it less the reference; of a
                                      ///< drift, along its line from the first to the last.
  double drift_start{};               ///< Of a drift: its line at the first calibration,
  double drift_days{};                ///< and the days from there to the last.
  std::optional<double> percent;      ///< Of the reference.
  std::optional<LimitDates> limit{};  ///< See state_limits().
};

/// A calibration that stands apart from the others, in no change.
struct FoundApart {
  std::string at;                 ///< Its date.
  double size{};                  ///< Less the reference, in the quantity's unit.
  std::optional<double> percent;  ///< Of the reference.
  bool is_latest{};
};

struct QuantityTrend {
  std::string name;
  std::string words;
  std::string unit;                  ///< Of the latest calibration with an estimate.
  std::vector<HistoryPoint> points;  ///< In time; those with an estimate in this unit.
  std::size_t without_estimate{};
  std::size_t in_another_unit{};  ///< In amperes, where the latest is in N·m, or in N·m.
  std::size_t learned{};          ///< Charted points that were only learned from.
  std::size_t judged{};
  TemperatureUse temperature{TemperatureUse::not_recorded};
  double limit{};
  std::optional<ReferenceLine> reference;
  std::vector<FoundChange> changes;
  std::vector<FoundApart> apart;
  TrendState state{TrendState::too_few};

  [[nodiscard]] std::size_t count(LeftOut why) const;
  /// All that have the quantity, with an estimate or without.
  [[nodiscard]] std::size_t calibrations() const {
    return points.size() + without_estimate + in_another_unit;
  }
};

struct JointTrend {
  calibration::JointName of;
  std::size_t calibrations{};
  std::string first_at;  ///< Times of the first and the last calibration.
  std::string last_at;
  Baseline baseline;
  std::size_t watched{};  ///< Quantities with a chart.
  std::vector<QuantityTrend> quantities;
  std::vector<Statement> cautions;

  /// The worst of all.
  [[nodiscard]] TrendState state() const;
};

/// One for each joint, in their order.
/// @param calibrations as CalibrationArchive::measured() gives them, each inputs' latest revision.
/// @throw UsageError: a baseline of fewer than fewest_learned, or texts that are not dates.
std::vector<JointTrend> joint_trends(const std::vector<calibration::Measured>& calibrations,
                                     const Baseline& baseline);

/// Says of each steady drift when it reaches so many percent of the reference.
/// @param percent > 0
void state_limits(std::vector<JointTrend>& trends, double percent);

}  // namespace tribolog::history
