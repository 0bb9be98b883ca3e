#pragma once
// A manifest for logs, as far as they tell by themselves: what `tribolog init` writes.

#include <optional>
#include <string>
#include <vector>

#include "inspect/survey/log_survey.h"
#include "inspect/survey/recording_roles.h"
#include "joint/drive.h"

namespace tribolog::inspect::survey {

/// What the user knows beside the logs.
struct ProposalOptions {
  std::optional<std::string> joint;  ///< Absent: the one that moves most.
  std::optional<double> gear_ratio;
  std::optional<double> torque_constant_Nm_A;
  std::optional<joint::Side> effort_side;
  std::optional<std::string> robot;
  ingest::text::TextLogRules log_rules;  ///< The logs were read with them.
  std::string directory;                 ///< Of the manifest: files are named relative to it.
};

struct ManifestProposal {
  std::string joint;                   ///< As in the logs; empty: they tell none.
  std::vector<JointInLog> in_logs;     ///< Where it is.
  std::vector<std::string> moves_too;  ///< Other joints that move beside it.
  RoleProposal roles;
  std::string text;  ///< TOML that read_manifest() takes, but for a torque
                     ///< constant nobody stated, which is 0 there.
};

/// @param logs those refused take no part.
/// @throw InputError if no log has a clock and an angle; UsageError for a joint that no log has.
ManifestProposal propose_manifest(const std::vector<LogSurvey>& logs,
                                  const ProposalOptions& options);

}  // namespace tribolog::inspect::survey
