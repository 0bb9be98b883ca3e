#include "inspect/survey/log_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/input_file.h"
#include "base/requirements.h"
#include "ingest/dataset/held_rows.h"
#include "ingest/dataset/log_reader.h"
#include "ingest/dataset/long_text_log.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/log/row_clock.h"
#include "ingest/log/units.h"
#include "ingest/text/csv_reader.h"
#include "inspect/survey/column_guess.h"
#include "inspect/survey/survey_parts.h"
#include "joint/wrapped_angle.h"
#include "method/motion/encoder_resolution.h"

namespace tribolog::inspect::survey {
namespace {

constexpr std::size_t most_distinct = 1000;
constexpr std::size_t most_columns_by_numbers = 64;  // pairs of them are compared

std::vector<double> numbers_of(const ingest::log::LogColumn& column) {
  std::vector<double> numbers;
  for (const double value : column.values) {
    if (std::isfinite(value)) numbers.push_back(value);
  }
  return numbers;
}

}  // namespace

ColumnSurvey survey_column(const ingest::log::LogColumn& column,
                           const std::vector<std::string>& names) {
  ColumnSurvey survey;
  survey.name = column.header.full;
  survey.key = survey.name;
  const auto alike = std::count(names.begin(), names.end(), survey.name);
  if (column.header.place > 0 && (survey.name.empty() || alike > 1)) {
    survey.key = "#" + std::to_string(column.header.place);
  }
  if (survey.name.empty()) survey.name = survey.key;
  survey.unit = column.header.unit;
  survey.words = column.words;
  const std::vector<double> numbers = numbers_of(column);
  survey.gaps = column.values.size() - numbers.size();
  survey.lowest = NAN;
  survey.highest = NAN;
  if (numbers.empty()) return survey;
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  survey.lowest = *low;
  survey.highest = *high;
  survey.step = method::motion::common_step(numbers);
  std::set<double> distinct;
  for (auto it = numbers.begin(); it != numbers.end() && distinct.size() < most_distinct; ++it) {
    distinct.insert(*it);
  }
  survey.distinct = distinct.size();
  return survey;
}

namespace {

/// Text logs are read in one pass for all columns; a clock that counts from 1970 in a second one.
std::vector<ingest::log::LogTable> tables_of(const std::string& path, ingest::log::LogFormat format,
                                             const ingest::text::TextLogRules& rules) {
  if (format != ingest::log::LogFormat::text) return ingest::dataset::read_tables(path, format);
  const auto first_rows = ingest::dataset::first_rows_of_text(path, rules);
  if (auto tables = ingest::dataset::read_long_text(path, first_rows, {}, rules)) {
    return std::move(*tables);
  }
  InputFileSource bytes(path);
  return {ingest::text::read_csv(bytes, path, {}, rules)};
}

/// With decimal commas where the log shows them.
ingest::text::TextLogRules with_decimal_mark(const std::string& path, ingest::log::LogFormat format,
                                             const ingest::text::TextLogRules& stated) {
  ingest::text::TextLogRules rules = stated;
  if (format != ingest::log::LogFormat::text) return rules;
  InputFileSource bytes(path);
  if (ingest::text::shows_decimal_commas(bytes, path, stated)) {
    rules.decimal_mark = ingest::text::DecimalMark::comma;
  }
  return rules;
}

/// The first measured one at the joint, or else at the motor: that needs a gear ratio to be one of
/// the joint.
std::optional<std::size_t> angle_of(const TableSurvey& table, const std::string& joint) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const auto& meaning = table.columns[k].meaning;
    if (!meaning || meaning->quantity != ingest::log::Quantity::angle || meaning->is_target) {
      continue;
    }
    const bool is_there = !std::isnan(table.columns[k].lowest);
    if (meaning->joint == joint && !table.columns[k].is_at_motor && is_there) return k;
  }
  return first_column(table, ingest::log::Quantity::angle, joint, false);
}

