#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/closest_match.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/shared_options.h"
#include "inspect/survey/log_survey.h"
#include "inspect/survey/manifest_proposal.h"

namespace tribolog::cli {

// What inspect and init have in common.

namespace {

struct Proposed {
  std::string text;  ///< Empty: none could be proposed.
  std::string joint;
  std::vector<inspect::survey::LogSurvey> logs;  ///< With the effort as it is proposed.
  std::string refusal;                           ///< Why not.
};

struct SurveyedFile {
  std::string path;
  bool is_named;  ///< By the user or a recorder, else just found in a folder.
};

/// What a recorder wrote as a whole: rosbag2, or LeRobot.
bool is_recorders_folder(const std::string& path) {
  namespace fs = std::filesystem;
  return fs::exists(fs::path(path) / "metadata.yaml") ||
         fs::exists(fs::path(path) / "meta" / "info.json");
}

std::vector<SurveyedFile> files_of(const std::vector<std::string>& paths) {
  std::vector<SurveyedFile> files;
  for (const std::string& path : paths) {
    const bool is_named = !std::filesystem::is_directory(path) || is_recorders_folder(path);
    for (std::string& file : inspect::survey::log_files_in(path)) {
      files.push_back({std::move(file), is_named});
    }
  }
  return files;
}

std::vector<std::string> paths_of(const std::vector<SurveyedFile>& files) {
  std::vector<std::string> paths;
  for (const SurveyedFile& file : files) paths.push_back(file.path);
  return paths;
}

/// Surveys the logs in their order. One that is refused is told at once, and the others go on.
/// @throw InputError of the only log, or of the first one if all are refused.
std::vector<inspect::survey::LogSurvey> survey_logs(const std::vector<SurveyedFile>& files,
                                                    const InspectedLogs& options,
                                                    const inspect::survey::StatedColumns& stated,
                                                    Console& console) {
  std::vector<inspect::survey::LogSurvey> logs;
  std::optional<InputError> first;
  for (std::size_t k = 0; k < files.size(); ++k) {
    console.progress("reading the logs", k, files.size());
    try {
      logs.push_back(inspect::survey::survey_log(files[k].path, options.known.log_rules, stated));
    } catch (const InputError& error) {
      if (!first) first = error;
      if (!files[k].is_named) {
        console.warn(std::string("note: not used: ") + error.what());
        continue;
      }
      logs.emplace_back();
      logs.back().file = files[k].path;
      logs.back().refusal = error.what();
      if (files.size() > 1) console.warn(std::string("error: ") + error.what());
    }
  }
  console.finish();
  const bool all_refused =
      std::all_of(logs.begin(), logs.end(),
                  [](const inspect::survey::LogSurvey& log) { return !log.refusal.empty(); });
  if (first && all_refused) throw InputError(*first);
  return logs;
}

/// Surveys the logs with what is known of the gears. Where several ratios are stated and angles of
/// motors are logged, whose ratio is whose follows from a first survey without them.
/// @param of_joints receives whose they are.
std::vector<inspect::survey::LogSurvey> survey_with_gears(const std::vector<SurveyedFile>& files,
                                                          const InspectedLogs& options,
                                                          inspect::survey::KnownOfJoints& of_joints,
                                                          Console& console) {
  inspect::survey::StatedColumns stated = options.known.columns;
  const std::vector<double>& ratios = of_joints.gear_ratios;
  if (ratios.size() == 1) stated.gear_ratio = ratios.front();
  std::vector<inspect::survey::LogSurvey> logs = survey_logs(files, options, stated, console);
  bool is_at_motor = false;
  for (const inspect::survey::LogSurvey& log : logs) {
    for (const inspect::survey::TableSurvey& table : log.tables) {
      is_at_motor = is_at_motor || std::any_of(table.columns.begin(), table.columns.end(),
                                               [](const inspect::survey::ColumnSurvey& column) {
                                                 return column.is_at_motor;
                                               });
    }
  }
  if (ratios.size() <= 1 || !is_at_motor) return logs;
  of_joints.joints = inspect::survey::joints_of_numbers(logs, options.known, ratios.size());
  if (of_joints.joints.empty()) return logs;  // of another number of joints: refused with a list
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    stated.gear_ratio_of[of_joints.joints[k]] = ratios[k];
  }
  return survey_logs(files, options, stated, console);
}

/// 3 if a log was refused.
ExitStatus status_of(const std::vector<inspect::survey::LogSurvey>& logs) {
  const bool one_refused =
      std::any_of(logs.begin(), logs.end(),
                  [](const inspect::survey::LogSurvey& log) { return !log.refusal.empty(); });
  return one_refused ? ExitStatus::input_refused : ExitStatus::done;
}

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

/// A few lines: the joint, the roles found, and what to correct.
void tell_proposal(const inspect::survey::ManifestProposal& proposal, Console& console) {
  std::map<joint::Role, std::size_t> counts;
  for (const inspect::survey::ProposedRecording& recording : proposal.roles.recordings)
    ++counts[recording.role];
  std::string roles;
  for (const auto& [role, count] : counts) {
    roles += fmt::format("{}{} {}", roles.empty() ? "" : ", ", count, joint::to_string(role));
  }
  console.say(fmt::format(
      "joint {}: {}", proposal.joint.empty() ? "without a name" : in_quotes(proposal.joint),
      proposal.roles.is_makeshift
          ? "no motion that a stage can use; each log is listed as a rough_sweep for now"
          : roles));
  for (const std::string& remark : proposal.effort.not_understood) console.say(remark);
  if (!proposal.moves_too.empty()) {
    console.say("others that also move: " + list_of_names(proposal.moves_too, 8));
  }
  if (!proposal.roles.without_role.empty()) {
    console.say(
        fmt::format("{} recording(s) contain nothing usable", proposal.roles.without_role.size()));
  }
}

/// What is known of the one joint. @throw UsageError: several values.
inspect::survey::ProposalOptions known_of_one(const InspectedLogs& logs) {
  inspect::survey::ProposalOptions known = logs.known;
  const auto only = [](const std::vector<double>& values, const char* option) {
    if (values.size() > 1) {
      throw UsageError(std::string(option) + ": several values are for --all-joints of init");
    }
    return values.empty() ? std::nullopt : std::optional(values.front());
  };
  known.gear_ratio = only(logs.of_joints.gear_ratios, "--gear-ratio");
  known.torque_constant_Nm_A = only(logs.of_joints.torque_constants_Nm_A, "--torque-constant");
  return known;
}

/// @return the manifest's text.
std::string propose(const InitOptions& options, const std::vector<inspect::survey::LogSurvey>& logs,
                    const inspect::survey::KnownOfJoints& of_joints, Console& console) {
  const std::string directory = std::filesystem::path(options.output).parent_path().string();
  if (!options.all_joints) {
    inspect::survey::ProposalOptions known = known_of_one(options.logs);
    known.directory = directory;
    const inspect::survey::ManifestProposal one = inspect::survey::propose_manifest(logs, known);
    tell_proposal(one, console);
    return one.text;
  }
  inspect::survey::ProposalOptions known = options.logs.known;
  known.directory = directory;
  const inspect::survey::RobotProposal robot =
      inspect::survey::propose_robot_manifest(logs, known, of_joints);
  for (const inspect::survey::ManifestProposal& joint : robot.joints) {
    tell_proposal(joint, console);
  }
  if (!robot.without_role.empty()) {
    console.say("left out, as they do not move: " + list_of_names(robot.without_role, 8));
  }
  return robot.text;
}

}  // namespace

