#include <filesystem>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/inspection.h"

namespace tribolog {

ExitStatus run_init(const InitOptions& options, Console& console) {
  namespace fs = std::filesystem;
  if (!options.force && is_file_output(options.output) && fs::exists(options.output)) {
    throw OutputError(printable(options.output, 400) +
                      ": exists, and is left as it is; --force replaces it");
  }
  check_output_can_be_written(options.output, options.logs.files);
  console.make_way_for(options.output);
  const std::vector<LogSurvey> logs = survey_logs(options.logs, console);
  ProposalOptions known = options.logs.known;
  known.directory = fs::path(options.output).parent_path().string();
  const ManifestProposal proposal = propose_manifest(logs, known);
  write_file_atomically(options.output, proposal.text);
  tell_proposal(proposal, console);
  console.say("manifest: " + printable(options.output, 400));
  return status_of(logs);
}

}  // namespace tribolog
