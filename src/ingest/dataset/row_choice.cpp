#include "ingest/dataset/row_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/requirements.h"

namespace tribolog::ingest::dataset {
namespace {

constexpr const char* outside_window = "outside the window ";
constexpr const char* cut_off = "cut off at the end of the file";
constexpr const char* not_usable = "cannot be used (skip_bad_rows)";
constexpr std::size_t fewest_rows = 20;
constexpr double largest_step_back_s = 1.0;    ///< Beyond: two logs, not a clock being set.
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
    drop_outside_and_gaps();
    if (steps_back_ > 0) put_in_order();
    drop_repeated_stamps();
    if (rows_.size() < fewest_rows) refuse_too_few();
    return {std::move(rows_), std::move(skipped_)};
  }

 private:
  [[nodiscard]] double time_s(std::size_t row) const {
    return table_.columns.front().values[row] * to_seconds_;
  }

  void skip(const std::string& reason, std::size_t count) {
    if (count > 0) skipped_.push_back({reason, count});
  }

  void refuse_long_steps_back() {
    double latest = -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < table_.rows; ++row) {
      const double t = time_s(row);
      if (std::isnan(t)) continue;
      if (latest - t > largest_step_back_s) {
        throw InputError({table_.file, table_.line_of(row), 0},
                         {fmt::format("time runs back by {:.6g} s", latest - t), "", "",
                          "two logs concatenated? split the file, or correct the unit of time"});
      }
      if (t < latest && steps_back_++ == 0) first_back_line_ = table_.line_of(row);
      latest = std::max(latest, t);
    }
  }

  void drop_outside_and_gaps() {
    const double from = entry_.from_s.value_or(-std::numeric_limits<double>::infinity());
    const double to = entry_.to_s.value_or(std::numeric_limits<double>::infinity());
    std::size_t outside = 0;
    std::vector<std::size_t> gaps(table_.columns.size());
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
        ++gaps[static_cast<std::size_t>(gap - table_.columns.begin())];
      }
    }
    skip(outside_window + window(), outside);
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      skip(fmt::format("gap (nan) in column {}", in_quotes(table_.columns[k].header.full)),
           gaps[k]);
    }
  }

  [[nodiscard]] std::string window() const {
    return fmt::format("{}..{} s", entry_.from_s ? fmt::format("{}", *entry_.from_s) : "",
                       entry_.to_s ? fmt::format("{}", *entry_.to_s) : "");
  }

  void put_in_order() {
    std::stable_sort(rows_.begin(), rows_.end(),
                     [this](std::size_t a, std::size_t b) { return time_s(a) < time_s(b); });
    notes_.add(fmt::format("time runs back in {} row{} (first in line {}); put in order of time",
                           steps_back_, steps_back_ == 1 ? "" : "s", first_back_line_));
  }

  void drop_repeated_stamps() {
    const auto same_time = [this](std::size_t a, std::size_t b) { return time_s(a) == time_s(b); };
    const std::size_t before = rows_.size();
    rows_.erase(std::unique(rows_.begin(), rows_.end(), same_time), rows_.end());
    const std::size_t repeated = before - rows_.size();
    skip("repeated time stamp", repeated);
    if (static_cast<double>(repeated) <= most_repeated_stamps * static_cast<double>(before)) return;
    throw InputError({table_.file, 0, 0},
                     {fmt::format("column {}: {} of {} time stamps repeat an earlier one",
                                  in_quotes(table_.columns.front().header.full), repeated, before),
                      "", "no more than 5 %", "time column has too few digits?"});
  }

  [[noreturn]] void refuse_too_few() const {
    std::string reasons;
    for (const joint::SkippedRows& skipped : skipped_) {
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "left out: " : ", ", skipped.reason,
                             skipped.count);
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
  long first_back_line_{0};
  std::vector<std::size_t> rows_;
  std::vector<joint::SkippedRows> skipped_;
};

}  // namespace

void RecordingNotes::add(const std::string& note) {
  std::string words = printable(file_) + ": " + note;
  if (std::find(notes_.begin(), notes_.end(), words) == notes_.end()) {
    notes_.push_back(std::move(words));
  }
}

bool is_outside_window(const joint::SkippedRows& skipped) {
  return skipped.reason.starts_with(outside_window);
}

bool is_of_whole_file(const joint::SkippedRows& skipped) {
  return skipped.reason == cut_off || skipped.reason == not_usable;
}

RowChoice choose_rows(const manifest::RecordingEntry& entry, const log::LogTable& table,
                      RecordingNotes& notes) {
  return RowChooser(entry, table, notes).choose();
}

}  // namespace tribolog::ingest::dataset
