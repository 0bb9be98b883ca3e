#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "inspect/survey/log_survey.h"
#include "inspect/survey/manifest_proposal.h"
#include "inspect/survey/text_table.h"
#include "wording/words.h"

namespace tribolog::inspect::survey {

// Columns of a log, or of logs that look alike, as a table for the console.

namespace {

std::string shown_number(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.5g}", value);
}

constexpr std::size_t longest_list_of_words = 4;

/// Columns of tables that look alike, over all of them.
struct ColumnOfAll {
  ColumnSurvey column;
  bool is_constant{true};
};

/// Remarks on columns, each once below the table.
class Remarks {
 public:
  /// The mark by which a remark is found: "(1)".
  std::string mark_of(const std::string& remark) {
    auto at = std::find(remarks_.begin(), remarks_.end(), remark);
    if (at == remarks_.end()) at = remarks_.insert(at, remark);
    return fmt::format("({})", at - remarks_.begin() + 1);
  }
  [[nodiscard]] std::string text() const {
    TextTable lines(2);
    for (std::size_t k = 0; k < remarks_.size(); ++k) {
      lines.add({fmt::format("({})", k + 1), remarks_[k]});
    }
    return remarks_.empty() ? "" : lines.text();
  }

 private:
  std::vector<std::string> remarks_;
};

std::vector<std::string> column_cells(const ColumnOfAll& of_all, Remarks& remarks) {
  const ColumnSurvey& c = of_all.column;
  if (!c.words.empty()) {
    return {printable(c.name, longest_name),
            "words",
            "",
            "",
            "",
            "",
            "",
            list_of_names(c.words, longest_list_of_words)};
  }
  std::vector<std::string> cells{printable(c.name, longest_name)};
  std::vector<std::string> notes;
  if (c.meaning) {
    const ingest::layout::ColumnMeaning& m = *c.meaning;
    cells.push_back((m.is_target ? "target " : "") + ingest::log::quantity_word(m.quantity));
    cells.push_back(printable(m.joint, longest_name));
    cells.push_back(printable(m.unit) + (m.unit_is_stated || c.unit_is_proven ? "" : "?"));
    if (!c.guessed_by.empty()) notes.push_back("guessed: " + c.guessed_by);
    if (!m.effort.remark.empty()) notes.push_back(remarks.mark_of(m.effort.remark));
  } else {
    cells.insert(cells.end(), {"?", "", printable(c.unit)});
  }
  cells.push_back(shown_number(c.lowest));
  cells.push_back(shown_number(c.highest));
  cells.push_back(c.step > 0 ? fmt::format("{:.3g}", c.step) : "");
  if (std::isnan(c.lowest)) {
    notes.emplace_back("nothing but gaps");
  } else if (of_all.is_constant) {
    notes.emplace_back("constant");
  }
  if (c.gaps > 0 && !std::isnan(c.lowest)) notes.push_back(plural(c.gaps, "gap"));
  std::string note;
  for (const std::string& one : notes) note += (note.empty() ? "" : "; ") + one;
  cells.push_back(note);
  return cells;
}

void take_in(const ColumnSurvey& other, ColumnOfAll& all) {
  const bool same = other.lowest == all.column.lowest && other.highest == all.column.highest;
  all.is_constant = all.is_constant && other.is_constant() && same;
  all.column.gaps += other.gaps;
  all.column.lowest = std::fmin(all.column.lowest, other.lowest);
  all.column.highest = std::fmax(all.column.highest, other.highest);
  if (other.step > 0) {
    all.column.step = all.column.step > 0 ? std::min(all.column.step, other.step) : other.step;
  }
}

/// @param tables at least one, all of the same columns: ranges are those over all of them.
std::string columns_text(const std::vector<const TableSurvey*>& tables) {
  TextTable table(2);
  Remarks remarks;
  table.add({"column", "meaning", "joint", "unit", "lowest", "highest", "step", ""});
  for (std::size_t k = 0; k < tables.front()->columns.size(); ++k) {
    const ColumnSurvey& first = tables.front()->columns[k];
    ColumnOfAll all{first, first.is_constant()};
    for (std::size_t t = 1; t < tables.size(); ++t) take_in(tables[t]->columns[k], all);
    table.add(column_cells(all, remarks));
  }
  std::string text = table.text();
  const bool guessed = text.find("?") != std::string::npos;
  if (guessed) text += "  (?: not stated by the log)\n";
  return text + remarks.text();
}

constexpr std::size_t gaps_told = 3;
constexpr double noticeable_jitter_percent = 1;
constexpr std::size_t segments_in_row = 4;

std::string paragraph(const std::string& first, const std::string& text) {
  TextTable table(2);
  table.add({first, text});
  return table.text();
}

std::string clock_words(const ClockSurvey& c) {
  std::string words = fmt::format("{} in {}", in_quotes(c.column), printable(c.unit));
  if (c.plus) words += fmt::format(" plus {} in {}", in_quotes(c.plus->column), c.plus->unit);
  if (c.is_counter) words = in_quotes(c.column) + ", which counts the samples";
  if (!c.unit_is_stated) {
    words += c.is_proven ? " (the log states no unit: " + c.unit_by + ")"
                         : " (guessed by its steps; the log states no unit)";
  }
  if (!(c.interval_s > 0)) return words + ": it never rises, so it is no clock";
  words += fmt::format(": {:.4g} Hz for {:.5g} s", c.rate_Hz(), c.last_s - c.first_s);
  if (c.jitter_percent >= noticeable_jitter_percent) {
    words += fmt::format(", steps scatter by {:.2g} %", c.jitter_percent);
  }
  if (c.origin != 0) words += "; counts from 1970, here from its first reading";
  if (c.repeated > 0) words += "; " + plural(c.repeated, "stamp") + " stand twice";
  if (c.back > 0) {
    words += fmt::format("; runs back {}, by up to {:.3g} s", plural(c.back, "time"),
                         c.largest_step_back_s);
  }
  if (c.missing > 0) words += "; " + plural(c.missing, "row") + " without a time";
  if (!c.gaps.empty()) {
    words += "; " + plural(c.gaps.size(), "gap") + ":";
    for (std::size_t k = 0; k < std::min(gaps_told, c.gaps.size()); ++k) {
      words += fmt::format("{} {:.3g} s at {:.4g} s", k == 0 ? "" : ",", c.gaps[k].length_s,
                           c.gaps[k].at_s);
    }
    if (c.gaps.size() > gaps_told) words += ", ...";
  }
  return words;
}

std::string joint_title(const TableSurvey& table, const JointSurvey& joint) {
  const std::string name = joint.name.empty() ? "" : " of joint " + in_quotes(joint.name);
  return fmt::format(
      "motion{}, {} by {}", name, in_quotes(table.columns[joint.angle].name),
      joint.effort ? in_quotes(table.columns[*joint.effort].name) : std::string("no effort"));
}

bool moves(const JointSurvey& joint) {
  return std::any_of(
      joint.segments.begin(), joint.segments.end(),
      [](const motion::MotionSegment& s) { return s.kind != motion::MotionKind::rest; });
}

std::string motion_text(const TableSurvey& table) {
  std::string text;
  std::vector<std::string> still;
  for (const JointSurvey& joint : table.joints) {
    if (!moves(joint)) {
      still.push_back(joint.name.empty() ? table.columns[joint.angle].name : joint.name);
      continue;
    }
    text += fmt::format("\n  {}\n", joint_title(table, joint));
    TextTable rows(4);
    rows.add({"from s", "to s", "kind", ""});
    for (const motion::MotionSegment& s : joint.segments) {
      rows.add({fmt::format("{:.3f}", s.from_s), fmt::format("{:.3f}", s.to_s),
                motion::to_string(s.kind), describe(s)});
    }
    text += rows.text();
  }
  if (!still.empty()) text += fmt::format("\n{}", paragraph("at rest", list_of_names(still)));
  return text;
}

std::string faults_of(const TableSurvey& table) {
  const std::vector<std::string> voltages = voltages_of(table);
  std::string text;
  if (!table.clock) {
    text += paragraph("no clock",
                      table.counter.empty()
                          ? std::string("no column is known as the time: --column time=NAME, or "
                                        "--rate HZ of rows without one.")
                          : in_quotes(table.counter) +
                                " counts rows or milliseconds: --rate HZ states how many rows come "
                                "in a second, or --column time=NAME.");
  }
  if (table.joints.empty()) text += paragraph("no joint", "no column is known as a joint's angle.");
  for (const ingest::layout::ForeignUnit& f : table.foreign) {
    const ColumnSurvey& column = table.columns[f.column];
    text += paragraph(
        "unit", fmt::format("{} looks like {} in {}, a unit that is not known; a "
                            "manifest can state what one is: unit = \"{}\".",
                            in_quotes(column.name), ingest::log::to_string(f.quantity),
                            in_quotes(column.unit), ingest::log::example_of_multiple(f.quantity)));
  }
  const bool has_effort = std::any_of(table.joints.begin(), table.joints.end(),
                                      [](const JointSurvey& j) { return j.effort.has_value(); });
  if (!table.joints.empty() && !has_effort) {
    text += paragraph("no effort", "no torque and no motor current is known" +
                                       (voltages.empty() ? std::string()
                                                         : "; no torque follows from " +
                                                               list_of_names(voltages, 6)) +
                                       ".");
    for (const std::string& column : not_understood(table)) {
      text += paragraph("effort?", column + ".");
    }
  }
  return text;
}

std::string table_title(const TableSurvey& table) {
  std::string title = plural(table.rows, "row");
  if (table.rows_of)
    title +=
        " in which " + in_quotes(table.rows_of->first) + " is " + in_quotes(table.rows_of->second);
  if (!table.logger.empty()) title += ", columns as " + table.logger + " writes them";
  return table.group.empty() ? title : in_quotes(table.group) + ": " + title;
}

std::string notes_text(const LogSurvey& log) {
  std::string text;
  for (const Statement& note : log.notes) {
    text += paragraph("note", printable(wording::words(note), 400));
  }
  return text;
}

std::string block(const LogSurvey& log) {
  std::string text = printable(log.file, 400) + "\n";
  if (!log.refusal.empty()) return text + paragraph("refused", log.refusal);
  text += "  " + ingest::log::to_string(log.format) + "\n" + notes_text(log);
  for (const TableSurvey& table : log.tables) {
    text += "\n  " + table_title(table) + "\n";
    if (table.clock) text += paragraph("clock", clock_words(*table.clock));
    text += columns_text({&table}) + faults_of(table) + motion_text(table);
  }
  return text;
}

/// The one named, or else the one that moves most.
const JointSurvey* joint_in(const TableSurvey& table, const std::string& name) {
  const JointSurvey* chosen = nullptr;
  for (const JointSurvey& joint : table.joints) {
    if (!name.empty() && joint.name == name) return &joint;
    if (chosen == nullptr || joint.range_rad() > chosen->range_rad()) chosen = &joint;
  }
  return chosen;
}

std::string motion_in_short(const TableSurvey& table, const std::string& joint_name) {
  const JointSurvey* joint = joint_in(table, joint_name);
  if (joint == nullptr) return "no angle";
  std::string words;
  std::size_t shown = 0;
  for (const motion::MotionSegment& s : joint->segments) {
    if (s.kind == motion::MotionKind::rest || s.kind == motion::MotionKind::varying) continue;
    if (shown++ == segments_in_row) return words + "; ...";
    words += (words.empty() ? "" : "; ") + motion::to_string(s.kind) + " " + describe(s);
  }
  if (shown > 0) return words;
  return moves(*joint) ? "other motion" : "at rest";
}

std::string clock_in_short(const ClockSurvey& c) {
  std::string words;
  if (c.repeated > 0) words += fmt::format(" {} repeated", c.repeated);
  if (c.back > 0) words += fmt::format(" {} back", c.back);
  if (!c.gaps.empty()) words += fmt::format(" {}", plural(c.gaps.size(), "gap"));
  return words.empty() ? "even" : words.substr(1);
}

/// Rows, clock and motion of a table in a row of the table of all.
std::vector<std::string> cells_in_short(const std::string& name, const TableSurvey& table,
                                        const std::string& joint) {
  const auto& clock = table.clock;
  return {printable(name, longest_name),
          fmt::format("{}", table.rows),
          clock ? fmt::format("{:.4g}", clock->last_s - clock->first_s) : "",
          clock ? fmt::format("{:.4g}", clock->rate_Hz()) : "",
          clock ? clock_in_short(*clock) : "none",
          motion_in_short(table, joint)};
}

bool holds_several_recordings(const LogSurvey& log) {
  return log.tables.size() > 1 && log.tables.front().is_one_of_several;
}

/// One log with several recordings.
std::string block_of_recordings(const LogSurvey& log, const std::string& joint) {
  std::vector<const TableSurvey*> tables;
  for (const TableSurvey& table : log.tables) tables.push_back(&table);
  const TableSurvey& first = log.tables.front();
  std::string text = printable(log.file, 400) + "\n";
  text += fmt::format("  {}: {} recordings, which {} tells apart{}\n",
                      ingest::log::to_string(log.format), tables.size(),
                      in_quotes(first.rows_of->first),
                      first.logger.empty() ? "" : "; columns as " + first.logger + " writes them");
  text += notes_text(log) + columns_text(tables) + faults_of(first) + "\n";
  TextTable rows(2);
  rows.add({"recording", "rows", "s", "Hz", "clock", "motion"});
  for (const TableSurvey* table : tables) {
    rows.add(cells_in_short(table->rows_of->second, *table, joint));
  }
  return text + rows.text();
}

/// Logs of one table each, with the same columns.
std::string block(const std::vector<const LogSurvey*>& logs, const std::string& joint) {
  std::vector<const TableSurvey*> tables;
  for (const LogSurvey* log : logs) tables.push_back(&log->tables.front());
  const TableSurvey& first = *tables.front();
  std::string text =
      fmt::format("{} logs with the same columns: {}{}\n", logs.size(),
                  ingest::log::to_string(logs.front()->format),
                  first.logger.empty() ? "" : ", as " + first.logger + " writes them");
  text += notes_text(*logs.front());
  text += columns_text(tables) + faults_of(first) + "\n";
  TextTable rows(2);
  rows.add({"log", "rows", "s", "Hz", "clock", "motion"});
  for (std::size_t k = 0; k < logs.size(); ++k) {
    const std::string& file = logs[k]->file;
    rows.add(cells_in_short(file.substr(file.rfind('/') + 1), *tables[k], joint));
  }
  return text + rows.text();
}

bool look_alike(const LogSurvey& a, const LogSurvey& b) {
  if (!a.refusal.empty() || !b.refusal.empty() || a.format != b.format) return false;
  if (a.tables.size() != 1 || b.tables.size() != 1) return false;
  const auto& left = a.tables.front().columns;
  const auto& right = b.tables.front().columns;
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const ColumnSurvey& x, const ColumnSurvey& y) {
                      return x.name == y.name && x.meaning.has_value() == y.meaning.has_value();
                    });
}

}  // namespace

std::string survey_text(const std::vector<LogSurvey>& logs, const std::string& joint) {
  std::string text;
  std::vector<bool> done(logs.size(), false);
  for (std::size_t k = 0; k < logs.size(); ++k) {
    if (done[k]) continue;
    std::vector<const LogSurvey*> alike;
    for (std::size_t j = k; j < logs.size(); ++j) {
      if (done[j] || (j > k && !look_alike(logs[k], logs[j]))) continue;
      done[j] = true;
      alike.push_back(&logs[j]);
    }
    if (!text.empty()) text += '\n';
    text += holds_several_recordings(logs[k]) ? block_of_recordings(logs[k], joint)
            : alike.size() == 1               ? block(logs[k])
                                              : block(alike, joint);
  }
  return text;
}

}  // namespace tribolog::inspect::survey
