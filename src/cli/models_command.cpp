#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/drawing.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/drawing.h"
#include "cli/shared_options.h"
#include "figures/experiments/model_figures.h"
#include "figures/figure_csv.h"
#include "friction/catalogue.h"
#include "report/experiments/models_page.h"
#include "wording/words.h"

namespace tribolog::cli {
namespace {

struct ModelsOptions {
  bool compare{false};  ///< All of them side by side, in one page; else the list on the console.
  std::string output;   ///< That page (HTML): one is not without the other.
  int processes{2};
  wording::Language language;
};

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none of it" : fmt::format("{}", fmt::join(words, ", "));
}

std::string shown_by(const friction::FrictionTraits& traits) {
  std::vector<std::string> words;
  const auto add = [&](bool shows, const char* word) {
    if (shows) words.emplace_back(word);
  };
  add(traits.presliding, "pre-sliding");
  add(traits.break_away, "break-away torque above Coulomb torque");
  add(traits.stribeck, "Stribeck effect");
  add(traits.lag, "frictional lag");
  add(traits.non_local_memory, "non-local memory");
  return joined(words);
}

std::string limits_of(const friction::FrictionTraits& traits) {
  std::vector<std::string> words;
  if (traits.drifts) words.emplace_back("drifts under an oscillating torque below break-away");
  if (traits.rate_independent) words.emplace_back("rate independent");
  if (traits.is_random) words.emplace_back("random");
  if (traits.remembers_rest) words.emplace_back("sliding torque depends on the rest before it");
  return words.empty() ? "" : fmt::format("\n    {}", fmt::join(words, "; "));
}

/// @param model as files say it.
std::string parameter_lines(const std::string& model, const friction::NamedParameters& parameters) {
  std::string lines;
  for (const friction::NamedParameter& one : parameters) {
    const double* number = std::get_if<double>(&one.value);
    const auto* count = std::get_if<std::uint64_t>(&one.value);
    const std::string usual = !one.has_usual      ? ""
                              : number != nullptr ? fmt::format(" [{:g}]", *number)
                              : count != nullptr  ? fmt::format(" [{}]", *count)
                                                  : "";
    lines += fmt::format("      {:<27}{}{}\n", one.key,
                         wording::words_for("parameter." + model, one.key), usual);
  }
  return lines;
}

std::string heading_of(const std::string& model) {
  return fmt::format("{:<18}{} ({})", model, wording::words_for("friction_model", model),
                     wording::words_for("friction_source", model));
}

void list_models(Console& console) {
  console.say(
      "dynamic friction models, by their name in a scenario (friction.model), and their "
      "own\nparameters (table [friction.<model>], each matched to [friction.presliding] if not "
      "stated):\n");
  for (const friction::FrictionModelEntry& one : friction::dynamic_friction_models()) {
    console.say(fmt::format("  {}\n    shows {}{}\n{}", heading_of(one.name), shown_by(one.traits),
                            limits_of(one.traits), parameter_lines(one.name, one.parameters)));
  }
  console.say(
      "static laws for sweeps and runs at constant speed (friction.sliding.model), in table\n"
      "[friction.sliding]; \"dynamic\" is the dynamic model there too:\n");
  for (const friction::StaticLawEntry& one : friction::static_friction_laws()) {
    console.say(
        fmt::format("  {}\n{}", heading_of(one.name), parameter_lines(one.name, one.parameters)));
  }
  console.say("[ ]: the default, where neither the file nor a match gives one");
}

std::vector<figures::experiments::ModelExperiment> experiments_in(
    const wording::Language& language, const friction::ContactParameters& contact) {
  const wording::WordsIn words(language);
  return figures::experiments::model_experiments(contact);
}

std::vector<figures::ReportFigure> figures_of(
    const std::vector<figures::experiments::ModelExperiment>& experiments) {
  std::vector<figures::ReportFigure> all;
  for (const figures::experiments::ModelExperiment& one : experiments) {
    all.insert(all.end(), one.figures.begin(), one.figures.end());
  }
  return all;
}

ExitStatus run_models(const ModelsOptions& options, const std::vector<std::string>& arguments,
                      Console& console) {
  if (options.compare == options.output.empty()) {
    throw UsageError("tribolog models: --compare and -o FILE go together; see its --help");
  }
  if (!options.compare) {
    list_models(console);
    return ExitStatus::done;
  }
  check_output_can_be_written(options.output);
  console.make_way_for(options.output);
  calibration::Provenance provenance = calibration::make_provenance(arguments);
  render::workers::FigureRenderer renderer(
      options.processes);  // starts while the models are computed
  console.progress("simulating the models", 0, 1);
  const friction::ContactParameters contact;
  std::vector<figures::experiments::ModelExperiment> experiments =
      experiments_in(options.language, contact);
  if (!options.language.is_english()) {
    const std::vector<figures::ReportFigure> english =
        figures_of(experiments_in(wording::Language{}, contact));
    for (figures::experiments::ModelExperiment& one : experiments) {
      figures::take_english_data(english, one.figures);
    }
  }
  const std::vector<figures::ReportFigure> figures = figures_of(experiments);
  const std::vector<render::workers::DrawnFigure> drawn = draw(renderer, figures, console);
  provenance.drawing = api::software_that_drew(drawn);
  write_file_atomically(
      options.output,
      report::experiments::models_page(contact, experiments, drawn, provenance, options.language));
  console.say("comparison: " + options.output);
  return tell_failures(drawn, console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

}  // namespace

Run add_models(CLI::App& app) {
  const auto options = std::make_shared<ModelsOptions>();
  CLI::App& command =
      *app.add_subcommand("models", "list the friction models, or compare them in one page");
  command.add_flag("--compare", options->compare, "draw all of them side by side");
  command.add_option("-o,--output", options->output, "page (HTML) to write, with --compare")
      ->check(page_file());
  add_processes(command, options->processes);
  add_language(command, options->language);
  return [options](const Invocation& call) {
    return run_models(*options, call.arguments, call.console);
  };
}

}  // namespace tribolog::cli