ExitStatus run_inspect(const InspectOptions& options, Console& console) {
  const std::vector<SurveyedFile> files = files_of(options.logs.files);
  if (!options.json.empty()) check_output_can_be_written(options.json, paths_of(files));
  console.make_way_for(options.json);
  inspect::survey::KnownOfJoints of_joints = options.logs.of_joints;
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
  inspect::survey::KnownOfJoints of_joints = options.logs.of_joints;
  const std::vector<inspect::survey::LogSurvey> logs =
      survey_with_gears(files, options.logs, of_joints, console);
  const std::string text = propose(options, logs, of_joints, console);
  write_file_atomically(options.output, text);
  console.say("manifest: " + printable(options.output, 400));
  return status_of(logs);
}

namespace {

const std::map<std::string, joint::EffortKind> kinds{
    {"motor_current", joint::EffortKind::motor_current},
    {"motor_torque", joint::EffortKind::motor_torque},
    {"joint_torque", joint::EffortKind::joint_torque},
    {"target_torque", joint::EffortKind::target_torque}};
const std::map<std::string, joint::Side> sides{{"motor", joint::Side::motor},
                                               {"joint", joint::Side::joint}};

void add_unit(CLI::App& command, const std::string& option, std::optional<std::string>& unit,
              std::initializer_list<ingest::log::Quantity> quantities, const std::string& help) {
  command
      .add_option_function<std::string>(
          option,
          [&unit, option, of = std::vector(quantities)](const std::string& text) {
            unit = inspect::survey::parse_unit(option, text, of);
          },
          help)
      ->type_name("UNIT");
}

void add_inspected_logs(CLI::App& command, InspectedLogs& logs) {
  command.add_option("FILE", logs.files, "logs of any format, or folders of them")->required();
  command.add_option("--joint", logs.known.joint,
                     "name of the joint in the logs; default: the one that moves most");
  command
      .add_option("--gear-ratio", logs.of_joints.gear_ratios,
                  "motor angle / joint angle: 101 or 101:1")
      ->delimiter(',')
      ->check(number_between(1e-3, 1e6))
      ->transform(gear_ratio());
  command
      .add_option("--torque-constant", logs.of_joints.torque_constants_Nm_A,
                  "N·m per ampere, for a motor current; an effort of unknown kind counts as one")
      ->delimiter(',')
      ->check(number_between(1e-6, 1e6));
  command
      .add_option_function<std::string>(
          "--effort-kind",
          [&logs](const std::string& word) { logs.known.effort_kind = kinds.at(word); },
          "what the effort is, confirmed: motor_current, motor_torque, joint_torque, target_torque")
      ->check(one_of(kinds))
      ->type_name("KIND");
  command
      .add_option_function<std::string>(
          "--effort-side",
          [&logs](const std::string& word) { logs.known.effort_side = sides.at(word); },
          "side of the gear on which the effort acts: motor, joint")
      ->check(one_of(sides))
      ->type_name("SIDE");
  command
      .add_option_function<std::vector<std::string>>(
          "--column",
          [&logs](const std::vector<std::string>& all) {
            for (const std::string& one : all) {
              logs.known.columns.names.push_back(inspect::survey::parse_stated_column(one));
            }
          },
          "which column is which: time, angle, speed, effort or temperature (may be given again)")
      ->type_name("KEY=NAME");
  using ingest::log::Quantity;
  inspect::survey::StatedColumns& columns = logs.known.columns;
  add_unit(command, "--time-unit", columns.time_unit, {Quantity::time},
           "unit of the clock: s, ms, us, ns, or a multiple such as '0.5 ms'");
  add_unit(command, "--angle-unit", columns.angle_unit, {Quantity::angle},
           "unit of the angles: rad, deg, turn, or a multiple such as '0.088 deg'");
  add_unit(command, "--speed-unit", columns.speed_unit, {Quantity::angular_speed},
           "unit of the speeds: rad/s, deg/s, rpm, turn/s, or a multiple");
  add_unit(
      command, "--effort-unit", columns.effort_unit, {Quantity::torque, Quantity::current},
      "unit of the torque or current: Nm, A, a multiple such as '0.0013 Nm', or '% of 1.3 Nm'");
  command
      .add_option_function<std::string>(
          "--angle-side",
          [&columns](const std::string& word) { columns.angle_side = sides.at(word); },
          "side of the gear whose angle is logged: motor, joint")
      ->check(one_of(sides))
      ->type_name("SIDE");
  command
      .add_option("--rate", logs.known.columns.rate_Hz,
                  "the logs have no clock: their rows come at this rate, in Hz")
      ->check(number_between(1e-3, 1e6));
  command.add_option("--robot", logs.known.robot, "the robot's name");
  command.add_option("--serial", logs.known.serial, "its serial number");
  command.add_option("--operator", logs.known.operator_name, "who measured");
  command.add_option("--measured-on", logs.known.measured_on, "when: 2026-11-26, or with a time");
  command.add_option("--temperature", logs.known.temperature_C, "of the joint, in °C")
      ->check(number_between(-100, 300));
  command.add_flag("--no-gravity", logs.known.has_no_gravity,
                   "gravity does not turn the joint: a vertical axis, or a bare motor");
  command.add_option("--payload", logs.known.payload_kg, "mass that it carried, in kg")
      ->check(number_between(0, 1e5));
  ingest::text::TextLogRules& rules = logs.known.log_rules;
  command.add_flag_callback(
      "--decimal-comma", [&rules] { rules.decimal_mark = ingest::text::DecimalMark::comma; },
      "text logs have decimal commas");
  command
      .add_option("--header-line", rules.header_line,
                  "line with the column names, if other lines precede it")
      ->check(number_between(1, 1e9));
  command.add_flag_callback(
      "--skip-bad-rows", [&rules] { rules.skip_bad_rows = true; },
      "leave out and count damaged rows of text logs, up to 1 % of all");
  command.add_flag_callback(
      "--latin1", [&rules] { rules.encoding = ingest::text::TextEncoding::latin1; },
      "names in text logs are in Latin-1, not UTF-8");
}

}  // namespace