/// The joint's own; or one that names no joint, if there is but one joint.
std::optional<std::size_t> of_joint(const TableSurvey& table, ingest::log::Quantity quantity,
                                    const std::string& joint, bool is_only) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const auto& meaning = table.columns[k].meaning;
    if (meaning && meaning->is_of_any_joint && meaning->quantity == quantity) return k;
  }
  const auto own = first_column(table, quantity, joint, false);
  return own || !is_only ? own : first_column(table, quantity, "", false);
}

/// From an angle as it is logged to the joint's, in rad.
double joint_angle_factor(const ColumnSurvey& angle) {
  return present(ingest::log::find_si_factor(ingest::log::Quantity::angle,
                                             present(angle.meaning).unit)) /
         angle.gear_ratio;
}

/// Time and angle in SI, in the order of time, gaps and repeated stamps left out.
motion::AngleTrace trace_of(const ingest::log::LogTable& data, const TableSurvey& table,
                            const JointSurvey& joint) {
  const std::vector<double>& t = data.columns[present(table.time)].values;
  const std::vector<double>& q = data.columns[joint.angle].values;
  const std::vector<double>* effort = joint.effort ? &data.columns[*joint.effort].values : nullptr;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (std::isfinite(t[i]) && std::isfinite(q[i]) && (!effort || std::isfinite((*effort)[i]))) {
      rows.push_back(i);
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [&](std::size_t a, std::size_t b) { return t[a] < t[b]; });
  std::vector<const std::vector<double>*> signals{&q};
  if (effort) signals.push_back(effort);
  if (auto held = ingest::dataset::find_held_rows(rows, signals)) rows = std::move(held->kept);
  const double angle_factor = joint_angle_factor(table.columns[joint.angle]);
  motion::AngleTrace trace;
  for (const std::size_t i : rows) {
    const double time_s = t[i] * present(table.clock).seconds_per_unit;
    if (!trace.t_s.empty() && time_s <= trace.t_s.back()) continue;
    trace.t_s.push_back(time_s);
    trace.q_rad.push_back(q[i] * angle_factor);
    if (effort) trace.effort.push_back((*effort)[i]);
  }
  const double turn = 2 * std::numbers::pi / table.columns[joint.angle].gear_ratio;
  const auto wraps = joint::find_wraps(trace.t_s, trace.q_rad, {turn});
  if (wraps) trace.q_rad = joint::unwrapped(std::move(trace.q_rad), *wraps);
  return trace;
}

/// The trace's samples from one moment to another.
motion::AngleTrace part_of(const motion::AngleTrace& trace, std::size_t first, std::size_t end) {
  const auto part = [&](const std::vector<double>& values) {
    if (values.empty()) return values;
    return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(first),
                               values.begin() + static_cast<std::ptrdiff_t>(end));
  };
  return {part(trace.t_s), part(trace.q_rad), part(trace.effort)};
}

/// Whether a phase ends while the joint is under way: then it is no phase of the motion.
bool cut_a_stroke(const motion::AngleTrace& trace,
                  const std::vector<motion::MotionSegment>& segments,
                  const std::vector<Phase>& phases) {
  constexpr std::size_t half = 5;  // samples, or steps of the encoder drown the slope
  constexpr double slow = 0.3;     // of the segment's speed
  for (std::size_t k = 0; k + 1 < phases.size(); ++k) {
    const auto end = std::upper_bound(trace.t_s.begin(), trace.t_s.end(), phases[k].to_s);
    const auto at = static_cast<std::size_t>(end - trace.t_s.begin());
    if (at < half || at + half >= trace.size()) continue;
    const double speed = std::abs(trace.q_rad[at + half] - trace.q_rad[at - half]) /
                         (trace.t_s[at + half] - trace.t_s[at - half]);
    for (const motion::MotionSegment& s : segments) {
      const bool is_in = s.first + half < at && at + half < s.last;
      if (is_in && s.kind != motion::MotionKind::rest && speed > slow * s.speed_rad_s) return true;
    }
  }
  return false;
}

