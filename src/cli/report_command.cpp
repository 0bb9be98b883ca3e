#include <optional>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "calibration/calibration_json.h"
#include "cli/commands.h"
#include "cli/drawing.h"
#include "cli/identification.h"
#include "figures/figure_csv.h"
#include "figures/figure_set.h"
#include "paper/scenes/scene_figures.h"
#include "report/html_report.h"

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
      "tribolog report: nothing can stand beside standard output, a pipe or a device; "
      "--calibration FILE states where the numbers go");
}

}  // namespace

ExitStatus run_report(const ReportOptions& options, const std::vector<std::string>& arguments,
                      Console& console) {
  const std::string numbers = calibration_of(options);
  for (const std::string& output : {options.output, numbers}) {
    check_output_can_be_written(output, {options.dataset, options.archiving.file()});
    console.make_way_for(output);
  }
  check_outputs_differ({options.output, numbers});
  calibration::Provenance provenance = calibration::make_provenance(arguments);
  Archiving archiving(options.archiving);

  std::optional<render::workers::FigureRenderer> renderer;  // starts while the numbers are computed
  if (options.figures) renderer.emplace(options.processes, drawings_of(options.dataset));
  const joint::Dataset dataset = load_dataset(options.dataset, console);
  protect_inputs(dataset, options.dataset, options.output);
  protect_inputs(dataset, options.dataset, numbers);
  const calibration::Calibration calibration =
      run_identification(dataset, {options.intervals, options.truth_runs}, console);
  provenance.configuration = interval_configuration(calibration.intervals);
  const std::string json = calibration::calibration_json(calibration, provenance);
  AtomicFiles files;
  files.add(numbers, json);
  archiving.keep_numbers(json, numbers, options.dataset, console);
  const std::optional<history::Comparison> since_last = archiving.since_last();
  if (!archiving.id().empty()) {
    provenance.configuration.push_back(
        {{"setting.archived_as"}, Statement::verbatim(archiving.id())});
  }

  std::vector<figures::ReportFigure> figures;
  std::vector<render::workers::DrawnFigure> drawn;
  if (renderer) {
    figures = figures::figures_in(options.language, [&] {
      return paper::scenes::with_scene_figures(figures::figure_set(dataset, calibration),
                                               dataset.robot.get(), calibration);
    });
    drawn = draw(*renderer, figures, console);
    provenance.drawing = software_that_drew(drawn);
  }
  console.progress("writing the report", 1, 1);
  const std::string html =
      report::html_report(calibration, figures, drawn, provenance, since_last, options.language);
  files.add(options.output, html);
  archiving.keep_report(html, console);
  files.commit();
  tell_outcome(calibration, console);
  console.say("calibration: " + printable(numbers, longest_path));
  console.say("report: " + printable(options.output, longest_path));
  if (tell_failures(drawn, console) > 0) return ExitStatus::figure_failed;
  return status_of(calibration, options.fail_on);
}

}  // namespace tribolog::cli
