#include <string_view>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/drawing.h"
#include "cli/identification.h"
#include "figures/figure_set.h"
#include "files/atomic_file.h"
#include "paper/scenes/scene_figures.h"

namespace tribolog {

ExitStatus run_figures(const FiguresOptions& options, Console& console) {
  // Starts while the numbers are computed.
  render::FigureRenderer renderer(options.processes, drawings_of(options.dataset));
  const Dataset dataset = load_dataset(options.dataset, console);
  create_directory(options.directory);
  const Calibration calibration = run_identification(dataset, {{}, options.truth_runs}, console);
  const std::vector<ReportFigure> figures =
      with_scene_figures(figure_set(dataset, calibration), dataset.robot.get(), calibration);
  const std::vector<render::DrawnFigure> drawn = draw(renderer, figures, console);
  AtomicFiles files;
  std::size_t written = 0;
  for (const render::DrawnFigure& figure : drawn) {
    if (!figure.error.empty()) continue;
    const std::string_view bytes(reinterpret_cast<const char*>(figure.png.data()),
                                 figure.png.size());
    files.add(options.directory + "/" + figure.id + ".png", bytes);
    ++written;
  }
  files.commit();
  console.say(fmt::format("{}: {} figures", options.directory, written));
  for (const StageReport& stage : calibration.stages()) {
    if (stage.state != StageState::done) {
      console.say(fmt::format("  {}: {}", stage.name, stage.reason));
    }
  }
  return tell_failures(drawn, console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

}  // namespace tribolog
