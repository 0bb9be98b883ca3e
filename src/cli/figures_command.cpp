#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/drawing.h"
#include "cli/identification.h"
#include "cli/robot_commands.h"
#include "cli/robot_joints.h"
#include "cli/shared_options.h"
#include "tribolog/figures.h"
#include "tribolog/files.h"

namespace tribolog::cli {

namespace {

const std::map<std::string, FigureFormat> figure_formats{
    {"png", FigureFormat::png}, {"svg", FigureFormat::svg}, {"pdf", FigureFormat::pdf}};
const std::map<std::string, FigureStyle> figure_styles{{"report", FigureStyle::report},
                                                       {"paper", FigureStyle::paper}};

std::string listed_formats(const std::vector<FigureFormat>& formats) {
  std::string out;
  for (const FigureFormat one : formats) {
    const auto named = std::find_if(figure_formats.begin(), figure_formats.end(),
                                    [&](const auto& known) { return known.second == one; });
    out += (out.empty() ? "" : ", ") + named->first;
  }
  return out;
}

/// The stages by their names in the calibration.
std::string stage_in_words(const std::string& name) {
  static const std::map<std::string, std::string> words{
      {"cog_rough", "centre of gravity, rough sweep"},
      {"cog_precise", "centre of gravity, precise sweep"},
      {"hysteresis", "friction hysteresis"},
      {"surrogate_masses", "surrogate masses"},
      {"viscous_curves", "viscous curves"},
      {"quality_errors", "quality errors"},
      {"break_away", "break-away ramps"},
      {"friction_parameters", "friction parameters"}};
  const auto found = words.find(name);
  return found == words.end() ? name : found->second;
}

}  // namespace

ExitStatus run_figures(const FiguresOptions& options, Console& console) {
  if (const auto joints = joints_to_do(options.dataset); !joints.empty()) {
    return draw_robot(options, joints, console);
  }
  std::optional<Renderer> renderer;
  // Starts while the numbers are computed.
  if (needs_renderer(options.dataset.manifest, options.formats)) {
    renderer.emplace(RendererOptions{options.processes, options.dataset.manifest});
  }
  const Dataset dataset = load_dataset(options.dataset, console);
  AtomicFiles files;
  files.make_directory(options.directory);
  const Calibration calibration =
      run_identification(dataset, {{}, options.truth_runs, {}}, console);
  const Figures figures = draw_figures(
      calibration, {options.formats, options.style, options.language.code, progress_on(console)},
      renderer ? &*renderer : nullptr);
  for (const File& one : figures.files) files.add(options.directory + "/" + one.name, one.bytes);
  files.commit();
  console.say(fmt::format("{}: {} figures as {}", options.directory, figures.drawn(),
                          listed_formats(options.formats)));
  for (const Stage& stage : calibration.stages()) {
    if (stage.state != Stage::State::done) {
      console.say(fmt::format("  {}: {}", stage_in_words(stage.name), stage.reason.words));
    }
  }
  return tell_failures(figures.outcomes, console) > 0 ? ExitStatus::figure_failed
                                                      : ExitStatus::done;
}

Run add_figures(CLI::App& app) {
  const auto options = std::make_shared<FiguresOptions>();
  CLI::App& command = *app.add_subcommand("figures", "draw the figures as PNG, SVG or PDF files");
  add_dataset(command, options->dataset);
  command.add_option("-o,--output", options->directory, "directory to write to")->required();
  command
      .add_option_function<std::vector<std::string>>(
          "--format",
          [options](const std::vector<std::string>& names) {
            options->formats.clear();
            for (const auto& [name, format] : figure_formats) {
              if (std::find(names.begin(), names.end(), name) != names.end()) {
                options->formats.push_back(format);
              }
            }
          },
          "png (the default), svg, pdf: one or more, separated by commas")
      ->delimiter(',')
      ->check(one_of(figure_formats))
      ->type_name("FORMAT");
  command
      .add_option_function<std::string>(
          "--style",
          [options](const std::string& name) { options->style = figure_styles.at(name); },
          "report (the default): 160 mm wide; paper: 84 or 174 mm, for a journal's columns")
      ->check(one_of(figure_styles))
      ->type_name("STYLE");
  add_truth_runs(command, options->truth_runs);
  add_processes(command, options->processes);
  add_language(command, options->language);
  command.footer(
      "\n--check adds the figure of the known-truth check, as in a report.\nSVG and PDF "
      "keep text as text and embed the glyphs they use. Charts in them need no\ngraphics stack; "
      "the solid parts of the robot's drawings are a picture below the lines.\n--style paper "
      "leaves the title to the caption; letters are 7 to 8 pt in print.");
  return [options](const Invocation& call) { return run_figures(*options, call.console); };
}

}  // namespace tribolog::cli
