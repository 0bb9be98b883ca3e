#include "ingest/arrays/long_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"

namespace tribolog::ingest::arrays {
namespace {

/// The surest first: "name" is the joint's where another column tells the signal.
constexpr std::array signal_names = {"signal",    "signal_name",    "variable", "channel",
                                     "quantity",  "field",          "metric",   "measurement",
                                     "interface", "interface_name", "key",      "name"};
constexpr std::array value_names = {"value", "val", "reading", "data"};
constexpr std::array joint_names = {"joint",    "joint_name", "joint_id", "axis",
                                    "actuator", "motor",      "servo",    "name"};
constexpr std::array time_names = {"time", "timestamp", "t",       "stamp", "sec",    "secs",
                                   "nsec", "nsecs",     "nanosec", "t_s",   "time_s", "elapsed"};

/// "time" of "run/stamp.Time".
std::string last_name(const std::string& path) {
  const std::size_t end = path.find_last_of("/.");
  std::string name = end == std::string::npos ? path : path.substr(end + 1);
  name = name.substr(0, name.find_first_of(" [("));
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name;
}

/// "run/" of "run/stamp.time".
std::string front_of(const std::string& path) {
  const std::size_t end = path.rfind('/');
  return end == std::string::npos ? "" : path.substr(0, end + 1);
}

template <class Names>
bool is_one_of(const NamedArray& array, const Names& names) {
  return std::find(names.begin(), names.end(), last_name(array.name)) != names.end();
}

/// The columns of a log in long format.
struct LongColumns {
  std::size_t signal{};
  std::size_t value{};
  std::vector<std::size_t> times;
  std::optional<std::size_t> joint;
  std::optional<std::size_t> unit;
  std::vector<std::size_t> others;
};

/// What stands beside a column that tells the signals; nothing where value or time are missing.
std::optional<LongColumns> columns_beside(std::size_t signal,
                                          const std::vector<NamedArray>& arrays) {
  LongColumns found;
  found.signal = signal;
  bool has_value = false;
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    const NamedArray& one = arrays[k];
    const bool is_beside = k != signal && one.columns == 1 && one.rows == arrays[signal].rows &&
                           front_of(one.name) == front_of(arrays[signal].name);
    if (!is_beside) continue;
    const bool are_words = !one.words.empty();
    if (!are_words && !one.is_time && !has_value && is_one_of(one, value_names)) {
      found.value = k;
      has_value = true;
    } else if (!are_words && (one.is_time || is_one_of(one, time_names))) {
      found.times.push_back(k);
    } else if (!found.joint && is_one_of(one, joint_names)) {
      found.joint = k;
    } else if (are_words && !found.unit && last_name(one.name) == "unit") {
      found.unit = k;
    } else {
      found.others.push_back(k);
    }
  }
  return has_value && !found.times.empty() ? std::optional(found) : std::nullopt;
}

/// Of the first log in long format that there is.
std::optional<LongColumns> long_columns(const std::vector<NamedArray>& arrays) {
  for (const char* const name : signal_names) {
    for (std::size_t signal = 0; signal < arrays.size(); ++signal) {
      if (arrays[signal].words.empty() || last_name(arrays[signal].name) != name) continue;
      if (auto found = columns_beside(signal, arrays)) return found;
    }
  }
  return std::nullopt;
}

std::string word_at(const NamedArray& array, std::size_t row) {
  const double value = array.values[row];
  if (std::isnan(value)) return "";
  return array.words.empty() ? fmt::format("{}", value)
                             : array.words[static_cast<std::size_t>(value)];
}

/// Which reading of a log is in which row and in which column of the spread one.
struct SpreadReadings {
  std::vector<std::size_t> rows;
  std::vector<std::size_t> columns;
  std::vector<std::size_t> first_of_row;  ///< The first reading of each row.
  std::vector<std::string> names;         ///< Of the columns.
  std::vector<std::string> units;
};

SpreadReadings spread_readings(const std::vector<NamedArray>& arrays, const LongColumns& of) {
  SpreadReadings places;
  std::map<std::vector<double>, std::size_t> row_of_time;
  std::map<std::pair<double, double>, std::size_t> column_of_signal;
  std::vector<double> time(of.times.size());
  const NamedArray& signal = arrays[of.signal];
  for (std::size_t k = 0; k < signal.rows; ++k) {
    // What has no time is like nothing else, and a map knows no order of it.
    const auto time_of = [&](std::size_t array) {
      const double value = arrays[array].values[k];
      return std::isnan(value) ? -std::numeric_limits<double>::infinity() : value;
    };
    std::transform(of.times.begin(), of.times.end(), time.begin(), time_of);
    const auto [row, is_new_row] = row_of_time.emplace(time, row_of_time.size());
    if (is_new_row) places.first_of_row.push_back(k);
    places.rows.push_back(row->second);
    const auto number = [&](const NamedArray& array) {
      return std::isnan(array.values[k]) ? -1.0 : array.values[k];
    };
    const double joint = of.joint ? number(arrays[*of.joint]) : -1;
    const auto [column, is_new] =
        column_of_signal.emplace(std::pair{joint, number(signal)}, places.names.size());
    if (is_new) {
      const std::string whose = of.joint ? word_at(arrays[*of.joint], k) : "";
      std::string what = word_at(signal, k);
      if (whose.empty() && what.empty()) what = "value";  // the log does not say of what
      places.names.push_back(front_of(signal.name) +
                             (whose.empty() || what.empty() ? whose + what : whose + "." + what));
      places.units.push_back(of.unit ? word_at(arrays[*of.unit], k) : "");
    }
    places.columns.push_back(column->second);
  }
  return places;
}

/// Signals that are logged by turns, each at times of its own, would be columns of gaps.
bool have_times_in_common(const SpreadReadings& places) {
  const std::size_t cells = places.first_of_row.size() * places.names.size();
  return cells / 2 <= places.rows.size();
}

}  // namespace

