#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/requirements.h"
#include "ingest/dataset/held_rows.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/log/row_clock.h"
#include "wording/words.h"

namespace tribolog::ingest::dataset {
namespace {

constexpr Code outside_window{"skipped.outside_window"};
constexpr Code cut_off{"skipped.cut_off"};
constexpr Code not_usable{"skipped.not_usable"};
constexpr Code other_joint{"skipped.other_joint"};
constexpr Code other_recording{"skipped.other_recording"};
constexpr Code unclear{"skipped.unclear_joint_state"};
constexpr std::size_t fewest_rows = 20;
/// Beyond: two logs, unless the rows fit in between each other.
constexpr double largest_step_back_s = 1.0;
constexpr double most_repeated_stamps = 0.05;  ///< Share of the rows.

class RowChooser {
 public:
  RowChooser(const manifest::RecordingEntry& entry, const log::LogTable& table,
             RecordingNotes& notes)
      : entry_(entry),
        table_(table),
        notes_(notes),
        to_seconds_(present(entry.columns.time).si_factor) {}

  RowChoice choose() {
    refuse_long_steps_back();
    skip(cut_off, table_.cut_rows);
    skip(not_usable, table_.bad_rows);
    skip(unclear, table_.unclear_rows);
    skip(other_joint, table_.other_rows);
    skip(other_recording, table_.rows_of_others);
    drop_outside_and_gaps();
    if (steps_back_ > 0) put_in_order();
    drop_repeated_stamps();
    drop_held_rows();
    if (rows_.size() < fewest_rows) refuse_too_few();
    return {std::move(rows_), std::move(skipped_)};
  }

 private:
  [[nodiscard]] double time_s(std::size_t row) const {
    return table_.columns.front().values[row] * to_seconds_;
  }

  void skip(const Statement& reason, std::size_t count) {
    if (count > 0) skipped_.push_back({reason, count});
  }

  void refuse_long_steps_back() {
    double latest = -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < table_.rows; ++row) {
      const double t = time_s(row);
      if (std::isnan(t)) continue;
      if (latest - t > largest_step_back_s && !fit_between_each_other()) {
        throw InputError({table_.file, table_.line_of(row), 0},
                         {fmt::format("time runs back by {:.6g} s", latest - t), "", "",
                          "two logs concatenated? split the file, or correct the unit of time"});
      }
      if (t < latest && steps_back_++ == 0) first_back_line_ = table_.line_of(row);
      latest = std::max(latest, t);
    }
  }

  /// Whether the rows of several writers, who alternate, make an even clock when they are sorted.
  [[nodiscard]] bool fit_between_each_other() {
    constexpr double least_step = 0.5;  // of the median
    constexpr double most_short = 0.02;
    constexpr std::size_t fewest_turns = 4;  // fewer: logs one behind the other
    if (fits_) return *fits_;
    std::vector<double> times;
    std::size_t turns = 0;
    for (std::size_t row = 0; row < table_.rows; ++row) {
      if (std::isnan(time_s(row))) continue;
      turns += !times.empty() && times.back() - time_s(row) > largest_step_back_s ? 1 : 0;
      times.push_back(time_s(row));
    }
    fits_ = false;
    if (turns < fewest_turns) return false;
    std::sort(times.begin(), times.end());
    const double usual = log::median_clock_step(times);
    std::size_t shorter = 0;
    for (std::size_t i = 1; i < times.size(); ++i) {
      if (times[i] - times[i - 1] < least_step * usual) ++shorter;
    }
    fits_ = static_cast<double>(shorter) <= most_short * static_cast<double>(times.size());
    return *fits_;
  }

  void drop_held_rows() {
    std::vector<const std::vector<double>*> signals;
    const std::vector<LoggedColumn> columns = logged_columns(entry_.columns);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const bool changes = columns[k].signal == joint::LoggedSignal::angle ||
                           columns[k].signal == joint::LoggedSignal::effort ||
                           columns[k].signal == joint::LoggedSignal::speed;
      if (changes) signals.push_back(&table_.columns[k].values);
    }
    const auto held = find_held_rows(rows_, signals);
    if (!held) return;
    const double share =
        static_cast<double>(rows_.size() - held->kept.size()) / static_cast<double>(rows_.size());
    notes_.add({"reading.held_rows", {{"percent", 100 * share}, {"rows", held->rows_per_sample}}});
    skip(Code{"skipped.held"}, rows_.size() - held->kept.size());
    rows_ = held->kept;
  }

