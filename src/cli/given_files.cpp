#include "cli/given_files.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/enum_text.h"
#include "base/error.h"
#include "base/input_file.h"
#include "base/shown_text.h"
#include "cli/command_tree.h"

namespace tribolog::cli {
namespace {

using inspect::files::FileKind;

/// An argument that names a file to be read.
struct GivenFile {
  std::string_view command;  ///< "archive add"
  std::string_view argument;
  std::vector<FileKind> kinds;  ///< That it may be.
  const char* wanted;
};

const std::vector<GivenFile>& given_files() {
  const std::vector<FileKind> datasets{FileKind::manifest, FileKind::log};
  const std::vector<FileKind> numbers{FileKind::report, FileKind::calibration, FileKind::robot_page,
                                      FileKind::other_page};
  const char* const manifest = "a dataset manifest (TOML)";
  const char* const manifest_or_log = "a dataset manifest (TOML) or logs";
  const char* const scenario = "a scenario (TOML)";
  const char* const log = "a log";
  const char* const id = "the id of an archived calibration, which tribolog archive list shows";
  static const std::vector<GivenFile> all{
      {"identify", "DATA", datasets, manifest_or_log},
      {"figures", "DATASET", datasets, manifest},
      {"report", "DATA", datasets, manifest_or_log},
      {"simulate", "SCENARIO", {FileKind::scenario}, scenario},
      {"study", "SCENARIO", {FileKind::scenario}, scenario},
      {"paper", "SCENARIO", {FileKind::scenario}, scenario},
      {"plan",
       "JOINT",
       {FileKind::joint, FileKind::report, FileKind::calibration},
       "the file of a joint or of a robot's joints (TOML), a report or a calibration"},
      {"plan",
       "--calibration",
       {FileKind::report, FileKind::calibration},
       "a report (HTML) or a calibration (JSON)"},
      {"show", "FILE", numbers, "a report (HTML) or a calibration (JSON)"},
      {"export", "FILE", numbers, "a report (HTML) or a calibration (JSON)"},
      {"inspect", "FILE", {FileKind::log}, log},
      {"init", "FILE", {FileKind::log}, log},
      {"review", "REPORT", {FileKind::report}, "a report (HTML)"},
      {"archive add", "CALIBRATION", {FileKind::calibration}, "a calibration (JSON)"},
      {"archive add", "--report", {FileKind::report}, "a report (HTML)"},
      {"archive show", "ID", {}, id},
      {"archive report", "ID", {}, id},
      {"archive diff", "ID", {}, id},
      {"archive export", "ID", {}, id},
      {"archive remove", "ID", {}, id},
  };
  return all;
}

/// What to do with a calibration where an id is wanted.
std::string hint_for(FileKind kind, const std::string& file, const std::vector<FileKind>& kinds) {
  const std::string shown = quoted_for_shell(file);
  if (kinds.empty() && kind == FileKind::calibration) {
    return "tribolog archive add " + shown + " keeps it and prints its id";
  }
  return command_for(kind, shown);
}

}  // namespace

std::string name_of(FileKind kind) {
  constexpr EnumTexts<FileKind> names(
      "", "", "", "", "a manifest", "a scenario", "the file of a joint to plan for",
      "the description of an arm", "a report", "the page of a robot",
      "a page of tribolog, and no report", "a page of tribolog without numbers to read", "",
      "a calibration", "the numbers of a plan", "the true values of a simulation",
      "numbers of tribolog, and no calibration", "an archive", "a log");
  return std::string(names.of(kind));
}

std::string command_for(FileKind kind, const std::string& file) {
  switch (kind) {
    case FileKind::manifest:
      return "tribolog report " + file;
    case FileKind::scenario:
      return "tribolog simulate " + file + " -o DIRECTORY";
    case FileKind::joint:
      return "tribolog plan " + file + " -o DIRECTORY";
    case FileKind::arm:
      return "a manifest names it: [robot] description = \"" + file + "\"";
    case FileKind::report:
    case FileKind::robot_page:
    case FileKind::calibration:
      return "tribolog show " + file;
    case FileKind::other_page:
      return "tribolog show --json " + file;
    case FileKind::archive:
      return "tribolog archive list --archive " + file;
    case FileKind::log:
      return "tribolog report " + file;
    case FileKind::plan:
      return "plan.html beside it shows them";
    case FileKind::truth:
      return "dataset.toml beside it is the manifest";
    case FileKind::bare_page:
    case FileKind::foreign_page:
    case FileKind::other_json:
    case FileKind::missing:
    case FileKind::folder:
    case FileKind::empty:
    case FileKind::unknown:
      break;
  }
  return "";
}

void refuse_other_kind(const std::string& file, const std::vector<FileKind>& kinds,
                       const std::string& wanted) {
  const FileKind kind = inspect::files::kind_of_file(file);
  const std::string name = name_of(kind);
  if (name.empty() || std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) return;
  const bool holds =
      kind == FileKind::plan || kind == FileKind::truth || kind == FileKind::other_json;
  throw InputError({file, 0, 0},
                   {(holds ? "holds " : "is ") + name, "", wanted, hint_for(kind, file, kinds)});
}

void check_given_files(const CLI::App& command) {
  const std::string path = path_of(command);
  for (const GivenFile& one : given_files()) {
    if (one.command != path) continue;
    const CLI::Option* const option = command.get_option_no_throw(std::string(one.argument));
    if (option == nullptr) continue;
    for (const std::string& file : option->results()) {
      refuse_other_kind(file, one.kinds, one.wanted);
    }
  }
}

report::engine::EmbeddedJson numbers_in(const std::string& file) {
  const std::string text = read_file(file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] == '{') return {calibration_element, text};
  return report::engine::embedded_json(text, file);
}

std::string calibration_in(const std::string& file) {
  report::engine::EmbeddedJson numbers = numbers_in(file);
  if (numbers.element == calibration_element) return std::move(numbers.json);
  throw UsageError(fmt::format("{}: the page contains {}, and no calibration",
                               printable(file, longest_path), numbers.element));
}

}  // namespace tribolog::cli
