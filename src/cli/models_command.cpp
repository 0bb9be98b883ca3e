#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/drawing.h"
#include "figures/model_figures.h"
#include "files/atomic_file.h"
#include "friction/catalogue.h"
#include "report/models_page.h"

namespace tribolog {
namespace {

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none of it" : fmt::format("{}", fmt::join(words, ", "));
}

std::string shown_by(const FrictionTraits& traits) {
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

std::string limits_of(const FrictionTraits& traits) {
  std::vector<std::string> words;
  if (traits.drifts) words.emplace_back("drifts under an oscillating torque below break-away");
  if (traits.rate_independent) words.emplace_back("rate independent");
  if (traits.is_random) words.emplace_back("random");
  return words.empty() ? "" : fmt::format("\n    {}", fmt::join(words, "; "));
}

void list_models(Console& console) {
  console.say("dynamic friction models, as a scenario names them (friction.presliding.model):\n");
  for (const FrictionModelEntry& one : dynamic_friction_models()) {
    console.say(fmt::format("  {:<18}{} ({})\n    shows {}{}\n", one.name, one.title, one.source,
                            shown_by(one.traits), limits_of(one.traits)));
  }
  console.say(
      "static laws: eq. (1) Coulomb, viscous and Stribeck; eq. (2) with a threshold speed; eq. "
      "(6),\n"
      "(7) Waiboer (friction.sliding.model = \"waiboer\")");
}

}  // namespace

ExitStatus run_models(const ModelsOptions& options, const std::vector<std::string>& arguments,
                      Console& console) {
  if (options.output.empty()) {
    list_models(console);
    return ExitStatus::done;
  }
  check_output_can_be_written(options.output);
  Provenance provenance = make_provenance(arguments);
  render::FigureRenderer renderer(options.processes);  // starts while the models are computed
  console.progress("moving the models", 0, 1);
  const ContactParameters contact;
  const std::vector<ModelExperiment> experiments = model_experiments(contact);
  std::vector<ReportFigure> figures;
  for (const ModelExperiment& one : experiments) {
    figures.insert(figures.end(), one.figures.begin(), one.figures.end());
  }
  const std::vector<render::DrawnFigure> drawn = draw(renderer, figures, console);
  provenance.drawing = software_that_drew(drawn);
  write_file_atomically(options.output, models_page(contact, experiments, drawn, provenance));
  console.say("comparison: " + options.output);
  return tell_failures(drawn, console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

}  // namespace tribolog
