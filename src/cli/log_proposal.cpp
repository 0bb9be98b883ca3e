#include "cli/log_proposal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "cli/shared_options.h"

namespace tribolog::cli {

namespace {

/// What a recorder wrote as a whole: rosbag2, or LeRobot.
bool is_recorders_folder(const std::string& path) {
  namespace fs = std::filesystem;
  return fs::exists(fs::path(path) / "metadata.yaml") ||
         fs::exists(fs::path(path) / "meta" / "info.json");
}

}  // namespace

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

namespace {

/// Surveys the logs in their order, those of a set of files as one. One that is refused is reported
/// at once, and the others go on.
class LogsInOrder {
 public:
  LogsInOrder(const std::vector<SurveyedFile>& files, const InspectedLogs& options,
              const inspect::survey::StatedColumns& stated, Console& console)
      : files_(files), options_(options), stated_(stated), console_(console) {}

  /// @throw InputError of the only log, or of the first one if all are refused.
  std::vector<inspect::survey::LogSurvey> survey() {
    for (const inspect::survey::FileSet& set : inspect::survey::sets_of_files(paths_of(files_))) {
      add_set(set);
    }
    console_.finish();
    const bool all_refused =
        std::all_of(logs_.begin(), logs_.end(),
                    [](const inspect::survey::LogSurvey& log) { return !log.refusal.empty(); });
    if (first_ && all_refused) throw InputError(*first_);
    return std::move(logs_);
  }

 private:
  void add_set(const inspect::survey::FileSet& set) {
    if (!set.beside.empty()) {
      auto log = inspect::survey::survey_set(set, options_.known.log_rules, stated_);
      if (log) {
        logs_.push_back(std::move(*log));
        return;
      }
    }
    add(set.path);
    for (const inspect::survey::FileOfQuantity& one : set.beside) add(one.path);
  }

  void add(const std::string& path) {
    console_.progress("reading the logs", logs_.size(), files_.size());
    try {
      logs_.push_back(inspect::survey::survey_log(path, options_.known.log_rules, stated_));
    } catch (const InputError& error) {
      if (!first_) first_ = error;
      const auto file = std::find_if(files_.begin(), files_.end(),
                                     [&](const SurveyedFile& one) { return one.path == path; });
      if (!file->is_named) {
        console_.warn(std::string("note: not used: ") + error.what());
        return;
      }
      logs_.emplace_back();
      logs_.back().file = path;
      logs_.back().refusal = error.what();
      if (files_.size() > 1) console_.warn(std::string("error: ") + error.what());
    }
  }