/// By the phases that the log names, where it names some, and within them by motion.
std::vector<motion::MotionSegment> cut_by_phases(const motion::AngleTrace& trace,
                                                 const std::vector<Phase>& phases) {
  std::vector<motion::MotionSegment> segments = motion::cut_by_motion(trace);
  if (phases.empty() || cut_a_stroke(trace, segments, phases)) return segments;
  segments.clear();
  for (const Phase& phase : phases) {
    const auto from = std::lower_bound(trace.t_s.begin(), trace.t_s.end(), phase.from_s);
    const auto to = std::upper_bound(from, trace.t_s.end(), phase.to_s);
    if (from == to) continue;
    const auto first = static_cast<std::size_t>(from - trace.t_s.begin());
    const auto end = static_cast<std::size_t>(to - trace.t_s.begin());
    for (motion::MotionSegment& s : motion::cut_by_motion(part_of(trace, first, end))) {
      s.first += first;
      s.last += first;
      s.phase = phase.name;
      segments.push_back(std::move(s));
    }
  }
  return segments;
}

/// A torque before a current, but where a current is looked for.
std::optional<std::size_t> effort_of(const TableSurvey& table, const std::string& joint,
                                     bool is_only, bool wants_current) {
  using enum ingest::log::Quantity;
  const auto of = [&](ingest::log::Quantity quantity) {
    const auto column = of_joint(table, quantity, joint, is_only);
    const bool is_empty = column && std::isnan(table.columns[*column].lowest);
    return is_empty && wants_current ? std::nullopt : column;
  };
  const auto first = of(wants_current ? current : torque);
  return first ? first : of(wants_current ? torque : current);
}

void add_joints(const ingest::log::LogTable& data, bool wants_current, TableSurvey& table) {
  const std::vector<Phase> phases = phases_in(data, table);
  std::vector<std::string> names;
  for (const ColumnSurvey& c : table.columns) {
    if (!c.meaning || c.meaning->quantity != ingest::log::Quantity::angle || c.meaning->is_target)
      continue;
    if (std::find(names.begin(), names.end(), c.meaning->joint) == names.end()) {
      names.push_back(c.meaning->joint);
    }
  }
  for (const std::string& name : names) {
    const bool is_only = names.size() == 1;
    JointSurvey joint;
    joint.name = name;
    joint.angle = present(angle_of(table, name));
    if (std::isnan(table.columns[joint.angle].lowest)) continue;
    joint.speed = of_joint(table, ingest::log::Quantity::angular_speed, name, is_only);
    joint.effort = effort_of(table, name, is_only, wants_current);
    joint.temperature = of_joint(table, ingest::log::Quantity::temperature, name, is_only);
    for (const ingest::log::Quantity quantity :
         {ingest::log::Quantity::torque, ingest::log::Quantity::current}) {
      const auto target = first_column(table, quantity, name, true);
      if (target) joint.targets.push_back(*target);
    }
    if (joint.effort && std::isnan(table.columns[*joint.effort].lowest)) joint.effort.reset();
    const double factor = joint_angle_factor(table.columns[joint.angle]);
    joint.lowest_rad = factor * table.columns[joint.angle].lowest;
    joint.highest_rad = factor * table.columns[joint.angle].highest;
    if (table.clock && table.clock->interval_s > 0) {
      const motion::AngleTrace trace = trace_of(data, table, joint);
      joint.samples = trace.size();
      joint.segments = cut_by_phases(trace, phases);
    }
    table.joints.push_back(std::move(joint));
  }
}

/// Speeds and efforts whose registers were logged without their sign become signed.
/// @return by their columns.
std::map<std::size_t, ingest::log::Register> read_registers(const ingest::layout::LogLayout& layout,
                                                            ingest::log::LogTable& data) {
  using enum ingest::log::Quantity;
  std::vector<std::size_t> columns;
  for (const ingest::layout::ColumnMeaning& meaning : layout.columns) {
    const bool may_be = meaning.quantity == angular_speed || meaning.quantity == torque ||
                        meaning.quantity == current;
    if (may_be) columns.push_back(meaning.column);
  }
  for (const ingest::layout::ForeignUnit& foreign : layout.foreign)
    columns.push_back(foreign.column);
  std::map<std::size_t, ingest::log::Register> found;
  for (const std::size_t k : columns) {
    ingest::log::LogColumn& column = data.columns[k];
    const auto of = ingest::log::find_register(column.values);
    if (!of) continue;
    for (double& value : column.values) value = of->value_of(value);
    found.emplace(k, *of);
    data.notes.push_back(
        {"reading.register_without_sign",
         {{"column", in_quotes(column.header.full)}, {"register", ingest::log::to_string(*of)}}});
  }
  return found;
}

