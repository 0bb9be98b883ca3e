#pragma once
// What identify and report are given: a manifest, or logs, for which one is proposed and written.

#include <cstddef>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/console.h"
#include "cli/identification.h"
#include "cli/log_proposal.h"

namespace tribolog::cli {

struct GivenData {
  std::vector<std::string> paths;  ///< A manifest, or logs and folders of logs.
  std::string joint;   ///< By its name; empty: the manifest's, or the one that moves most.
  InspectedLogs logs;  ///< What is known of logs; nothing with a manifest.
  bool all_joints{};
  bool force{};                             ///< Replaces a manifest that was edited.
  std::vector<const CLI::Option*> of_logs;  ///< The options that are for logs alone.
};

struct FoundData {
  DatasetChoice dataset;
  std::string stem;  ///< Of the outputs' names that are not stated: "runs/j3" of "runs/j3.csv".
  std::vector<std::string> open;  ///< Options that would state what is not known.
};

/// Of logs the manifest is proposed and written beside the output or, where none is stated, beside
/// the log: never over one that somebody edited.
/// @param output that is stated; empty: none.
/// @throw InputError, UsageError as propose_manifest(); UsageError: options of logs beside a
///        manifest. OutputError: the manifest cannot be written, or is somebody's.
FoundData find_data(const GivenData& given, const std::string& output, Console& console);

/// The stated output, or one beside the input.
/// @param ending ".html"; empty: a directory.
/// @throw OutputError: it would replace a file that this program has not written.
std::string output_or_beside(const std::string& stated, const FoundData& found,
                             const std::string& ending);

/// The line to type for what is not known yet: the one that was typed, with what it lacks; nothing
/// where all is known.
void tell_what_is_open(const FoundData& found, const std::vector<std::string>& arguments,
                       Console& console);

/// Paths, --joint, and every option of logs.
void add_given_data(CLI::App& command, GivenData& given);

/// What help says of a manifest: its tables, by an example.
const char* manifest_help();

}  // namespace tribolog::cli
