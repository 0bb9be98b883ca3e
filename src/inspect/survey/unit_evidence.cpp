// Units of angles, speeds and the clock that the log does not state: what its numbers say of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/requirements.h"
#include "ingest/log/units.h"
#include "inspect/survey/column_guess.h"
#include "inspect/survey/survey_parts.h"
#include "joint/degrees.h"
#include "joint/wrapped_angle.h"

namespace tribolog::inspect::survey {

std::optional<std::size_t> first_column(const TableSurvey& table, ingest::log::Quantity quantity,
                                        const std::string& joint, bool is_target) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const auto& meaning = table.columns[k].meaning;
    if (!meaning || meaning->quantity != quantity || meaning->is_target != is_target) continue;
    if (meaning->joint == joint) return k;
  }
  return std::nullopt;
}

namespace {

using ingest::log::Quantity;
using std::numbers::pi;

/// Of a ratio of two columns, whose filters and noise differ.
constexpr double tolerance = 0.03;
/// Of a clock: 1/1024 s is no millisecond.
constexpr double clock_tolerance = 0.012;

bool is_near(double value, double expected, double within = tolerance) {
  return std::abs(value / expected - 1) < within;
}

struct NamedFactor {
  const char* unit;
  double factor;
};

const std::array angle_units{NamedFactor{"rad", 1}, NamedFactor{"deg", joint::rad_per_degree},
                             NamedFactor{"turn", 2 * pi}, NamedFactor{"mrad", 1e-3}};
const std::array speed_units{NamedFactor{"rad/s", 1}, NamedFactor{"deg/s", joint::rad_per_degree},
                             NamedFactor{"rpm", 2 * pi / 60}, NamedFactor{"turn/s", 2 * pi},
                             NamedFactor{"mrad/s", 1e-3}};
constexpr std::array ticks{NamedFactor{"s", 1},
                           NamedFactor{"ms", 1e-3},
                           NamedFactor{"us", 1e-6},
                           NamedFactor{"ns", 1e-9},
                           NamedFactor{"min", 60},
                           NamedFactor{"100 ns", 1e-7},
                           NamedFactor{"10 us", 1e-5},
                           NamedFactor{"100 us", 1e-4},
                           NamedFactor{"0.5 ms", 5e-4},
                           NamedFactor{"2 ms", 2e-3},
                           NamedFactor{"4 ms", 4e-3},
                           NamedFactor{"5 ms", 5e-3},
                           NamedFactor{"8 ms", 8e-3},
                           NamedFactor{"10 ms", 1e-2},
                           NamedFactor{"0.125 ms", 1.25e-4},
                           NamedFactor{"0.25 ms", 2.5e-4},
                           NamedFactor{"0.0009765625 s", 1.0 / 1024},
                           NamedFactor{"h", 3600}};

template <class Units>
const NamedFactor* unit_with(const Units& units, double factor, double within = tolerance) {
  const auto it = std::find_if(units.begin(), units.end(), [&](const NamedFactor& one) {
    return is_near(factor, one.factor, within);
  });
  return it == units.end() ? nullptr : &*it;
}

/// The number of counts in a turn that encoders have, a power of two or a few thousands, of which
/// an angle's step is one; nothing where it is none.
std::optional<double> counts_of_a_turn(double step, double turn) {
  constexpr double precise = 1e-3;  // logs print few decimals
  constexpr double fewest = 400;
  if (!(step > 0) || turn / step < fewest) return std::nullopt;
  const double counts = turn / step;
  const auto is = [&](double encoder) { return std::abs(counts / encoder - 1) < precise; };
  const double power = std::exp2(std::round(std::log2(counts)));
  if (is(power)) return power;
  const double decade = std::pow(10, std::floor(std::log10(counts)));
  for (const double times : {1.0, 2.0, 4.0, 5.0, 8.0, 10.0}) {
    if (is(times * decade)) return times * decade;
  }
  return std::nullopt;
}

/// Whether an angle wraps round as radians do: by their turn, or by the field of +-12.5 rad that
/// many drives' messages have.
bool wraps_in_radians(const ingest::log::LogTable& data, const TableSurvey& table, std::size_t k) {
  constexpr double turn = 2 * pi;
  constexpr double field = 25;
  if (!table.time) return false;
  const auto wraps = joint::find_wraps(data.columns[*table.time].values, data.columns[k].values,
                                       {turn, turn * joint::degrees_per_rad});
  return wraps && (wraps->period == turn || wraps->period == field);
}

/// One joint's angle and speed, and what their ratio says of their units and of the clock's.
class UnitsBySlope {
 public:
  UnitsBySlope(const ingest::log::LogTable& data, TableSurvey& table, std::size_t angle,
               std::size_t speed)
      : table_(table), angle_(angle), speed_(speed) {
    if (!table.clock) return;
    std::vector<double> t_s = data.columns[present(table.time)].values;
    for (double& t : t_s) t *= table.clock->seconds_per_unit;
    ratio_ = speed_by_slope(t_s, data.columns[angle].values, data.columns[speed].values);
    if (ratio_) ratio_ = std::abs(*ratio_);  // the speed may count the other way
  }