/// Makes gaps of single numbers that no joint has; where they are many, the unit is another.
/// @return whether there were some.
bool blank_impossible_values(const ingest::layout::LogLayout& layout, ingest::log::LogTable& data) {
  bool found = false;
  for (const ingest::layout::ColumnMeaning& meaning : layout.columns) {
    const auto factor = ingest::log::find_si_factor(meaning.quantity, meaning.unit);
    const double bound = ingest::dataset::largest_possible(meaning.quantity) / factor.value_or(1);
    ingest::log::LogColumn& column = data.columns[meaning.column];
    const std::vector<std::size_t> rows = ingest::dataset::rows_beyond(column.values, bound);
    const double most = ingest::text::most_bad_rows * static_cast<double>(column.values.size());
    if (rows.empty() || static_cast<double>(rows.size()) > most) continue;
    found = true;
    data.notes.push_back({"reading.impossible_values",
                          {{"column", in_quotes(column.header.full)},
                           {"count", rows.size()},
                           {"value", column.values[rows.front()]}}});
    for (const std::size_t row : rows) column.values[row] = NAN;
  }
  return found;
}

/// Of columns whose meaning is stated, but not their joint; those in the same group are the other
/// joints'.
void name_joints_by_place(const ColumnGroups& groups, std::vector<ColumnSurvey>& columns) {
  for (std::size_t k = groups.first; k < columns.size(); ++k) {
    auto& meaning = columns[k].meaning;
    if (!meaning || !meaning->joint.empty()) continue;
    if (meaning->quantity == ingest::log::Quantity::time) continue;
    meaning->joint = groups.joint_of(k);
    const std::size_t begin = k - (k - groups.first) % groups.joints;
    for (std::size_t other = begin; other < begin + groups.joints; ++other) {
      if (other >= columns.size() || columns[other].meaning) continue;
      columns[other].meaning = meaning;
      columns[other].meaning->column = other;
      columns[other].meaning->joint = groups.joint_of(other);
      columns[other].guessed_by = "by its place, as " + in_quotes(columns[k].name);
    }
  }
}

/// Where an effort is said to be there and no name says so, in columns that come in groups.
void put_effort_by_place(const StatedColumns& stated, const ingest::log::LogTable& data,
                         TableSurvey& table) {
  using enum ingest::log::Quantity;
  const auto is_effort = [](const ColumnSurvey& column) {
    return column.meaning &&
           (column.meaning->quantity == torque || column.meaning->quantity == current);
  };
  if (!stated.effort_is || !table.groups || !table.time) return;
  if (std::any_of(table.columns.begin(), table.columns.end(), is_effort)) return;
  const ColumnGroups& groups = *table.groups;
  const auto begin = first_effort_by_place(data, *table.time, groups);
  if (!begin) return;
  for (std::size_t k = *begin; k < *begin + groups.joints; ++k) {
    if (table.columns[k].meaning) continue;
    ingest::layout::ColumnMeaning meaning;
    meaning.column = k;
    meaning.quantity = *stated.effort_is;
    meaning.unit = stated.effort_unit.value_or(meaning.quantity == current ? "A" : "Nm");
    meaning.unit_is_stated = stated.effort_unit.has_value();
    meaning.joint = groups.joint_of(k);
    table.columns[k].meaning = std::move(meaning);
    table.columns[k].is_guess = true;
    table.columns[k].guessed_by = "by its place behind angles and speeds";
  }
}

