#include <filesystem>

#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/inspection.h"
#include "inspect/survey/survey_json.h"
#include "inspect/survey/survey_text.h"

namespace tribolog {

ExitStatus run_inspect(const InspectOptions& options, Console& console) {
  if (!options.json.empty()) check_output_can_be_written(options.json, options.logs.files);
  console.make_way_for(options.json);
  const std::vector<LogSurvey> logs = survey_logs(options.logs, console);
  const Proposed proposed = try_to_propose(logs, options.logs.known);
  console.say(survey_text(logs, proposed.joint));
  if (!proposed.text.empty()) {
    console.say("Proposed manifest; tribolog init FILE... -o dataset.toml writes it:\n\n" +
                proposed.text);
  } else {
    console.warn(proposed.refusal);
  }
  if (!options.json.empty()) {
    write_file_atomically(options.json, survey_json(logs, proposed.text));
  }
  return status_of(logs);
}

}  // namespace tribolog
