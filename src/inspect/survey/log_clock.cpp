#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/input_file.h"
#include "base/requirements.h"
#include "ingest/dataset/companion_columns.h"
#include "ingest/log/row_clock.h"
#include "ingest/text/csv_reader.h"
#include "inspect/survey/column_guess.h"
#include "inspect/survey/survey_parts.h"

namespace tribolog::inspect::survey {
namespace {

/// So that no nanosecond is lost of one that counts from 1970.
void read_clock_again(const std::string& path, const ingest::text::TextLogRules& rules,
                      std::size_t column, const std::string& key, ingest::log::LogTable& table) {
  const std::vector<double>& values = table.columns[column].values;
  const bool is_long = std::any_of(values.begin(), values.end(), [](double t) {
    return std::abs(t) >= ingest::log::counts_from_1970;
  });
  if (!is_long) return;
  InputFileSource bytes(path);
  ingest::text::CsvTable again =
      ingest::text::read_csv(bytes, path, {{key, "", ingest::log::ColumnReading::clock}}, rules);
  table.columns[column].values = std::move(again.columns.front().values);
  table.columns[column].origin = again.columns.front().origin;
}

/// What stands in front of "sec" in "header.stamp.sec"; nothing for a name that does not end so.
std::optional<std::string> before_ending(const std::string& name,
                                         const std::vector<std::string_view>& endings) {
  for (const std::string_view ending : endings) {
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  }
  return std::nullopt;
}

/// Columns that make one clock.
struct ClockPair {
  std::size_t first{};
  std::size_t second{};
  bool is_dated{};  ///< A time of day and its date; else seconds and nanoseconds.
  bool is_there{};
  [[nodiscard]] const char* unit_of_second() const { return is_dated ? "yyyy-mm-dd" : "ns"; }
  [[nodiscard]] double seconds_of_second() const { return is_dated ? 1 : 1e-9; }
};

/// Seconds and nanoseconds by their names, or a time of day and its date. None where another
/// column is the clock, or one that the user states.
ClockPair clock_in_two(const StatedColumns& stated, const ingest::log::LogTable& data,
                       const TableSurvey& table) {
  using ingest::log::ColumnReading;
  if (states(stated, "time") || stated.rate_Hz) return {};
  const auto& columns = data.columns;
  constexpr double nanoseconds = 1e9;
  for (std::size_t a = 0; a < columns.size(); ++a) {
    const auto before = before_ending(columns[a].header.name, {"secs", "sec"});
    for (std::size_t b = 0; b < columns.size() && before; ++b) {
      const auto same = before_ending(columns[b].header.name, {"nanosec", "nsecs", "nsec"});
      const bool is_free = !table.time || table.time == a || table.time == b ||
                           !table.columns[*table.time].guessed_by.empty();
      const bool are_nanoseconds =
          table.columns[b].lowest >= 0 && table.columns[b].highest < nanoseconds;
      if (a != b && same == before && is_free && are_nanoseconds) return {a, b, false, true};
    }
  }
  if (!table.time || columns[*table.time].reading != ColumnReading::time_of_day) return {};
  const auto date = std::find_if(columns.begin(), columns.end(), [](const auto& column) {
    return column.reading == ColumnReading::date;
  });
  if (date == columns.end()) return {};
  return {*table.time, static_cast<std::size_t>(date - columns.begin()), true, true};
}

/// The clock of a log that has one.
void survey_own_clock(const HowRead& how, ingest::log::LogTable& data, TableSurvey& table) {
  using ingest::log::ColumnReading;
  const ClockPair pair = clock_in_two(how.stated, data, table);
  if (pair.is_there) {
    if (table.time) table.columns[*table.time].meaning.reset();
    table.time = pair.first;
    if (!table.columns[pair.first].meaning) table.columns[pair.first].meaning.emplace();
    ingest::layout::ColumnMeaning& meaning = present(table.columns[pair.first].meaning);
    meaning.column = pair.first;
    meaning.quantity = ingest::log::Quantity::time;
    if (!pair.is_dated) meaning.unit = "s";
    meaning.unit_is_stated = true;
    table.columns[pair.first].guessed_by.clear();
    table.columns[pair.second].guessed_by.clear();
    table.columns[pair.second].meaning = meaning;
    table.columns[pair.second].meaning->column = pair.second;
    table.columns[pair.second].meaning->unit = pair.unit_of_second();
  }
  if (!table.time) return;
  ingest::log::LogColumn& column = data.columns[*table.time];
  ColumnSurvey& of_time = table.columns[*table.time];
  if (pair.is_there) {
    ingest::log::add_to_clock(data.columns[pair.second], pair.seconds_of_second(), column);
  } else if (column.reading == ColumnReading::time_of_day) {
    const std::size_t midnights = ingest::log::go_on_past_midnight(column);
    if (midnights > 0) data.notes.push_back({"reading.past_midnight", {{"midnights", midnights}}});
  } else if (how.format != ingest::log::LogFormat::text || data.other_rows > 0) {
    ingest::log::count_from_first(column);
  } else if (column.reading == ColumnReading::number && !how.stated.rate_Hz) {
    read_clock_again(how.path, how.rules, *table.time, of_time.key, data);
  }
  const std::size_t back = ingest::log::go_on_past_set_back(column);
  if (back > 0) data.notes.push_back({"reading.clock_set_back", {{"times", back}}});
  ingest::layout::ColumnMeaning& meaning = present(of_time.meaning);
  table.clock = survey_clock(column, meaning);
  table.clock->column = of_time.name;
  table.clock->key = of_time.key;
  meaning.unit = table.clock->unit;
  if (!pair.is_there) return;
  const ColumnSurvey& second = table.columns[pair.second];
  table.clock->plus = ClockPartSurvey{second.name, second.key, pair.unit_of_second()};
}

/// A column that counts the samples of a log whose rows come at a stated rate.
struct Counter {
  std::size_t column{};
  double step{};     ///< From one sample to the next.
  bool is_usable{};  ///< It rises all the way, by whole steps.
};

/// The first column named so that does, and shows that samples are lost.
std::optional<Counter> lossy_counter_in(const ingest::log::LogTable& data,
                                        const TableSurvey& table) {
  constexpr std::array counters = {"sample", "samples", "counter", "count", "index", "idx",
                                   "cycle",  "cycles",  "seq",     "tick",  "ticks", "frame",
                                   "row",    "n",       "takt",    "krok"};
  constexpr double steady_share = 0.8;
  for (std::size_t k = 0; k < data.columns.size(); ++k) {
    const std::vector<std::string> words =
        ingest::layout::words_of_name(data.columns[k].header.name);
    const bool is_named = std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return std::find(counters.begin(), counters.end(), word) != counters.end();
    });
    const std::vector<double>& values = data.columns[k].values;
    const double step = ingest::log::median_clock_step(values);
    if (!is_named || table.columns[k].gaps > 0 || !(step >= 1)) continue;
    std::size_t steady = 0;
    bool rises = true;
    for (std::size_t i = 1; i < values.size(); ++i) {
      const double d = values[i] - values[i - 1];
      steady += d == step ? 1 : 0;
      rises = rises && d > 0 && d == step * std::round(d / step);
    }
    const bool is_steady =
        static_cast<double>(steady) > steady_share * static_cast<double>(values.size() - 1);
    if (is_steady && steady + 1 < values.size()) return Counter{k, step, rises};
  }
  return std::nullopt;
}

