#pragma once
// Which joint a manifest is for, and what its effort is.

#include <optional>
#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"
#include "inspect/survey/manifest_proposal.h"
#include "inspect/survey/recording_roles.h"

namespace tribolog::inspect::survey {

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

// What the effort of a joint is proposed to be, and how sure that is.

struct EffortProposal {
  joint::EffortKind kind{joint::EffortKind::none};
  std::vector<std::string> remarks;  ///< For comments, one line each.
  std::vector<std::string> lines;    ///< Of [effort], each a key with its value and a comment.
  bool is_target{};  ///< No measured effort is there: a controller's value stands in.

  /// The column in a joint's own log; nothing where it has none of this kind.
  [[nodiscard]] std::optional<std::size_t> column_of(const JointSurvey& joint) const;
};

/// A current is one of the motor. A torque is taken as the known logger has it, as the motor's
/// where its name says so, else as the joint's. What no logger states is not confirmed. The first
/// log of the joint that has an effort decides.
EffortProposal propose_effort(const std::vector<LogSurvey>& logs,
                              const std::vector<JointInLog>& joint, const ProposalOptions& options);

/// Columns that look like voltages or duty cycles, from which no torque follows.
std::vector<std::string> voltages_of(const TableSurvey& table);

}  // namespace tribolog::inspect::survey
