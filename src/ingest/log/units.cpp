#include "ingest/log/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "base/closest_match.h"
#include "joint/degrees.h"

namespace tribolog::ingest::log {
namespace {

using std::numbers::pi;

struct Unit {
  std::string_view name;  ///< Without blanks and multiplication signs.
  double si_factor;
  bool listed{true};  ///< Other spellings are accepted silently.
};

constexpr std::array times = {Unit{"s", 1},
                              Unit{"ms", 1e-3},
                              Unit{"us", 1e-6},
                              Unit{"ns", 1e-9},
                              Unit{"µs", 1e-6, false} /* micro sign */,
                              Unit{"μs", 1e-6, false} /* Greek mu */,
                              Unit{"sec", 1, false},
                              Unit{"min", 60, false},
                              Unit{"100ns", 1e-7, false} /* as Windows counts */};
constexpr std::array angles = {
    Unit{"rad", 1},
    Unit{"mrad", 1e-3},
    Unit{"deg", joint::rad_per_degree},
    Unit{"turn", 2 * pi},
    Unit{"°", joint::rad_per_degree, false},
    Unit{"rev", 2 * pi, false},
    Unit{"Grad", joint::rad_per_degree, false} /* German; Gon is another */,
    Unit{"radians", 1, false},
    Unit{"degrees", joint::rad_per_degree, false}};
constexpr std::array angular_speeds = {Unit{"rad/s", 1},
                                       Unit{"mrad/s", 1e-3},
                                       Unit{"deg/s", joint::rad_per_degree},
                                       Unit{"rpm", 2 * pi / 60},
                                       Unit{"turn/s", 2 * pi},
                                       Unit{"rev/s", 2 * pi, false},
                                       Unit{"°/s", joint::rad_per_degree, false},
                                       Unit{"Grad/s", joint::rad_per_degree, false},
                                       Unit{"Hz", 2 * pi, false} /* turns a second */,
                                       Unit{"1/min", 2 * pi / 60, false}};
constexpr std::array torques = {Unit{"Nm", 1}, Unit{"mNm", 1e-3}, Unit{"kNm", 1e3}};
constexpr std::array currents = {Unit{"A", 1}, Unit{"mA", 1e-3}};
constexpr std::array temperatures = {Unit{"degC", 1}, Unit{"°C", 1, false}, Unit{"C", 1, false},
                                     Unit{"celsius", 1, false}, Unit{"Celsius", 1, false}};

std::span<const Unit> units_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::time:
      return times;
    case Quantity::angle:
      return angles;
    case Quantity::angular_speed:
      return angular_speeds;
    case Quantity::torque:
      return torques;
    case Quantity::current:
      return currents;
    case Quantity::temperature:
      return temperatures;
  }
  return {};
}

/// Without blanks, '*' and the two signs '·' (middle dot, dot operator).
std::string bare(std::string_view unit) {
  std::string result;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const std::string_view rest = unit.substr(i);
    if (rest.starts_with("·")) {
      i += std::string_view("·").size() - 1;
    } else if (rest.starts_with("⋅")) {
      i += std::string_view("⋅").size() - 1;
    } else if (rest[0] != ' ' && rest[0] != '*') {
      result += rest[0];
    }
  }
  return result;
}

std::vector<std::string> listed_units(Quantity quantity) {
  std::vector<std::string> names;
  for (const Unit& unit : units_of(quantity)) {
    if (unit.listed) names.emplace_back(unit.name);
  }
  return names;
}

std::optional<double> factor_of_one(Quantity quantity, std::string_view name) {
  for (const Unit& known : units_of(quantity)) {
    if (known.name == name) return known.si_factor;
  }
  return std::nullopt;
}

}  // namespace

std::string quantity_word(Quantity quantity) {
  switch (quantity) {
    case Quantity::time:
      return "time";
    case Quantity::angle:
      return "angle";
    case Quantity::angular_speed:
      return "speed";
    case Quantity::torque:
      return "torque";
    case Quantity::current:
      return "current";
    case Quantity::temperature:
      return "temperature";
  }
  return "";
}

std::string to_string(Quantity quantity) {
  switch (quantity) {
    case Quantity::time:
      return "a time";
    case Quantity::angle:
      return "an angle";
    case Quantity::angular_speed:
      return "an angular speed";
    case Quantity::torque:
      return "a torque";
    case Quantity::current:
      return "a current";
    case Quantity::temperature:
      return "a temperature";
  }
  return "unknown";
}

std::string_view unit_of_time(ColumnReading reading) {
  switch (reading) {
    case ColumnReading::iso_time:
      return "iso8601";
    case ColumnReading::time_of_day:
      return "hh:mm:ss";
    case ColumnReading::date:
      return "yyyy-mm-dd";
    case ColumnReading::number:
    case ColumnReading::clock:
    case ColumnReading::words:
      break;
  }
  return "";
}

std::optional<ColumnReading> reading_of_time(std::string_view unit) {
  for (const ColumnReading reading :
       {ColumnReading::iso_time, ColumnReading::time_of_day, ColumnReading::date}) {
    if (unit_of_time(reading) == unit) return reading;
  }
  return std::nullopt;
}

std::string_view example_of_multiple(Quantity quantity) {
  switch (quantity) {
    case Quantity::angle:
      return "0.018 deg";
    case Quantity::angular_speed:
      return "0.1 rpm";
    case Quantity::torque:
      return "0.0013 Nm";
    case Quantity::current:
      return "0.002 A";
    case Quantity::time:
      return "60 s";
    case Quantity::temperature:
      return "0.1 degC";
  }
  return "";
}

std::optional<double> find_si_factor(Quantity quantity, std::string_view unit) {
  if (const auto factor = factor_of_one(quantity, bare(unit))) return factor;
  double multiple = 0;
  const char* const end = unit.data() + unit.size();
  const auto read = std::from_chars(unit.data(), end, multiple);
  constexpr double least = 1e-12;  // of an encoder's counts, say; far from where products vanish
  if (read.ec != std::errc() || !(multiple >= least && multiple <= 1 / least)) return std::nullopt;
  const auto factor = factor_of_one(quantity, bare({read.ptr, end}));
  return factor ? std::optional(multiple * *factor) : std::nullopt;
}

double si_factor(Quantity quantity, std::string_view unit, const Location& where) {
  if (const auto factor = find_si_factor(quantity, unit)) return *factor;
  std::string hint = did_you_mean(bare(unit), listed_units(quantity));
  if (hint.empty()) {
    hint =
        "a multiple of one will do, such as \"" + std::string(example_of_multiple(quantity)) + "\"";
  }
  throw InputError(where, {"unknown unit of " + to_string(quantity), in_quotes(unit),
                           "one of " + known_units(quantity), hint});
}

bool is_known_unit(std::string_view unit) {
  constexpr std::array all = {Quantity::time,   Quantity::angle,   Quantity::angular_speed,
                              Quantity::torque, Quantity::current, Quantity::temperature};
  const std::string name = bare(unit);
  return std::any_of(all.begin(), all.end(),
                     [&](Quantity quantity) { return factor_of_one(quantity, name).has_value(); });
}

std::string known_units(Quantity quantity) {
  std::string list;
  for (const std::string& name : listed_units(quantity)) {
    if (!list.empty()) list += ", ";
    list += name;
  }
  return list;
}

}  // namespace tribolog::ingest::log