/// Times are known by how they are written, whatever their names; words are no numbers.
void tell_by_reading(const ingest::log::LogTable& data, ingest::layout::LogLayout& layout) {
  using ingest::log::ColumnReading;
  std::erase_if(layout.columns, [&](const ingest::layout::ColumnMeaning& meaning) {
    return data.columns[meaning.column].reading != ColumnReading::number;
  });
  for (std::size_t k = 0; k < data.columns.size(); ++k) {
    const ColumnReading reading = data.columns[k].reading;
    if (reading != ColumnReading::iso_time && reading != ColumnReading::time_of_day) continue;
    ingest::layout::ColumnMeaning meaning;
    meaning.column = k;
    meaning.quantity = ingest::log::Quantity::time;
    meaning.unit = ingest::log::unit_of_time(reading);
    meaning.unit_is_stated = true;
    layout.columns.push_back(std::move(meaning));
  }
}

/// @throw InputError for a column of words that is stated as one of numbers.
void refuse_words(const StatedColumns& stated, const ingest::log::LogTable& data,
                  const ingest::layout::LogLayout& layout) {
  if (stated.names.empty()) return;
  for (const ingest::layout::ColumnMeaning& meaning : layout.columns) {
    const ingest::log::LogColumn& column = data.columns[meaning.column];
    if (column.reading != ingest::log::ColumnReading::words) continue;
    throw InputError({data.file, 0, 0},
                     {"column " + in_quotes(column.header.full) + " holds words",
                      list_of_names(column.words, 3), "numbers", "--column names another?"});
  }
}

/// With the gear ratio where an angle or a speed is the motor's: how many times larger it is than
/// the joint's.
void look_at_sides(const StatedColumns& stated, TableSurvey& table) {
  const auto says = [](const std::string& name, std::string_view word) {
    return std::search(name.begin(), name.end(), word.begin(), word.end(),
                       [](char a, char b) { return (a | 0x20) == b; }) != name.end();
  };
  for (ColumnSurvey& column : table.columns) {
    const bool turns =
        column.meaning && (column.meaning->quantity == ingest::log::Quantity::angle ||
                           column.meaning->quantity == ingest::log::Quantity::angular_speed);
    if (!turns) continue;
    column.side_is_stated =
        stated.angle_side.has_value() || says(column.name, "joint") || says(column.name, "link");
    column.is_at_motor = stated.angle_side
                             ? *stated.angle_side == joint::Side::motor
                             : says(column.name, "motor") || says(column.name, "rotor") ||
                                   column.meaning->is_at_motor;
    const double gear_ratio = stated.gear_ratio_for(column.meaning->joint).value_or(1);
    column.has_gear = gear_ratio != 1;
    if (column.is_at_motor) column.gear_ratio = gear_ratio;
  }
}

/// What the files of a set are by their names, in the place of what their columns' names say.
void put_meanings_of_files(const JoinedFiles& joined, ingest::layout::LogLayout& layout) {
  layout.columns = joined.meanings;
  layout.foreign.clear();
}

/// With a stated angle a log's other angles do not count; those of a set's files are other joints'.
void put_other_angles(const JoinedFiles& joined, const StatedColumns& stated,
                      ingest::layout::LogLayout& layout) {
  for (const ingest::layout::ColumnMeaning& meaning : joined.meanings) {
    const bool is_there =
        std::any_of(layout.columns.begin(), layout.columns.end(),
                    [&](const ingest::layout::ColumnMeaning& known) {
                      return known.column == meaning.column ||
                             (known.quantity == meaning.quantity && known.joint == meaning.joint);
                    });
    if (meaning.quantity != ingest::log::Quantity::angle || is_there) continue;
    layout.columns.push_back(meaning);
    if (!stated.angle_unit) continue;
    layout.columns.back().unit = *stated.angle_unit;
    layout.columns.back().unit_is_stated = true;
  }
}

