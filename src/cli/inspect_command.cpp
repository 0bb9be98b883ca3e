#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/log_proposal.h"
#include "inspect/survey/log_survey.h"
#include "inspect/survey/manifest_proposal.h"

namespace tribolog::cli {

namespace {

struct InspectOptions {
  InspectedLogs logs;
  std::string json;  ///< All of it as JSON; empty: only the text.
};

struct InitOptions {
  InspectedLogs logs;
  std::string output;      ///< The manifest.
  bool all_joints{false};  ///< A robot's, with all joints in the logs.
  bool force{false};       ///< Replaces one that exists.
};

struct Proposed {
  std::string text;  ///< Empty: none could be proposed.
  std::string joint;
  std::vector<inspect::survey::LogSurvey> logs;  ///< With the effort as it is proposed.
  std::string refusal;                           ///< Why not.
};

/// A manifest, or why there is none. @throw UsageError for a joint that no log has.
Proposed try_to_propose(const std::vector<inspect::survey::LogSurvey>& logs,
                        const inspect::survey::ProposalOptions& known) {
  Proposed proposed;
  proposed.logs = logs;
  try {
    const inspect::survey::ManifestProposal proposal =
        inspect::survey::propose_manifest(logs, known);
    proposed.text = proposal.text;
    proposed.joint = proposal.joint;
    inspect::survey::tell_effort(proposal, proposed.logs);
  } catch (const InputError& error) {
    proposed.refusal = error.what();
  }
  return proposed;
}

ExitStatus run_inspect(const InspectOptions& options, Console& console) {
  const std::vector<SurveyedFile> files = files_of(options.logs.files);
  if (!options.json.empty()) check_output_can_be_written(options.json, paths_of(files));
  console.make_way_for(options.json);
  inspect::survey::StatedJoints of_joints = options.logs.of_joints;
  const std::vector<inspect::survey::LogSurvey> logs =
      survey_with_gears(files, options.logs, of_joints, console);
  const Proposed proposed = try_to_propose(logs, known_of_one(options.logs));
  console.say(inspect::survey::survey_text(proposed.logs, proposed.joint));
  if (!proposed.text.empty()) {
    console.say("Proposed manifest; tribolog init FILE... -o dataset.toml writes it:\n\n" +
                proposed.text);
  } else {
    console.warn(proposed.refusal);
  }
  if (!options.json.empty()) {
    write_file_atomically(options.json, inspect::survey::survey_json(proposed.logs, proposed.text));
  }
  return status_of(logs);
}

ExitStatus run_init(const InitOptions& options, Console& console) {
  namespace fs = std::filesystem;
  if (!options.force && is_file_output(options.output) && fs::exists(options.output)) {
    throw OutputError(printable(options.output, 400) +
                      ": exists and was left unchanged; --force replaces it");
  }
  const std::vector<SurveyedFile> files = files_of(options.logs.files);
  check_output_can_be_written(options.output, paths_of(files));
  console.make_way_for(options.output);
  inspect::survey::StatedJoints of_joints = options.logs.of_joints;
  const std::vector<inspect::survey::LogSurvey> logs =
      survey_with_gears(files, options.logs, of_joints, console);
  const std::string directory = std::filesystem::path(options.output).parent_path().string();
  const ProposedManifest proposed =
      propose(options.logs, options.all_joints, directory, logs, of_joints, console);
  write_file_atomically(options.output, proposed.text);
  console.say("manifest: " + printable(options.output, 400));
  return status_of(logs);
}

void add_inspected_logs(CLI::App& command, InspectedLogs& logs) {
  command.add_option("FILE", logs.files, "logs of any format, or folders of them")->required();
  command.add_option("--joint", logs.known.joint,
                     "name of the joint in the logs; default: the one that moves most");
  add_known_of_logs(command, logs);
}

}  // namespace

Run add_inspect(CLI::App& app) {
  const auto options = std::make_shared<InspectOptions>();
  CLI::App& command = *app.add_subcommand(
      "inspect", "what a log contains: columns, clock, motion, a manifest for it");
  add_inspected_logs(command, options->logs);
  command.add_option("--json", options->json, "file for the full result (JSON)");
  command.footer(
      "\nGuesses are marked as such. Speeds are slopes of the angle between marks of its "
      "travel;\nthe logged speed is not trusted. A log that is refused does not prevent the others "
      "from\nbeing shown; the exit status is 3 then.");
  return [options](const Invocation& call) { return run_inspect(*options, call.console); };
}

Run add_init(CLI::App& app) {
  const auto options = std::make_shared<InitOptions>();
  CLI::App& command = *app.add_subcommand("init", "write the manifest that inspect proposes");
  add_inspected_logs(command, options->logs);
  command.add_option("-o,--output", options->output, "manifest (TOML) to write")->required();
  command
      .add_flag("--all-joints", options->all_joints,
                "a manifest of the whole robot, with every joint that moves in the logs")
      ->excludes("--joint");
  command.add_flag("--force", options->force, "replace an existing manifest");
  command.footer(
      "\nWith --all-joints, --gear-ratio and --torque-constant take one value for all joints, or "
      "one for\neach in the order of the logs, separated by commas.\nGear ratio and torque "
      "constant are rarely in a log: state them here, or in the file.\nIts "
      "comments say what was guessed.");
  return [options](const Invocation& call) { return run_init(*options, call.console); };
}

}  // namespace tribolog::cli
