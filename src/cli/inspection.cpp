#include "cli/inspection.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/closest_match.h"

namespace tribolog {

std::vector<LogSurvey> survey_logs(const InspectedLogs& options, Console& console) {
  std::vector<LogSurvey> logs;
  std::optional<InputError> first;
  for (std::size_t k = 0; k < options.files.size(); ++k) {
    console.progress("reading the logs", k, options.files.size());
    try {
      logs.push_back(survey_log(options.files[k], options.known.log_rules));
    } catch (const InputError& error) {
      if (!first) first = error;
      logs.emplace_back();
      logs.back().file = options.files[k];
      logs.back().refusal = error.what();
      if (options.files.size() > 1) console.warn(std::string("error: ") + error.what());
    }
  }
  console.finish();
  const bool all_refused = std::all_of(logs.begin(), logs.end(),
                                       [](const LogSurvey& log) { return !log.refusal.empty(); });
  if (first && all_refused) throw InputError(*first);
  return logs;
}

ExitStatus status_of(const std::vector<LogSurvey>& logs) {
  const bool one_refused = std::any_of(logs.begin(), logs.end(),
                                       [](const LogSurvey& log) { return !log.refusal.empty(); });
  return one_refused ? ExitStatus::input_refused : ExitStatus::done;
}

Proposed try_to_propose(const std::vector<LogSurvey>& logs, const ProposalOptions& known) {
  Proposed proposed;
  try {
    const ManifestProposal proposal = propose_manifest(logs, known);
    proposed.text = proposal.text;
    proposed.joint = proposal.joint;
  } catch (const InputError& error) {
    proposed.refusal = error.what();
  }
  return proposed;
}

void tell_proposal(const ManifestProposal& proposal, Console& console) {
  std::map<Role, std::size_t> counts;
  for (const ProposedRecording& recording : proposal.roles.recordings) ++counts[recording.role];
  std::string roles;
  for (const auto& [role, count] : counts) {
    roles += fmt::format("{}{} {}", roles.empty() ? "" : ", ", count, to_string(role));
  }
  console.say(fmt::format("joint {}: {}",
                          proposal.joint.empty() ? "without a name" : in_quotes(proposal.joint),
                          proposal.roles.is_makeshift
                              ? "no motion that a stage reads; each log is named as a rough_sweep "
                                "for the time being"
                              : roles));
  if (!proposal.moves_too.empty()) {
    console.say("others that move too: " + list_of_names(proposal.moves_too, 8));
  }
  if (!proposal.roles.without_role.empty()) {
    console.say(fmt::format("{} log(s) hold nothing to use", proposal.roles.without_role.size()));
  }
}

}  // namespace tribolog