CLI::App& add_inspect(CLI::App& app, InspectOptions& inspect) {
  CLI::App& command = *app.add_subcommand(
      "inspect", "what a log contains: columns, clock, motion, a manifest for it");
  add_inspected_logs(command, inspect.logs);
  command.add_option("--json", inspect.json, "file for the full result (JSON)");
  command.footer(
      "\nGuesses are marked as such. Speeds are slopes of the angle between marks of its "
      "travel;\nthe logged speed is not trusted. A log that is refused does not prevent the others "
      "from\nbeing shown; the exit status is 3 then.");
  return command;
}

CLI::App& add_init(CLI::App& app, InitOptions& init) {
  CLI::App& command = *app.add_subcommand("init", "write the manifest that inspect proposes");
  add_inspected_logs(command, init.logs);
  command.add_option("-o,--output", init.output, "manifest (TOML) to write")->required();
  command
      .add_flag("--all-joints", init.all_joints,
                "a manifest of the whole robot, with every joint that moves in the logs")
      ->excludes("--joint");
  command.add_flag("--force", init.force, "replace an existing manifest");
  command.footer(
      "\nWith --all-joints, --gear-ratio and --torque-constant take one value for all joints, or "
      "one for\neach in the order of the logs, separated by commas.\nGear ratio and torque "
      "constant are rarely in a log: state them here, or in the file.\nIts "
      "comments say what was guessed.");
  return command;
}

}  // namespace tribolog::cli
