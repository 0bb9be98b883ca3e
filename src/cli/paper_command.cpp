#include <algorithm>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/drawing.h"
#include "cli/embedded_examples.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/scenario_file.h"
#include "paper/checks/golden_numbers.h"
#include "paper/checks/paper_figures.h"
#include "paper/page/paper_page.h"

namespace tribolog {
namespace {

constexpr const char* directory = "examples/paper/";
constexpr const char* scenario_file = "scenario.toml";
constexpr const char* robot_file = "am100ib.toml";

PaperSource source(const char* name) {
  return {std::string(directory) + name, std::string(text_of(embedded_examples(), name))};
}

void tell_outcome(const RegeneratedPaper& paper, const std::vector<PaperTally>& tallies,
                  Console& console) {
  for (const PaperTally& tally : tallies) {
    console.say(fmt::format("  {}: {} of {} regenerated, every check holds in {}", tally.kind,
                            tally.here, tally.printed, tally.well));
  }
  const paper::Tally checks = paper::tally_checks(paper.sections);
  const paper::Tally golden = paper::tally_checks(paper.golden_numbers);
  console.say(fmt::format("  checks: {} of {} hold; golden numbers: {} of {}", checks.hold,
                          checks.there, golden.hold, golden.there));
}

}  // namespace

ExitStatus run_paper(const PaperOptions& options, const std::vector<std::string>& arguments,
                     Console& console) {
  check_output_can_be_written(options.output);
  console.make_way_for(options.output);
  RegeneratedPaper paper;
  paper.provenance = make_provenance(arguments);
  paper.sources = {source(scenario_file), source(robot_file)};
  // Starts while the paper is computed.
  render::FigureRenderer renderer(options.processes, render::Prepared::charts_and_scenes);
  console.progress("simulating and identifying the paper's joint", 0, 1);
  const paper::PapersJoint joint(parse_scenario(paper.sources[0].text, paper.sources[0].name),
                                 parse_robot(paper.sources[1].text, paper.sources[1].name));
  paper.figures = paper::paper_figures(joint);
  console.progress("checking it", 0, 1);
  paper.sections = paper::paper_items(joint, paper.figures);
  paper.golden_numbers = paper::golden_numbers(joint);

  const std::vector<render::DrawnFigure> drawn =
      draw(renderer, paper.figures, options.language, console);
  paper.provenance.drawing = software_that_drew(drawn);
  const std::vector<PaperTally> tallies = tally_of(paper, drawn);
  write_file_atomically(options.output,
                        paper_page(paper, joint.calibration, drawn, options.language));
  tell_outcome(paper, tallies, console);
  console.say("paper: " + options.output);
  if (tell_failures(drawn, console) > 0) return ExitStatus::figure_failed;
  const bool all_well = std::all_of(tallies.begin(), tallies.end(), [](const PaperTally& tally) {
    return tally.well == tally.printed;
  });
  const paper::Tally golden = paper::tally_checks(paper.golden_numbers);
  return all_well && golden.hold == golden.there ? ExitStatus::done : ExitStatus::verdict_failed;
}

}  // namespace tribolog