  void drop_outside_and_gaps() {
    const double from = entry_.from_s.value_or(-std::numeric_limits<double>::infinity());
    const double to = entry_.to_s.value_or(std::numeric_limits<double>::infinity());
    std::size_t outside = 0;
    std::vector<std::size_t> gaps(table_.columns.size());
    std::vector<std::size_t> impossible(table_.columns.size());
    for (std::size_t row = 0; row < table_.rows; ++row) {
      const double t = time_s(row);
      if (t < from || t > to) {
        ++outside;
        continue;
      }
      const auto gap = std::find_if(
          table_.columns.begin(), table_.columns.end(),
          [row](const log::LogColumn& column) { return std::isnan(column.values[row]); });
      if (gap == table_.columns.end()) {
        rows_.push_back(row);
      } else {
        ++(gap->is_impossible(row) ? impossible
                                   : gaps)[static_cast<std::size_t>(gap - table_.columns.begin())];
      }
    }
    skip({outside_window, {{"window", window()}}}, outside);
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      const std::string column = in_quotes(table_.columns[k].header.full);
      skip({"skipped.gap", {{"column", column}}}, gaps[k]);
      skip({"skipped.impossible", {{"column", column}}}, impossible[k]);
    }
  }

  [[nodiscard]] std::string window() const {
    return fmt::format("{}..{} s", entry_.from_s ? fmt::format("{}", *entry_.from_s) : "",
                       entry_.to_s ? fmt::format("{}", *entry_.to_s) : "");
  }

  void put_in_order() {
    std::stable_sort(rows_.begin(), rows_.end(),
                     [this](std::size_t a, std::size_t b) { return time_s(a) < time_s(b); });
    notes_.add({"reading.time_runs_back", {{"rows", steps_back_}, {"line", first_back_line_}}});
  }

  void drop_repeated_stamps() {
    const auto same_time = [this](std::size_t a, std::size_t b) { return time_s(a) == time_s(b); };
    const std::size_t before = rows_.size();
    rows_.erase(std::unique(rows_.begin(), rows_.end(), same_time), rows_.end());
    const std::size_t repeated = before - rows_.size();
    skip(Code{"skipped.repeated_stamp"}, repeated);
    if (static_cast<double>(repeated) <= most_repeated_stamps * static_cast<double>(before)) return;
    throw InputError({table_.file, 0, 0},
                     {fmt::format("column {}: {} of {} time stamps repeat an earlier one",
                                  in_quotes(table_.columns.front().header.full), repeated, before),
                      "", "no more than 5 %", "time column has too few digits?"});
  }

  [[noreturn]] void refuse_too_few() const {
    std::string reasons;
    for (const joint::SkippedRows& skipped : skipped_) {
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "left out: " : ", ",
                             wording::words(skipped.reason), skipped.count);
    }
    throw InputError({table_.file, 0, 0},
                     {"too few usable rows", fmt::format("{} of {}", rows_.size(), table_.rows),
                      fmt::format("at least {}", fewest_rows), reasons});
  }

  const manifest::RecordingEntry& entry_;
  const log::LogTable& table_;
  RecordingNotes& notes_;
  double to_seconds_;
  std::size_t steps_back_{0};
  std::optional<bool> fits_;
  long first_back_line_{0};
  std::vector<std::size_t> rows_;
  std::vector<joint::SkippedRows> skipped_;
};

}  // namespace

void RecordingNotes::add(const Statement& note) {
  Statement of_file("reading.of_file", {{"file", printable(file_)}, {"note", note}});
  const std::string said = wording::words(of_file);
  const bool is_known = std::any_of(notes_.begin(), notes_.end(), [&said](const Statement& one) {
    return wording::words(one) == said;
  });
  if (!is_known) notes_.push_back(std::move(of_file));
}

bool RecordingNotes::has(Code kind) const {
  const std::string file = printable(file_);
  return std::any_of(notes_.begin(), notes_.end(), [&](const Statement& one) {
    const auto says = [&](const char* name, const auto& is_it) {
      return std::any_of(one.values().begin(), one.values().end(),
                         [&](const StatedValue& v) { return v.name == name && is_it(v); });
    };
    return says("file",
                [&](const StatedValue& v) {
                  const auto* text = std::get_if<std::string>(&v.value);
                  return text != nullptr && *text == file;
                }) &&
           says("note", [&](const StatedValue& v) {
             const auto* notes = std::get_if<std::vector<Statement>>(&v.value);
             return notes != nullptr && !notes->empty() && notes->front().is(kind);
           });
  });
}

bool is_outside_window(const joint::SkippedRows& skipped) {
  return skipped.reason.is(outside_window);
}

bool is_of_whole_file(const joint::SkippedRows& skipped) {
  return skipped.reason.is(cut_off) || skipped.reason.is(not_usable) ||
         skipped.reason.is(unclear) || skipped.reason.is(other_joint);
}

RowChoice choose_rows(const manifest::RecordingEntry& entry, const log::LogTable& table,
                      RecordingNotes& notes) {
  return RowChooser(entry, table, notes).choose();
}

}  // namespace tribolog::ingest::dataset