  /// @return whether the angle's unit is known then.
  bool find() {
    if (!ratio_ || !(*ratio_ > 0)) return false;
    const auto of_angle = stated(angle_);
    const auto of_speed = stated(speed_);
    if (of_angle && of_speed) return find_clock(*of_angle / (*ratio_ * *of_speed));
    if (of_angle) return find_speed(*of_angle / *ratio_);
    if (of_speed) return find_angle(*ratio_ * *of_speed);
    return find_both();
  }

 private:
  [[nodiscard]] ingest::layout::ColumnMeaning& meaning(std::size_t column) {
    return present(table_.columns[column].meaning);
  }

  [[nodiscard]] std::optional<double> stated(std::size_t column) {
    const ingest::layout::ColumnMeaning& of = meaning(column);
    return of.unit_is_stated ? ingest::log::find_si_factor(of.quantity, of.unit) : std::nullopt;
  }

  void prove(std::size_t column, const std::string& unit, const std::string& reason) {
    meaning(column).unit = unit;
    table_.columns[column].unit_by = reason;
    table_.columns[column].unit_is_proven = true;
  }

  void prove_clock(const std::string& reason) {
    ClockSurvey& clock = present(table_.clock);
    if (clock.unit_is_stated || clock.is_proven) return;
    clock.is_proven = true;
    clock.unit_by = reason;
  }

  /// @param seconds of one that is taken for a second.
  bool find_clock(double seconds) {
    ClockSurvey& clock = present(table_.clock);
    if (clock.unit_is_stated || clock.is_proven) return true;
    const NamedFactor* const tick =
        unit_with(ticks, seconds * clock.seconds_per_unit, clock_tolerance);
    if (tick == nullptr) return true;
    clock.change_unit(tick->unit, tick->factor);
    prove_clock("with it the speed is the slope of the angle");
    return true;
  }

  bool find_speed(double factor) {
    const NamedFactor* const unit = unit_with(speed_units, factor);
    if (unit != nullptr) {
      prove(speed_, unit->unit, "with it the speed is the slope of the angle");
      if (is_near(factor, unit->factor, clock_tolerance)) {
        prove_clock("with it the speed is the slope of the angle");
      }
    } else {
      meaning(speed_).unit = meaning(angle_).unit + "/s";
    }
    return true;
  }

  bool find_angle(double factor) {
    const ClockSurvey& clock = present(table_.clock);
    const bool knows_clock = clock.unit_is_stated || clock.is_proven;
    const std::string reason = "with it the speed is the slope of the angle";
    if (const NamedFactor* const unit = unit_with(angle_units, factor)) {
      prove(angle_, unit->unit, reason);
      if (is_near(factor, unit->factor, clock_tolerance)) prove_clock(reason);
      return true;
    }
    if (meaning(angle_).unit_is_ambiguous && is_near(factor, 2 * pi / 400)) {
      prove(angle_, "0.0025 turn", "a 400th of a turn: " + reason);
      return true;
    }
    const auto counts = knows_clock ? counts_of_a_turn(factor, 2 * pi) : std::nullopt;
    if (!counts) return false;
    prove(angle_, fmt::format("{} turn", 1 / *counts),
          fmt::format("{:.0f} counts a turn: {}", *counts, reason));
    return true;
  }

