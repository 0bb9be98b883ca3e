#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "api/drawing.h"
#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/drawing.h"
#include "cli/embedded_examples.h"
#include "cli/shared_options.h"
#include "figures/figure_csv.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/scenario_file.h"
#include "paper/checks/golden_numbers.h"
#include "paper/checks/paper_items.h"
#include "paper/page/paper_page.h"
#include "wording/language.h"

namespace tribolog::cli {
namespace {

constexpr const char* directory = "examples/paper/";
constexpr const char* scenario_file = "scenario.toml";
constexpr const char* robot_file = "am100ib.toml";

paper::page::PaperSource source(const char* name) {
  return {std::string(directory) + name, std::string(text_of(embedded_examples(), name))};
}

/// Figures, items and golden numbers, in words of that language.
void describe(const paper::checks::PapersJoint& joint, const wording::Language& language,
              paper::page::RegeneratedPaper& paper) {
  const wording::WordsIn words(language);
  paper.figures = paper::checks::paper_figures(joint);
  paper.sections = paper::checks::paper_items(joint, paper.figures);
  paper.golden_numbers = paper::checks::golden_numbers(joint);
}

std::string page_in(const wording::Language& language, const paper::page::RegeneratedPaper& paper,
                    const calibration::Calibration& calibration,
                    const std::vector<render::workers::DrawnFigure>& drawn,
                    const std::string& json) {
  const wording::WordsIn words(language);
  return paper::page::paper_page(paper, calibration, drawn, json, language);
}

void tell_outcome(const paper::page::RegeneratedPaper& paper,
                  const std::vector<paper::page::PaperTally>& tallies, Console& console) {
  for (const paper::page::PaperTally& tally : tallies) {
    console.say(fmt::format("  {}s: {} of {} regenerated, every check holds in {}",
                            paper::checks::key_of(tally.kind), tally.here, tally.printed,
                            tally.well));
  }
  const paper::checks::Tally checks = paper::checks::tally_checks(paper.sections);
  const paper::checks::Tally golden = paper::checks::tally_checks(paper.golden_numbers);
  console.say(fmt::format("  checks: {} of {} hold; golden numbers: {} of {}", checks.hold,
                          checks.there, golden.hold, golden.there));
}

}  // namespace

CLI::App& add_paper(CLI::App& app, PaperOptions& paper) {
  CLI::App& command =
      *app.add_subcommand("paper", "regenerate the paper, and check it against the printed one");
  command.add_option("-o,--output", paper.output, "page (HTML) to write")->required();
  add_processes(command, paper.processes);
  add_language(command, paper.language);
  command.footer(
      "\nSimulates the paper's joint, identifies it, draws all figures, and compares every "
      "figure,\ntable and equation with what is printed. Status 1 if a check does not hold.");
  return command;
}

ExitStatus run_paper(const PaperOptions& options, const std::vector<std::string>& arguments,
                     Console& console) {
  check_output_can_be_written(options.output);
  console.make_way_for(options.output);
  paper::page::RegeneratedPaper paper;
  paper.provenance = calibration::make_provenance(arguments);
  paper.sources = {source(scenario_file), source(robot_file)};
  // Starts while the paper is computed.
  render::workers::FigureRenderer renderer(options.processes,
                                           render::workers::Prepared::charts_and_scenes);
  console.progress("simulating and identifying the paper's joint", 0, 1);
  const paper::checks::PapersJoint joint(
      ingest::manifest::parse_scenario(paper.sources[0].text, paper.sources[0].name),
      ingest::manifest::parse_robot(paper.sources[1].text, paper.sources[1].name));
  console.progress("checking it", 0, 1);
  describe(joint, wording::Language{}, paper);
  const std::string json = paper::page::paper_json(paper);
  if (!options.language.is_english()) {
    const std::vector<figures::ReportFigure> english = std::move(paper.figures);
    describe(joint, options.language, paper);
    figures::take_english_data(english, paper.figures);
  }

  const std::vector<render::workers::DrawnFigure> drawn = draw(renderer, paper.figures, console);
  paper.provenance.drawing = api::software_that_drew(drawn);
  const std::vector<paper::page::PaperTally> tallies = paper::page::tally_of(paper, drawn);
  write_file_atomically(options.output,
                        page_in(options.language, paper, joint.calibration, drawn, json));
  tell_outcome(paper, tallies, console);
  console.say("paper: " + options.output);
  if (tell_failures(drawn, console) > 0) return ExitStatus::figure_failed;
  const bool all_well =
      std::all_of(tallies.begin(), tallies.end(),
                  [](const paper::page::PaperTally& tally) { return tally.well == tally.printed; });
  const paper::checks::Tally golden = paper::checks::tally_checks(paper.golden_numbers);
  return all_well && golden.hold == golden.there ? ExitStatus::done : ExitStatus::verdict_failed;
}

}  // namespace tribolog::cli