  const std::vector<SurveyedFile>& files_;
  const InspectedLogs& options_;
  const inspect::survey::StatedColumns& stated_;
  Console& console_;
  std::vector<inspect::survey::LogSurvey> logs_;
  std::optional<InputError> first_;
};

std::vector<inspect::survey::LogSurvey> survey_logs(const std::vector<SurveyedFile>& files,
                                                    const InspectedLogs& options,
                                                    const inspect::survey::StatedColumns& stated,
                                                    Console& console) {
  return LogsInOrder(files, options, stated, console).survey();
}

/// What the user says that the effort is: with a torque constant alone, a current.
std::optional<ingest::log::Quantity> stated_effort(const std::optional<joint::EffortKind>& kind,
                                                   const std::vector<double>& torque_constants) {
  using ingest::log::Quantity;
  if (kind) {
    return *kind == joint::EffortKind::motor_current ? Quantity::current : Quantity::torque;
  }
  return torque_constants.empty() ? std::nullopt : std::optional(Quantity::current);
}

}  // namespace

std::vector<inspect::survey::LogSurvey> survey_with_gears(const std::vector<SurveyedFile>& files,
                                                          const InspectedLogs& options,
                                                          inspect::survey::StatedJoints& of_joints,
                                                          Console& console) {
  inspect::survey::StatedColumns stated = options.known.columns;
  stated.effort_is = stated_effort(options.known.effort_kind, of_joints.torque_constants_Nm_A);
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

ExitStatus status_of(const std::vector<inspect::survey::LogSurvey>& logs) {
  const bool one_refused =
      std::any_of(logs.begin(), logs.end(),
                  [](const inspect::survey::LogSurvey& log) { return !log.refusal.empty(); });
  return one_refused ? ExitStatus::input_refused : ExitStatus::done;
}

namespace {

/// Columns of a known quantity in a unit that is not known: left out, and said.
void tell_foreign_units(const std::vector<inspect::survey::LogSurvey>& logs, Console& console) {
  std::vector<std::string> lines;
  for (const inspect::survey::LogSurvey& log : logs) {
    for (const inspect::survey::TableSurvey& table : log.tables) {
      for (const ingest::layout::ForeignUnit& foreign : table.foreign) {
        std::string line = inspect::survey::foreign_unit_in_words(table, foreign);
        if (std::find(lines.begin(), lines.end(), line) == lines.end())
          lines.push_back(std::move(line));
      }
    }
  }
  for (const std::string& line : lines) console.say(line);
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
  for (const std::string& unit : proposal.only_proposed)
    console.say("proposed, not confirmed: " + unit);
  if (!proposal.moves_too.empty()) {
    console.say("others that also move: " + list_of_names(proposal.moves_too, 8));
  }
  if (!proposal.roles.without_role.empty()) {
    console.say(
        fmt::format("{} recording(s) contain nothing usable", proposal.roles.without_role.size()));
  }
}

}  // namespace

inspect::survey::ProposalOptions known_of_one(const InspectedLogs& logs) {
  inspect::survey::ProposalOptions known = logs.known;
  const auto only = [](const std::vector<double>& values, const char* option) {
    if (values.size() > 1) {
      throw UsageError(
          fmt::format("{}: {} values for one joint; several are for --all-joints, and a decimal "
                      "has a point: 1.5",
                      option, values.size()));
    }
    return values.empty() ? std::nullopt : std::optional(values.front());
  };
  known.gear_ratio = only(logs.of_joints.gear_ratios, "--gear-ratio");
  known.torque_constant_Nm_A = only(logs.of_joints.torque_constants_Nm_A, "--torque-constant");
  return known;
}

ProposedManifest propose(const InspectedLogs& of, bool all_joints, const std::string& directory,
                         const std::vector<inspect::survey::LogSurvey>& logs,
                         const inspect::survey::StatedJoints& of_joints, Console& console) {
  tell_foreign_units(logs, console);
  if (!all_joints) {
    inspect::survey::ProposalOptions known = known_of_one(of);
    known.directory = directory;
    const inspect::survey::ManifestProposal one = inspect::survey::propose_manifest(logs, known);
    tell_proposal(one, console);
    return {one.text, one.open};
  }
  inspect::survey::ProposalOptions known = of.known;
  known.directory = directory;
  const inspect::survey::RobotProposal robot =
      inspect::survey::propose_robot_manifest(logs, known, of_joints);
  ProposedManifest proposed{robot.text, {}};
  for (const inspect::survey::ManifestProposal& joint : robot.joints) {
    tell_proposal(joint, console);
    for (const std::string& open : joint.open) {
      const auto& known_open = proposed.open;
      const bool is_new = std::find(known_open.begin(), known_open.end(), open) == known_open.end();
      if (is_new) proposed.open.push_back(open);
    }
  }
  if (!robot.without_role.empty()) {
    console.say("left out, as they do not move: " + list_of_names(robot.without_role, 8));
  }
  return proposed;
}

namespace {

const std::map<std::string, joint::EffortKind> kinds{
    {"motor_current", joint::EffortKind::motor_current},
    {"motor_torque", joint::EffortKind::motor_torque},
    {"joint_torque", joint::EffortKind::joint_torque},
    {"target_torque", joint::EffortKind::target_torque}};
const std::map<std::string, joint::Side> sides{{"motor", joint::Side::motor},
                                               {"joint", joint::Side::joint}};

/// "38@0": 38 N·m, largest at 0°. @throw UsageError
std::pair<double, double> parse_known_gravity(const std::string& text) {
  double torque_Nm = 0;
  double peak_deg = 0;
  int read = 0;
  const int found = std::sscanf(text.c_str(), "%lf@%lf%n", &torque_Nm, &peak_deg, &read);
  const bool is_one = found == 2 && static_cast<std::size_t>(read) == text.size() &&
                      std::isfinite(torque_Nm) && std::isfinite(peak_deg) && torque_Nm > 0;
  if (is_one) return {torque_Nm, peak_deg};
  throw UsageError("--known-gravity '" + printable(text) +
                   "': N·m and the joint angle in degrees where they are largest, as 38@0");
}

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

}  // namespace

void add_known_of_logs(CLI::App& command, InspectedLogs& logs) {
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
          "side of the gear on which the effort, or a current's torque constant, acts: motor, "
          "joint")
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
  command.add_flag("--signed-registers", logs.known.registers_are_confirmed,
                   "registers that were logged without their sign are read as is proposed");
  command.add_flag("--no-gravity", logs.known.has_no_gravity,
                   "gravity does not turn the joint: a vertical axis, or a bare motor");
  command
      .add_option_function<std::string>(
          "--known-gravity",
          [&logs](const std::string& text) {
            logs.known.known_gravity_Nm_deg = parse_known_gravity(text);
          },
          "gravity's torque at the joint by its design, in N·m, and the angle where it is largest")
      ->type_name("NM@DEG");
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

}  // namespace tribolog::cli
