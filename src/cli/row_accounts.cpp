#include "cli/row_accounts.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/dataset/row_choice.h"

namespace tribolog {
namespace {

constexpr std::size_t longest_reason = 200;

/// A log with all recordings that are cut from it.
class Log {
 public:
  explicit Log(const InputFile& input) : name_(input.name), rows_(input.rows_read) {}

  [[nodiscard]] bool is(const InputFile& input) const { return input.name == name_; }

  void add(const InputFile& input) {
    ++recordings_;
    used_ += input.rows_used;
    for (const SkippedRows& skipped : input.skipped) {
      const auto known =
          std::find_if(skipped_.begin(), skipped_.end(),
                       [&](const SkippedRows& one) { return one.reason == skipped.reason; });
      if (known == skipped_.end()) {
        skipped_.push_back(skipped);
      } else if (!is_of_whole_file(skipped)) {
        known->count += skipped.count;
      }
    }
  }

  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Windows may overlap: then rows are used more than once.
  [[nodiscard]] std::size_t used() const { return std::min(used_, rows_); }

  void tell(std::vector<std::string>& lines) const {
    const bool is_cut_up = recordings_ > 1;
    std::size_t skipped_within = 0;
    for (const SkippedRows& one : skipped_) {
      if (is_cut_up && is_outside_window(one)) continue;
      skipped_within += one.count;
      lines.push_back(fmt::format("  {}: {} rows skipped: {}", printable(name_), one.count,
                                  printable(one.reason, longest_reason)));
    }
    const std::size_t within = used_ + skipped_within;
    if (!is_cut_up || within == rows_) return;
    lines.push_back(fmt::format(
        "  {}: {} recordings; {}", printable(name_), recordings_,
        within > rows_ ? "some of their windows overlap"
                       : fmt::format("{} of {} rows are in none of them", rows_ - within, rows_)));
  }

 private:
  std::string name_;
  std::size_t rows_;
  std::size_t recordings_{};
  std::size_t used_{};
  std::vector<SkippedRows> skipped_;
};

}  // namespace

std::vector<std::string> row_accounts(const std::vector<InputFile>& inputs) {
  std::vector<Log> logs;
  for (const InputFile& input : inputs) {
    if (input.conversions.empty()) continue;  // no recording's own file: its rows are counted there
    auto log =
        std::find_if(logs.begin(), logs.end(), [&](const Log& one) { return one.is(input); });
    if (log == logs.end()) log = logs.emplace(logs.end(), input);
    log->add(input);
  }
  std::vector<std::string> lines;
  std::size_t read = 0;
  std::size_t used = 0;
  for (const Log& log : logs) {
    log.tell(lines);
    read += log.rows();
    used += log.used();
  }
  lines.push_back(fmt::format("  rows: {} read, {} used", read, used));
  return lines;
}

}  // namespace tribolog
