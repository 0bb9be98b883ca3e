#pragma once
// What inspect and init have in common.

#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "inspect/survey/log_survey.h"
#include "inspect/survey/manifest_proposal.h"

namespace tribolog {

/// Surveys the logs in their order. One that is refused is told at once, and the others go on.
/// @throw InputError of the only log, or of the first one if all are refused.
std::vector<LogSurvey> survey_logs(const InspectedLogs& options, Console& console);

/// 3 if a log was refused.
ExitStatus status_of(const std::vector<LogSurvey>& logs);

struct Proposed {
  std::string text;  ///< Empty: none could be proposed.
  std::string joint;
  std::string refusal;  ///< Why not.
};

/// A manifest, or why there is none. @throw UsageError for a joint that no log has.
Proposed try_to_propose(const std::vector<LogSurvey>& logs, const ProposalOptions& known);

/// A few lines: the joint, the roles found, and what to correct.
void tell_proposal(const ManifestProposal& proposal, Console& console);

}  // namespace tribolog
