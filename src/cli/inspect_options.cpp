#include <map>
#include <string>

#include "cli/command_options.h"
#include "cli/shared_options.h"

namespace tribolog {
namespace {

const std::map<std::string, Side> sides{{"motor", Side::motor}, {"joint", Side::joint}};

void add_inspected_logs(CLI::App& command, InspectedLogs& logs) {
  command.add_option("FILE", logs.files, "logs of any format")->required();
  command.add_option("--joint", logs.known.joint,
                     "the joint, by its name in the logs; default: the one "
                     "that moves most");
  command.add_option("--gear-ratio", logs.known.gear_ratio, "motor angle / joint angle")
      ->check(number_between(1e-3, 1e6));
  command
      .add_option("--torque-constant", logs.known.torque_constant_Nm_A,
                  "N·m per ampere, of a motor current")
      ->check(number_between(1e-6, 1e6));
  command
      .add_option_function<std::string>(
          "--effort-side",
          [&logs](const std::string& word) { logs.known.effort_side = sides.at(word); },
          "side of the gear on which the effort acts: motor, joint")
      ->check(CLI::IsMember(sides))
      ->type_name("SIDE");
  command.add_option("--robot", logs.known.robot, "the robot's name");
  TextLogRules& rules = logs.known.log_rules;
  command.add_flag_callback(
      "--decimal-comma", [&rules] { rules.decimal_mark = DecimalMark::comma; },
      "text logs have decimal commas");
  command
      .add_option("--header-line", rules.header_line,
                  "line of the columns' names, where others stand in front of it")
      ->check(number_between(1, 1e9));
  command.add_flag_callback(
      "--latin1", [&rules] { rules.encoding = TextEncoding::latin1; },
      "names in text logs are in Latin-1, not UTF-8");
}

}  // namespace

CLI::App& add_inspect(CLI::App& app, InspectOptions& inspect) {
  CLI::App& command =
      *app.add_subcommand("inspect", "what a log holds: columns, clock, motion, a manifest for it");
  add_inspected_logs(command, inspect.logs);
  command.add_option("--json", inspect.json, "file for all of it (JSON)");
  command.footer(
      "\nGuesses are marked as such. Speeds are slopes of the angle between marks of its travel;\n"
      "the logged speed is not trusted. A log that is refused does not keep the others from\n"
      "being shown; the exit status is 3 then.");
  return command;
}

CLI::App& add_init(CLI::App& app, InitOptions& init) {
  CLI::App& command = *app.add_subcommand("init", "write the manifest that inspect proposes");
  add_inspected_logs(command, init.logs);
  command.add_option("-o,--output", init.output, "manifest (TOML) to write")->required();
  command.add_flag("--force", init.force, "replace a manifest that exists");
  command.footer(
      "\nGear ratio and torque constant are seldom in a log: state them here, or in the file.\n"
      "Its comments say what was guessed.");
  return command;
}

}  // namespace tribolog
