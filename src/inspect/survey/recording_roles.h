#pragma once
// Which segment of which log plays which role in an identification (recording.h).

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"
#include "joint/recording.h"

namespace tribolog::inspect::survey {

/// A joint in one log.
struct JointInLog {
  std::size_t log{};
  std::size_t table{};
  std::size_t joint{};
};

inline const TableSurvey& table_of(const std::vector<LogSurvey>& logs, const JointInLog& of) {
  return logs[of.log].tables[of.table];
}
inline const JointSurvey& joint_of(const std::vector<LogSurvey>& logs, const JointInLog& of) {
  return table_of(logs, of).joints[of.joint];
}

struct ProposedRecording {
  JointInLog of;
  joint::Role role{};
  std::optional<double> from_s;  ///< Absent: from the log's start.
  std::optional<double> to_s;
  std::string what;  ///< "sine of 0.1 Hz, 5.9 cycles, -189° to -70°".
};

struct RoleProposal {
  std::vector<ProposedRecording> recordings;  ///< In the order of logs and of time.
  std::vector<std::size_t> without_role;      ///< Logs in which nothing was found to use.
  /// Nothing in any log is a motion that a stage reads: each log is named whole, as a sweep.
  bool is_makeshift{};
};

/// Strokes of constant speed are a rough sweep where they are slow (a stroke of 3 s or longer, up
/// to 0.5 rad/s) and wider than those of any other speed, and a precise one where they are the
/// slowest by far, and narrow, beside a sweep. All others are runs at constant speed.
RoleProposal propose_roles(const std::vector<LogSurvey>& logs,
                           const std::vector<JointInLog>& joint);

/// "constant speed 10 deg/s, 2 strokes, -30° to 30°", for people.
std::string describe(const motion::MotionSegment& segment);

}  // namespace tribolog::inspect::survey