/// Where the columns of a set's files stand, and which were named by the files.
void place_in_files(const JoinedFiles& joined, const ingest::log::LogTable& data,
                    const StatedColumns& stated, TableSurvey& table) {
  for (std::size_t k = 0; k < joined.files.size(); ++k) {
    if (joined.files[k].file.empty()) continue;
    table.columns[k].file = joined.files[k].file;
    table.columns[k].key = joined.files[k].key;
  }
  for (const ingest::layout::ColumnMeaning& meaning : joined.meanings) {
    const std::string& name = data.columns[meaning.column].header.full;
    const bool is_stated = std::any_of(stated.names.begin(), stated.names.end(),
                                       [&](const auto& one) { return one.second == name; });
    if (is_stated) continue;
    table.columns[meaning.column].guessed_by = "by the name of its file";
    table.columns[meaning.column].is_guess = true;
  }
}

/// @param joined where the table is that of several files; else null.
/// @param missing receives the stated columns that the table has not.
TableSurvey survey_table(const HowRead& how, const JoinedFiles* joined, ingest::log::LogTable& data,
                         std::vector<std::string>& missing) {
  const StatedColumns& stated = how.stated;
  TableSurvey table;
  table.group = data.group;
  table.rows = data.rows;
  if (stated.rate_Hz) data.columns.push_back(ingest::log::row_clock(*stated.rate_Hz, data.rows));
  std::vector<ingest::log::ColumnHeader> header;
  for (const ingest::log::LogColumn& column : data.columns) header.push_back(column.header);
  ingest::layout::LogLayout layout = ingest::layout::guess_layout(header);
  if (joined != nullptr) put_meanings_of_files(*joined, layout);
  tell_by_reading(data, layout);
  missing = put_stated(stated, header, layout);
  if (joined != nullptr) put_other_angles(*joined, stated, layout);
  refuse_words(stated, data, layout);
  table.logger = layout.logger;
  table.foreign = layout.foreign;
  const std::map<std::size_t, ingest::log::Register> registers = read_registers(layout, data);
  table.has_impossible_values = blank_impossible_values(layout, data);
  for (const ingest::log::LogColumn& column : data.columns)
    table.columns.push_back(survey_column(column, data.header));
  for (const auto& [column, of] : registers) table.columns[column].of_register = of;
  for (const ingest::layout::ColumnMeaning& meaning : layout.columns) {
    table.columns[meaning.column].meaning = meaning;
    if (meaning.unit_is_usual) {
      table.columns[meaning.column].unit_by = "usual of " + layout.logger + ", not certain";
    } else if (meaning.unit_is_ambiguous) {
      table.columns[meaning.column].unit_by = "German for degrees, elsewhere a 400th of a turn";
    }
  }
  if (joined != nullptr) place_in_files(*joined, data, stated, table);
  if (data.columns.size() <= most_columns_by_numbers) {
    GuessedLayout guessed = guess_by_numbers(data, layout);
    for (GuessedMeaning& guess : guessed.meanings) {
      table.columns[guess.meaning.column].guessed_by = guess.reason;
      table.columns[guess.meaning.column].meaning = std::move(guess.meaning);
    }
    table.groups = guessed.groups;
    if (table.groups) name_joints_by_place(*table.groups, table.columns);
  }
  look_at_sides(stated, table);
  find_clock(how, data, table);
  put_effort_by_place(stated, data, table);
  find_units(data, table);
  add_joints(data, stated.effort_is == ingest::log::Quantity::current, table);
  return table;
}

/// A table with all rows, or with one joint's or recording's.
struct TableOfOne {
  ingest::log::LogTable table;
  std::optional<std::pair<std::string, std::string>> rows_of;  ///< As TableSurvey has it.
  bool is_recording{};
};

/// Its joints go by what stands in the column that tells the rows.
void name_joint(const std::pair<std::string, std::string>& rows_of, TableSurvey& table) {
  if (table.joints.size() != 1) return;
  table.joints.front().name = rows_of.second;
  for (ColumnSurvey& column : table.columns) {
    const bool is_its = column.meaning && column.meaning->quantity != ingest::log::Quantity::time;
    if (is_its) column.meaning->joint = rows_of.second;
  }
}

}  // namespace