std::vector<Statement> spread_signals(FileArrays& found) {
  std::vector<Statement> notes;
  while (const auto of = long_columns(found.arrays)) {
    const SpreadReadings places = spread_readings(found.arrays, *of);
    if (!have_times_in_common(places)) {
      found.leave_out(found.arrays[of->value].name,
                      "its signals have too few times in common to be columns");
      found.arrays.erase(found.arrays.begin() + static_cast<std::ptrdiff_t>(of->value));
      continue;
    }
    const std::size_t rows = places.first_of_row.size();
    std::vector<NamedArray> spread;
    for (const std::size_t time : of->times) {
      NamedArray clock = found.arrays[time];
      clock.rows = rows;
      clock.values.clear();
      for (const std::size_t k : places.first_of_row) {
        clock.values.push_back(found.arrays[time].values[k]);
      }
      spread.push_back(std::move(clock));
    }
    const std::size_t first = spread.size();
    for (std::size_t k = 0; k < places.names.size(); ++k) {
      NamedArray& signal = spread.emplace_back();
      signal.name = places.names[k];
      signal.unit = places.units[k];
      signal.was_rounded = found.arrays[of->value].was_rounded;
      signal.rows = rows;
      signal.values.assign(rows, std::numeric_limits<double>::quiet_NaN());
    }
    std::vector<bool> is_taken(rows * places.names.size());
    std::size_t repeated = 0;
    for (std::size_t k = 0; k < places.rows.size(); ++k) {
      const std::size_t cell = places.rows[k] * places.names.size() + places.columns[k];
      if (is_taken[cell]) {
        ++repeated;
        continue;
      }
      is_taken[cell] = true;
      spread[first + places.columns[k]].values[places.rows[k]] = found.arrays[of->value].values[k];
    }
    notes.push_back({"reading.long_format",
                     {{"readings", places.rows.size()}, {"signals", list_of_names(places.names)}}});
    if (repeated > 0) notes.push_back({"reading.repeated_readings", {{"readings", repeated}}});
    for (const std::size_t other : of->others) {
      found.leave_out(found.arrays[other].name, "it is said of single readings");
    }
    std::set<std::size_t> used(of->times.begin(), of->times.end());
    used.insert(of->others.begin(), of->others.end());
    used.insert({of->signal, of->value});
    if (of->joint) used.insert(*of->joint);
    if (of->unit) used.insert(*of->unit);
    for (auto k = used.rbegin(); k != used.rend(); ++k) {
      found.arrays.erase(found.arrays.begin() + static_cast<std::ptrdiff_t>(*k));
    }
    for (NamedArray& array : spread) found.arrays.push_back(std::move(array));
  }
  return notes;
}

}  // namespace tribolog::ingest::arrays
