#include <memory>
#include <string>

#include "base/atomic_file.h"
#include "calibration/provenance.h"
#include "cli/archiving.h"
#include "cli/commands.h"
#include "cli/identification.h"
#include "cli/robot_commands.h"
#include "cli/robot_joints.h"
#include "cli/shared_options.h"

namespace tribolog::cli {

namespace {

ExitStatus run_identify(const IdentifyArguments& stated, const std::vector<std::string>& arguments,
                        Console& console) {
  IdentifyArguments options = stated;
  console.make_way_for(options.output);
  const FoundData found = find_data(stated.given, stated.output, console);
  options.dataset = found.dataset;
  options.output = output_or_beside(
      stated.output, found, joints_to_do(options.dataset).empty() ? ".calibration.json" : "");
  if (const auto joints = joints_to_do(options.dataset); !joints.empty()) {
    return identify_robot(options, joints, arguments, console);
  }
  check_output_can_be_written(options.output, {options.dataset.manifest, options.archiving.file()});
  console.make_way_for(options.output);
  static_cast<void>(calibration::make_provenance({}));  // a time that cannot be used is refused now
  Archiving archiving(options.archiving);
  const Dataset dataset = load_dataset(options.dataset, console);
  protect_inputs(dataset, options.output);
  const Calibration calibration =
      run_identification(dataset, {options.seed, options.truth_runs, arguments}, console);
  AtomicFiles files;
  files.add(options.output, calibration.to_json());
  archiving.keep_numbers({calibration.to_json(), options.output}, options.dataset.manifest,
                         console);
  files.commit();
  tell_outcome(calibration, console);
  console.say("calibration: " + printable(options.output, longest_path));
  tell_what_is_open(found, arguments, console);
  return status_of(calibration, options.fail_on);
}

}  // namespace

Run add_identify(CLI::App& app) {
  const auto options = std::make_shared<IdentifyArguments>();
  CLI::App& command =
      *app.add_subcommand("identify", "identify a joint: numbers with intervals, as JSON");
  add_given_data(command, options->given);
  command.add_option("-o,--output", options->output,
                     "calibration file (JSON) to write; default: beside the input");
  add_truth_runs(command, options->truth_runs);
  add_fail_on(command, options->fail_on);
  add_seed(command, options->seed);
  add_archiving(command, options->archiving);
  command.footer(manifest_help());
  return [options](const Invocation& call) {
    return run_identify(*options, call.arguments, call.console);
  };
}

}  // namespace tribolog::cli