/// Stamps that stand where the one before stood, of all.
double share_of_repeats(const std::vector<double>& stamps) {
  std::size_t repeated = 0;
  for (std::size_t row = 1; row < stamps.size(); ++row) {
    repeated += stamps[row] == stamps[row - 1] ? 1 : 0;
  }
  return static_cast<double>(repeated) /
         static_cast<double>(std::max<std::size_t>(1, stamps.size()));
}

/// The first time; or, where it is too coarse to tell rows apart, the first that is not.
std::optional<std::size_t> time_in(const ingest::log::LogTable& data, const TableSurvey& table) {
  constexpr double most_repeats = 0.05;
  std::optional<std::size_t> first;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const auto& meaning = table.columns[k].meaning;
    const bool is_time = meaning && meaning->quantity == ingest::log::Quantity::time;
    if (!is_time || meaning->is_target) continue;
    if (!first) first = k;
    if (share_of_repeats(data.columns[k].values) <= most_repeats) return k;
  }
  return first;
}

}  // namespace

void find_clock(const HowRead& how, ingest::log::LogTable& data, TableSurvey& table) {
  table.time = time_in(data, table);
  survey_own_clock(how, data, table);
  for (std::size_t k = 0; k < data.columns.size() && !table.clock; ++k) {
    const bool counts = data.columns[k].reading == ingest::log::ColumnReading::number &&
                        looks_like_counter(data.columns[k].values);
    if (counts && table.counter.empty()) table.counter = table.columns[k].name;
  }
  if (!how.stated.rate_Hz || !table.clock) return;
  const auto counter = lossy_counter_in(data, table);
  if (!counter) return;
  const ColumnSurvey& named_by = table.columns[counter->column];
  if (!counter->is_usable) {
    table.counter = named_by.name;
    return;
  }
  // The made clock is the last column.
  ingest::log::LogColumn counted = data.columns[counter->column];
  ingest::log::count_from_first(counted);
  const double unit_s = 1 / (*how.stated.rate_Hz * counter->step);
  std::transform(counted.values.begin(), counted.values.end(),
                 data.columns[*table.time].values.begin(),
                 [&](double value) { return value * unit_s; });
  table.clock =
      survey_clock(data.columns[*table.time], present(table.columns[*table.time].meaning));
  table.clock->column = named_by.name;
  table.clock->key = named_by.key;
  table.clock->is_counter = true;
  table.clock->seconds_per_count = unit_s;
}

}  // namespace tribolog::inspect::survey
