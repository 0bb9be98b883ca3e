#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "calibration/provenance.h"
#include "cli/commands.h"
#include "cli/drawing.h"
#include "cli/identification.h"
#include "cli/robot_commands.h"
#include "cli/robot_joints.h"
#include "cli/shared_options.h"
#include "tribolog/figures.h"
#include "tribolog/report.h"

namespace tribolog::cli {
namespace {

/// report.html -> report.calibration.json
std::string calibration_beside(const std::string& report) {
  const std::size_t slash = report.find_last_of('/');
  const std::size_t dot = report.find_last_of('.');
  const bool has_ending =
      dot != std::string::npos && (slash == std::string::npos || dot > slash + 1);
  return (has_ending ? report.substr(0, dot) : report) + ".calibration.json";
}

std::string calibration_of(const ReportOptions& options) {
  if (!options.calibration.empty()) return options.calibration;
  if (is_file_output(options.output)) return calibration_beside(options.output);
  throw UsageError(
      "tribolog report: no file can be placed next to standard output, a pipe or a device; "
      "--calibration FILE states where the numbers go");
}

ExitStatus run_report(const ReportOptions& stated, const std::vector<std::string>& arguments,
                      Console& console) {
  ReportOptions options = stated;
  for (const std::string& output : {options.output, options.calibration}) {
    console.make_way_for(output);
  }
  const FoundData found = find_data(stated.given, stated.output, console);
  options.dataset = found.dataset;
  options.output =
      output_or_beside(stated.output, found, joints_to_do(options.dataset).empty() ? ".html" : "");
  if (const auto joints = joints_to_do(options.dataset); !joints.empty()) {
    return report_robot(options, joints, arguments, console);
  }
  const std::string numbers = calibration_of(options);
  for (const std::string& output : {options.output, numbers}) {
    check_output_can_be_written(output, {options.dataset.manifest, options.archiving.file()});
  }
  check_outputs_differ({options.output, numbers});
  static_cast<void>(calibration::make_provenance({}));  // a time that cannot be used is refused now
  Archiving archiving(options.archiving);

  std::optional<Renderer> renderer;  // starts while the numbers are computed
  if (options.figures) {
    renderer.emplace(RendererOptions{options.processes, options.dataset.manifest});
  }
  const Dataset dataset = load_dataset(options.dataset, console);
  protect_inputs(dataset, options.output);
  protect_inputs(dataset, numbers);
  const Calibration calibration =
      run_identification(dataset, {options.seed, options.truth_runs, arguments}, console);
  AtomicFiles files;
  files.add(numbers, calibration.to_json());
  const std::string id =
      archiving.keep_numbers({calibration.to_json(), numbers}, options.dataset.manifest, console);

  const Report report = make_report(
      calibration, {options.language.code, archiving.since_last(id), id, progress_on(console)},
      renderer ? &*renderer : nullptr);
  files.add(options.output, report.html);
  archiving.keep_report(id, report.html, console);
  files.commit();
  tell_outcome(calibration, console);
  console.say("calibration: " + printable(numbers, longest_path));
  console.say("report: " + printable(options.output, longest_path));
  tell_what_is_open(found, arguments, console);
  if (tell_failures(report.figures, console) > 0) return ExitStatus::figure_failed;
  return status_of(calibration, options.fail_on);
}

}  // namespace

Run add_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App& command = *app.add_subcommand("report", "identify, draw, and write one HTML report");
  add_given_data(command, options->given);
  command
      .add_option("-o,--output", options->output,
                  "report (HTML) to write; default: beside the input")
      ->check(page_file());
  command.add_option("--calibration", options->calibration,
                     "where to write the numbers (JSON); default: next to the report");
  command.add_flag_callback(
      "--no-figures", [options] { options->figures = false; }, "numbers and tables only");
  add_truth_runs(command, options->truth_runs);
  add_fail_on(command, options->fail_on);
  add_seed(command, options->seed);
  add_archiving(command, options->archiving);
  add_processes(command, options->processes);
  add_language(command, options->language);
  command.footer(
      std::string("\nOf logs it proposes the manifest and writes it too: tribolog report log.csv.\n"
                  "Report and numbers replace older ones together, once both are on disk;\nif "
                  "one cannot be written, both old ones remain. With --archive the archive keeps "
                  "the\nnumbers before figures are drawn, whatever happens to the files.\n-o - is "
                  "standard output; --calibration then states where the numbers go.\n") +
      manifest_help());
  return [options](const Invocation& call) {
    return run_report(*options, call.arguments, call.console);
  };
}

}  // namespace tribolog::cli
