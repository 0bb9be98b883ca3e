#include "cli/given_data.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/encodings.h"
#include "base/error.h"
#include "base/shown_text.h"
#include "inspect/files/file_kind.h"

namespace tribolog::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view seal = "# Unedited as long as this is its digest: ";
constexpr std::size_t digits_of_seal = 16;

/// By its ending, else by what it holds.
bool is_manifest(const std::string& path) {
  return fs::path(path).extension() == ".toml" ||
         inspect::files::kind_of_file(path) == inspect::files::FileKind::manifest;
}

/// A page or numbers that this program wrote.
bool is_output(const std::string& path) {
  using inspect::files::FileKind;
  switch (inspect::files::kind_of_file(path)) {
    case FileKind::report:
    case FileKind::robot_page:
    case FileKind::other_page:
    case FileKind::bare_page:
    case FileKind::calibration:
      return true;
    default:
      return false;
  }
}

std::string sealed(const std::string& text) {
  return text + std::string(seal) + sha256_hex(text).substr(0, digits_of_seal) + "\n";
}

/// Whether the file is as this program wrote it: then another proposal may replace it.
bool is_unedited(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t at = text.rfind(seal);
  return at != std::string::npos && sealed(text.substr(0, at)) == text;
}

/// "runs/j3" of "runs/j3.csv"; of a folder or of several logs "runs/runs", in their folder.
std::string stem_of(const std::vector<std::string>& paths) {
  const fs::path first(paths.front());
  std::error_code error;
  const bool is_folder = fs::is_directory(first, error);
  if (paths.size() == 1 && !is_folder) return (first.parent_path() / first.stem()).string();
  const fs::path folder = is_folder ? first : first.parent_path();
  const fs::path whole = fs::weakly_canonical(folder.empty() ? "." : folder, error);
  return (folder / (whole.filename().empty() ? "log" : whole.filename())).string();
}

std::string without_ending(const std::string& path) {
  const fs::path whole(path);
  return (whole.parent_path() / whole.stem()).string();
}

void refuse_edited(const std::string& manifest, const GivenData& given) {
  std::error_code error;
  if (given.force || !fs::exists(manifest, error) || is_unedited(manifest)) return;
  throw OutputError(printable(manifest, 400) +
                    ": exists and was left unchanged, as it is not what was proposed; tribolog "
                    "report " +
                    printable(manifest, 400) + " uses it, --force replaces it");
}

void refuse_options_of_logs(const GivenData& given) {
  for (const CLI::Option* const option : given.of_logs) {
    if (option->count() == 0) continue;
    throw UsageError(option->get_name() + " is for logs; beside a manifest, " +
                     printable(given.paths.front()) + ", state it there");
  }
}

}  // namespace

FoundData find_data(const GivenData& given, const std::string& output, Console& console) {
  FoundData found;
  found.dataset.joint = given.joint;
  const auto manifest = std::find_if(given.paths.begin(), given.paths.end(), is_manifest);
  found.stem = stem_of(given.paths);
  if (manifest != given.paths.end()) {
    if (given.paths.size() > 1) {
      throw UsageError(printable(*manifest) + " is a manifest: one alone, or logs");
    }
    refuse_options_of_logs(given);
    found.dataset.manifest = *manifest;
    return found;
  }
  const bool is_beside_output = !output.empty() && is_file_output(output);
  found.dataset.manifest = (is_beside_output ? without_ending(output) : found.stem) + ".toml";
  const std::vector<SurveyedFile> files = files_of(given.paths);
  refuse_edited(found.dataset.manifest, given);
  check_output_can_be_written(found.dataset.manifest, paths_of(files));
  InspectedLogs of = given.logs;
  if (!given.joint.empty()) of.known.joint = given.joint;
  of.known.takes_amperes = true;
  const std::vector<inspect::survey::LogSurvey> logs =
      survey_with_gears(files, of, of.of_joints, console);
  for (const inspect::survey::LogSurvey& log : logs) {
    if (log.refusal.empty()) continue;
    throw InputError({log.file, 0, 0},
                     {"one of several logs, and it cannot be read: nothing was written", "", "",
                      "leave it out; -o FILE names what is to be written"});
  }
  const ProposedManifest proposed =
      propose(of, given.all_joints, fs::path(found.dataset.manifest).parent_path().string(), logs,
              of.of_joints, console);
  write_file_atomically(found.dataset.manifest, sealed(proposed.text));
  console.say("manifest: " + printable(found.dataset.manifest, 400));
  found.open = proposed.open;
  found.dataset.joint.clear();  // the manifest's only one
  return found;
}

