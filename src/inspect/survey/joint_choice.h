#pragma once
// Which joint a manifest is for.

#include <optional>
#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"
#include "inspect/survey/recording_roles.h"

namespace tribolog {

struct JointChoice {
  std::string name;
  std::vector<JointInLog> in_logs;     ///< One of each log that has it, and in it the widest.
  std::vector<std::string> moves_too;  ///< Others that move a hundredth as far or further.
};

/// The joint of that name, or else the one with the widest motion. Logs whose only joint has no
/// name take part in either case.
/// @throw InputError if no log has a clock and an angle; UsageError if none has that joint.
JointChoice choose_joint(const std::vector<LogSurvey>& logs,
                         const std::optional<std::string>& name);

}  // namespace tribolog
