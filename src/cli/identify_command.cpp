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

namespace {

constexpr const char* manifest_help = R"(
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

}  // namespace

CLI::App& add_identify(CLI::App& app, IdentifyArguments& identify) {
  CLI::App& command =
      *app.add_subcommand("identify", "identify a joint: numbers with intervals, as JSON");
  add_given_data(command, identify.given);
  command.add_option("-o,--output", identify.output,
                     "calibration file (JSON) to write; default: beside the input");
  add_truth_runs(command, identify.truth_runs);
  add_fail_on(command, identify.fail_on);
  add_seed(command, identify.seed);
  add_archiving(command, identify.archiving);
  command.footer(manifest_help);
  return command;
}

CLI::App& add_report(CLI::App& app, ReportOptions& report) {
  CLI::App& command = *app.add_subcommand("report", "identify, draw, and write one HTML report");
  add_given_data(command, report.given);
  command
      .add_option("-o,--output", report.output, "report (HTML) to write; default: beside the input")
      ->check(page_file());
  command.add_option("--calibration", report.calibration,
                     "where to write the numbers (JSON); default: next to the report");
  command.add_flag_callback(
      "--no-figures", [&report] { report.figures = false; }, "numbers and tables only");
  add_truth_runs(command, report.truth_runs);
  add_fail_on(command, report.fail_on);
  add_seed(command, report.seed);
  add_archiving(command, report.archiving);
  add_processes(command, report.processes);
  add_language(command, report.language);
  command.footer(
      std::string("\nOf logs it proposes the manifest and writes it too: tribolog report log.csv.\n"
                  "Report and numbers replace older ones together, once both are on disk;\nif "
                  "one cannot be written, both old ones remain. With --archive the archive keeps "
                  "the\nnumbers before figures are drawn, whatever happens to the files.\n-o - is "
                  "standard output; --calibration then states where the numbers go.\n") +
      manifest_help);
  return command;
}

}  // namespace tribolog::cli