LogSurvey survey_log(const std::string& path, const ingest::text::TextLogRules& stated_rules,
                     const StatedColumns& stated) {
  LogSurvey survey;
  survey.file = path;
  survey.format = ingest::dataset::format_of_log(path);
  const ingest::text::TextLogRules rules = with_decimal_mark(path, survey.format, stated_rules);
  survey.has_decimal_commas = rules.decimal_mark == ingest::text::DecimalMark::comma;
  std::vector<ingest::log::LogTable> tables = tables_of(path, survey.format, rules);
  std::vector<TableOfOne> of_each;
  for (ingest::log::LogTable& table : tables) {
    std::vector<RowsOfOne> rows = rows_of_each(path, survey.format, rules, table);
    if (rows.empty()) of_each.push_back({std::move(table), std::nullopt});
    for (RowsOfOne& one : rows) {
      of_each.push_back({std::move(one.table), std::pair{one.key, one.value}, one.is_recording});
    }
  }
  std::vector<std::string> missing;  // in every table
  std::vector<std::string> there;
  for (auto& [table, rows_of, is_recording] : of_each) {
    std::vector<std::string> missing_here;
    StatedColumns of_table = stated;
    if (rows_of && !is_recording) of_table.gear_ratio = stated.gear_ratio_for(rows_of->second);
    survey.tables.push_back(
        survey_table({path, survey.format, rules, of_table}, nullptr, table, missing_here));
    if (rows_of && !is_recording) name_joint(*rows_of, survey.tables.back());
    survey.tables.back().rows_of = rows_of;
    survey.tables.back().is_one_of_several = is_recording;
    survey.notes.insert(survey.notes.end(), table.notes.begin(), table.notes.end());
    for (const ColumnSurvey& column : survey.tables.back().columns) there.push_back(column.name);
    if (survey.tables.size() == 1) missing = missing_here;
    std::erase_if(missing, [&](const std::string& name) {
      return std::find(missing_here.begin(), missing_here.end(), name) == missing_here.end();
    });
    table.columns.clear();
  }
  if (!missing.empty()) {
    throw InputError({path, 0, 0}, {"has no column " + in_quotes(missing.front()),
                                    list_of_names(there), "the name that --column states", ""});
  }
  return survey;
}

std::optional<LogSurvey> survey_set(const FileSet& set,
                                    const ingest::text::TextLogRules& stated_rules,
                                    const StatedColumns& stated) try {
  LogSurvey survey;
  survey.file = set.path;
  survey.format = ingest::dataset::format_of_log(set.path);
  const ingest::text::TextLogRules rules = with_decimal_mark(set.path, survey.format, stated_rules);
  survey.has_decimal_commas = rules.decimal_mark == ingest::text::DecimalMark::comma;
  const auto only_table = [&](const std::string& path) {
    const ingest::log::LogFormat format = ingest::dataset::format_of_log(path);
    if (format != ingest::log::LogFormat::text) return std::optional<ingest::log::LogTable>();
    std::vector<ingest::log::LogTable> tables = tables_of(path, format, rules);
    return tables.size() == 1 ? std::optional(std::move(tables.front())) : std::nullopt;
  };
  auto angles = only_table(set.path);
  std::vector<ingest::log::LogTable> beside;
  for (const FileOfQuantity& one : set.beside) {
    auto table = angles ? only_table(one.path) : std::nullopt;
    if (!table) return std::nullopt;
    beside.push_back(std::move(*table));
  }
  if (beside.empty()) return std::nullopt;
  auto joined = join_files(set, std::move(*angles), std::move(beside), stated);
  if (!joined) return std::nullopt;
  std::vector<std::string> missing;
  survey.tables.push_back(
      survey_table({set.path, survey.format, rules, stated}, &*joined, joined->table, missing));
  survey.notes = std::move(joined->table.notes);
  return missing.empty() ? std::optional(std::move(survey)) : std::nullopt;
} catch (const InputError&) {
  return std::nullopt;
}

}  // namespace tribolog::inspect::survey
