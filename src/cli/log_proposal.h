#pragma once
// From logs to a manifest: what inspect, init, identify and report have in common.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "cli/console.h"
#include "inspect/survey/log_survey.h"
#include "inspect/survey/manifest_proposal.h"

namespace tribolog::cli {

/// What the command line states of logs.
struct InspectedLogs {
  std::vector<std::string> files;
  inspect::survey::ProposalOptions known;
  inspect::survey::StatedJoints of_joints;  ///< Several values with all joints alone.
};

struct SurveyedFile {
  std::string path;
  bool is_named;  ///< By the user or a recorder, else just found in a folder.
};

/// The logs that paths name, folders with all of theirs.
/// @throw InputError as log_files_in().
std::vector<SurveyedFile> files_of(const std::vector<std::string>& paths);
std::vector<std::string> paths_of(const std::vector<SurveyedFile>& files);

/// Surveys the logs with what is known of the gears. Where several ratios are stated and angles of
/// motors are logged, whose ratio is whose follows from a first survey without them. A log that is
/// refused is reported at once, and the others go on.
/// @param of_joints receives whose they are.
/// @throw InputError of the only log, or of the first one if all are refused.
std::vector<inspect::survey::LogSurvey> survey_with_gears(const std::vector<SurveyedFile>& files,
                                                          const InspectedLogs& options,
                                                          inspect::survey::StatedJoints& of_joints,
                                                          Console& console);

/// 3 if a log was refused.
ExitStatus status_of(const std::vector<inspect::survey::LogSurvey>& logs);

/// What is known of the one joint. @throw UsageError: several values.
inspect::survey::ProposalOptions known_of_one(const InspectedLogs& logs);

struct ProposedManifest {
  std::string text;
  std::vector<std::string> open;  ///< Options that would state what is not known: "--gear-ratio N".
};

/// The manifest of the joint that moves most, or of all; what it is of and what is open is printed.
/// @param directory of the manifest.
/// @throw as propose_manifest().
ProposedManifest propose(const InspectedLogs& of, bool all_joints, const std::string& directory,
                         const std::vector<inspect::survey::LogSurvey>& logs,
                         const inspect::survey::StatedJoints& of_joints, Console& console);

/// Every option that states something of logs, but for the joint's name.
void add_known_of_logs(CLI::App& command, InspectedLogs& logs);

}  // namespace tribolog::cli
