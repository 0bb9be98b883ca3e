#include "inspect/survey/joint_choice.h"

#include <algorithm>

#include "base/closest_match.h"
#include "base/error.h"

namespace tribolog {
namespace {

constexpr double moves_share = 0.01;

struct Found {
  JointInLog in_log;
  const JointSurvey* joint;
  bool is_only;  ///< Of its log.
};

std::vector<Found> all_joints(const std::vector<LogSurvey>& logs) {
  std::vector<Found> found;
  for (std::size_t l = 0; l < logs.size(); ++l) {
    const std::size_t before = found.size();
    for (std::size_t t = 0; t < logs[l].tables.size(); ++t) {
      const TableSurvey& table = logs[l].tables[t];
      if (!table.clock) continue;
      for (std::size_t j = 0; j < table.joints.size(); ++j) {
        found.push_back({{l, t, j}, &table.joints[j], false});
      }
    }
    if (found.size() == before + 1) found.back().is_only = true;
  }
  return found;
}

[[noreturn]] void refuse_without_angle(const std::vector<LogSurvey>& logs) {
  std::vector<std::string> columns;
  std::string file;
  for (const LogSurvey& log : logs) {
    if (!log.refusal.empty()) continue;
    if (file.empty()) file = log.file;
    for (const TableSurvey& table : log.tables) {
      for (const ColumnSurvey& column : table.columns) {
        if (log.file == file) columns.push_back(column.name);
      }
    }
  }
  throw InputError({file, 0, 0},
                   {"no column is known as time and none as angle of a joint",
                    list_of_names(columns), "a clock and an angle, as \"t_s\" and \"q_rad\"",
                    "state in a manifest which column is which; names may be positions such as "
                    "\"#2\""});
}

}  // namespace

JointChoice choose_joint(const std::vector<LogSurvey>& logs,
                         const std::optional<std::string>& name) {
  const std::vector<Found> found = all_joints(logs);
  if (found.empty()) refuse_without_angle(logs);
  JointChoice choice;
  const auto range = [](const Found& f) { return f.joint->range_rad(); };
  if (name) {
    std::vector<std::string> names;
    for (const Found& f : found) {
      if (std::find(names.begin(), names.end(), f.joint->name) == names.end()) {
        names.push_back(f.joint->name);
      }
    }
    if (std::find(names.begin(), names.end(), *name) == names.end()) {
      throw UsageError("no log has a joint " + in_quotes(*name) + ", only " + list_of_names(names));
    }
    choice.name = *name;
  } else {
    const auto widest =
        std::max_element(found.begin(), found.end(),
                         [&](const Found& a, const Found& b) { return range(a) < range(b); });
    choice.name = widest->joint->name;
  }
  double widest = 0;
  for (const Found& f : found) {
    const bool is_it = f.joint->name == choice.name || (f.is_only && f.joint->name.empty());
    if (!is_it) continue;
    widest = std::max(widest, range(f));
    const bool is_next = choice.in_logs.empty() || choice.in_logs.back().log != f.in_log.log;
    if (is_next) {
      choice.in_logs.push_back(f.in_log);
      continue;
    }
    const JointInLog& known = choice.in_logs.back();
    if (range(f) > logs[known.log].tables[known.table].joints[known.joint].range_rad()) {
      choice.in_logs.back() = f.in_log;
    }
  }
  for (const Found& f : found) {
    const bool is_known = f.joint->name == choice.name || f.joint->name.empty() ||
                          std::find(choice.moves_too.begin(), choice.moves_too.end(),
                                    f.joint->name) != choice.moves_too.end();
    if (!is_known && range(f) > moves_share * widest) choice.moves_too.push_back(f.joint->name);
  }
  return choice;
}

}  // namespace tribolog
