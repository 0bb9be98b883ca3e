#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/drawing.h"
#include "cli/figure_files.h"
#include "cli/identification.h"
#include "figures/figure_language.h"
#include "figures/figure_set.h"
#include "paper/scenes/scene_figures.h"

namespace tribolog {
namespace {

/// Charts in vector formats alone need no graphics stack, and none is started for them.
bool needs_pictures(const std::vector<FigureFormat>& formats, render::Prepared drawings) {
  return drawings == render::Prepared::charts_and_scenes ||
         std::find(formats.begin(), formats.end(), FigureFormat::png) != formats.end();
}

std::string listed_formats(const std::vector<FigureFormat>& formats) {
  std::string out;
  for (const FigureFormat one : formats) {
    out += fmt::format("{}{}", out.empty() ? "" : ", ", ending_of(one));
  }
  return out;
}

}  // namespace

ExitStatus run_figures(const FiguresOptions& options, Console& console) {
  std::optional<render::FigureRenderer> renderer;
  const render::Prepared drawings = drawings_of(options.dataset);
  // Starts while the numbers are computed.
  if (needs_pictures(options.formats, drawings)) renderer.emplace(options.processes, drawings);
  const Dataset dataset = load_dataset(options.dataset, console);
  AtomicFiles files;
  files.make_directory(options.directory);
  const Calibration calibration = run_identification(dataset, {{}, options.truth_runs}, console);
  std::vector<ReportFigure> figures =
      with_scene_figures(figure_set(dataset, calibration), dataset.robot.get(), calibration);
  for (ReportFigure& one : figures) one = as_file_in_language(std::move(one), options.language);
  if (options.style == FigureStyleChoice::paper) figures = for_publication(std::move(figures));
  const FigureFiles drawn =
      figure_files(figures, options.formats, renderer ? &*renderer : nullptr, console);
  for (const FigureFile& one : drawn.files)
    files.add(options.directory + "/" + one.name, one.bytes);
  files.commit();
  console.say(fmt::format("{}: {} figures as {}", options.directory, drawn.whole,
                          listed_formats(options.formats)));
  for (const StageReport& stage : calibration.stages()) {
    if (stage.state != StageState::done) {
      console.say(fmt::format("  {}: {}", stage.name, stage.reason));
    }
  }
  return tell_failures(drawn.drawn, console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

}  // namespace tribolog