  /// By units that are usual together and have a ratio of their own. In equal units, whatever they
  /// are, the ratio is 1, and the clock is in seconds.
  bool find_both() {
    for (const NamedFactor& angle : angle_units) {
      for (const NamedFactor& speed : speed_units) {
        const double expected = angle.factor / speed.factor;
        const bool is_usual = angle.factor != 1e-3 && speed.factor != 1e-3;
        if (!is_usual || is_near(expected, 1) || !is_near(*ratio_, expected)) continue;
        const std::string reason =
            fmt::format("the speed is {:.4g} times the angle's slope", *ratio_);
        prove(angle_, angle.unit, reason);
        prove(speed_, speed.unit, reason);
        if (is_near(*ratio_, expected, clock_tolerance)) prove_clock(reason);
        return true;
      }
    }
    ClockSurvey& clock = present(table_.clock);
    if (is_near(*ratio_, 1, clock_tolerance)) {
      prove_clock("with it the speed is the slope of the angle");
    } else if (!clock.unit_is_stated && !clock.is_proven) {
      // Not proven: the units of angle and speed may differ instead.
      const NamedFactor* const tick =
          unit_with(ticks, clock.seconds_per_unit / *ratio_, clock_tolerance);
      if (tick != nullptr) {
        clock.change_unit(tick->unit, tick->factor);
        clock.unit_by = "with it the speed is the slope of the angle, if they are in equal units";
      }
    }
    return false;
  }

  TableSurvey& table_;
  std::size_t angle_;
  std::size_t speed_;
  std::optional<double> ratio_;
};

/// Of an angle whose unit is not stated and does not follow from a speed: degrees where radians
/// make no sense.
void guess_angle_unit(const ingest::log::LogTable& data, TableSurvey& table, std::size_t k,
                      std::optional<std::size_t> speed) {
  ColumnSurvey& column = table.columns[k];
  ingest::layout::ColumnMeaning& meaning = present(column.meaning);
  if (!column.unit_by.empty()) return;  // a logger's usual unit
  const bool is_large = looks_like_degrees(data.columns[k].values, column.gear_ratio);
  if (!is_large || wraps_in_radians(data, table, k)) return;
  if (counts_of_a_turn(column.step, 2 * pi)) {
    column.unit_by = "its steps are those of an encoder's turn of 2π";
    return;
  }
  meaning.unit = "deg";
  column.unit_by = "no joint turns by so many radians";
  if (!speed) return;
  ingest::layout::ColumnMeaning& of_speed = present(table.columns[*speed].meaning);
  if (!of_speed.unit_is_stated && !table.columns[*speed].unit_is_proven) of_speed.unit = "deg/s";
}

/// Beside a gear an angle of more than two turns may be the motor's, whatever its unit.
void look_at_side(ColumnSurvey& column) {
  constexpr double most_rad = 4 * pi;
  const ingest::layout::ColumnMeaning& meaning = present(column.meaning);
  const double factor = present(ingest::log::find_si_factor(Quantity::angle, meaning.unit));
  const double range_rad = (column.highest - column.lowest) * factor;
  column.side_is_open =
      column.has_gear && !column.side_is_stated && !column.is_at_motor && range_rad > most_rad;
}

}  // namespace

void ClockSurvey::change_unit(const std::string& to, double seconds) {
  const double times = seconds / seconds_per_unit;
  unit = to;
  seconds_per_unit = seconds;
  for (double* const value : {&first_s, &last_s, &interval_s, &largest_step_back_s})
    *value *= times;
  for (ClockGap& gap : gaps) gap = {gap.at_s * times, gap.length_s * times};
}

void find_units(const ingest::log::LogTable& data, TableSurvey& table) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    auto& meaning = table.columns[k].meaning;
    const bool is_angle = meaning && meaning->quantity == Quantity::angle && !meaning->is_target;
    if (!is_angle) continue;
    const auto speed = first_column(table, Quantity::angular_speed, meaning->joint, false);
    const bool is_known = speed && UnitsBySlope(data, table, k, *speed).find();
    if (!is_known && !meaning->unit_is_stated) guess_angle_unit(data, table, k, speed);
    if (!is_known && meaning->unit_is_stated && speed) {
      ingest::layout::ColumnMeaning& of_speed = present(table.columns[*speed].meaning);
      if (!of_speed.unit_is_stated) of_speed.unit = meaning->unit + "/s";
    }
    look_at_side(table.columns[k]);
  }
  if (table.clock && table.time)
    present(table.columns[*table.time].meaning).unit = table.clock->unit;
}

}  // namespace tribolog::inspect::survey