std::string output_or_beside(const std::string& stated, const FoundData& found,
                             const std::string& ending) {
  if (!stated.empty()) return stated;
  const std::string path = found.stem + ending;
  std::error_code error;
  const bool is_there = fs::exists(path, error);
  const bool is_own = ending.empty() ? fs::is_directory(path, error) : is_output(path);
  if (is_there && !is_own) {
    throw OutputError(printable(path, 400) +
                      ": exists, is no file of tribolog's and was left unchanged; -o FILE names "
                      "another");
  }
  return path;
}

void tell_what_is_open(const FoundData& found, const std::vector<std::string>& arguments,
                       Console& console) {
  if (found.open.empty()) return;
  constexpr std::size_t longest_word = 400;
  std::string line = "tribolog";
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    line += " " + printable(quoted_for_shell(arguments[k]), longest_word);
  }
  for (const std::string& open : found.open) line += " " + open;
  console.say("the log does not tell these; with what you know of them:\n  " + line);
}

void add_given_data(CLI::App& command, GivenData& given) {
  command
      .add_option("DATA", given.paths,
                  "dataset manifest (TOML); or logs of any format, or folders of them")
      ->required();
  command
      .add_option("--joint", given.joint,
                  "one joint by its name, of a whole robot's manifest or of logs")
      ->type_name("NAME");
  const auto before = command.get_options();
  add_known_of_logs(command, given.logs);
  command.add_flag("--all-joints", given.all_joints, "of logs: every joint that moves in them")
      ->excludes("--joint");
  command.add_flag("--force", given.force, "of logs: replace a manifest that was edited");
  const std::set<const CLI::Option*> known(before.begin(), before.end());
  for (CLI::Option* const option : command.get_options()) {
    if (known.contains(option)) continue;
    given.of_logs.push_back(option);
    option->group("Of logs");
  }
}

const char* manifest_help() {
  return R"(
The manifest says, for example:

  schema = "tribolog-dataset-1"
  [robot]
  name = "FANUC AM100iB"
  description = "arm.toml"      # optional: draws the arm, see am100ib.toml
  [joint]
  name = "J3"
  gear_ratio = 100
  [effort]                      # never guessed: must be stated
  kind = "motor_current"        # or "motor_torque", "joint_torque"; "target_torque": a
                                # controller's value; "none": the log has no torque, and what
                                # its motion shows is checked
  side = "motor"                # or "joint": where the torque acts
  torque_constant_Nm_A = 0.35   # for motor_current
  confirmed = true              # false: only proposed; every torque is then doubtful
  [columns]
  time   = { name = "t", unit = "s" }
  angle  = { name = "q", unit = "deg" }
  effort = { name = "i", unit = "A" }    # file = "tau.csv": if it is in another file,
                                         # row by row; time = its time's name there
  [uncertainty]                 # optional: of what no recording shows, half widths at 95 %
  torque_constant_percent = 2   # also gear_ratio_percent, surrogate_distance_percent,
                                # gravity_percent, angle_zero_deg, hoses_percent,
                                # description_percent
  [certificate]                 # optional: for a calibration certificate
  laboratory = "..."            # also number, replaces, laboratory_address, country, customer,
                                # customer_address, place, received_on, procedure, conditions,
                                # humidity_percent, adjustment, decision_rule, responsible
  [[certificate.instrument]]
  name = "Torque sensor"        # also identification, traceability, used_for
  [[recording]]
  role = "rough_sweep"          # precise_sweep, oscillation, constant_speed, break_away;
                                # friction_points: of a curve read elsewhere, a row each,
                                # columns speed, effort, optional temperature, load
  file = "sweep.csv"
  [[limit]]                     # optional: what you accept; the report says whether it is met
  quantity = "coulomb_joint_Nm" # a wrong name prints the list
  max = 15                      # max, min, half_width, half_width_percent
  [log]                         # optional: what a text log does not show by itself
  decimal_comma = true
  skip_bad_rows = true          # damaged rows: leave out and count them, up to 1 %
  [[known_load]]                # optional: gravity of further axes, subtracted from the logs
  amplitude_Nm = 1.825          # at the joint: amplitude cos(sum of the angles + phase)
  angles = ["q1_rad", "q2_rad"] # columns of the log
  [[other_joint]]               # optional: another joint whose angle the logs have; of a robot
  name = "J2"                   # its [[joints]]. What its motion changes of gravity is taken off
  angle = { name = "q2", unit = "rad" }  # by description = "arm.urdf" in [robot], if there is one
  [known_gravity]               # optional: the joint's own, as by its design, to compare with
  amplitude_Nm = 38.465
  q_peak_deg = 90

Each role may occur any number of times, and each is optional: if one is absent,
the stages that need it say so; the rest still runs. The joints of one robot
can share a manifest, each in [[joints]]: --joint NAME picks one. tribolog manifest
prints every key.)";
}

}  // namespace tribolog::cli
