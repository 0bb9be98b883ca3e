#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "api/drawing.h"
#include "base/atomic_file.h"
#include "base/input_file.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/drawing.h"
#include "cli/embedded_examples.h"
#include "cli/shared_options.h"
#include "figures/figure_csv.h"
#include "figures/figure_set.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/scenario_file.h"
#include "paper/checks/paper_items.h"
#include "paper/page/claims_page.h"
#include "paper/page/paper_page.h"
#include "wording/language.h"

namespace tribolog::cli {
namespace {

struct PaperOptions {
  std::string scenario;  ///< Empty: the paper's joint, which is built in.
  std::string output;    ///< The page (HTML).
  int processes{2};
  wording::Language language;
};

constexpr const char* directory = "examples/paper/";
constexpr const char* scenario_file = "scenario.toml";
constexpr const char* robot_file = "am100ib.toml";

paper::page::PaperSource source(const char* name) {
  return {std::string(directory) + name, std::string(text_of(embedded_examples(), name))};
}

/// Figures and items, in words of that language.
void describe(const paper::checks::PapersJoint& joint, const wording::Language& language,
              paper::page::RegeneratedPaper& paper) {
  const wording::WordsIn words(language);
  paper.figures = paper::checks::paper_figures(joint);
  paper.sections = paper::checks::paper_items(joint, paper.figures);
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
    console.say(fmt::format("  {}s: {} of {} regenerated, no check fails in {}",
                            paper::checks::key_of(tally.kind), tally.here, tally.printed,
                            tally.well));
  }
  const auto tally = [&](paper::checks::Kind kind) {
    const paper::checks::Tally checks = paper::checks::tally_checks(paper.sections, kind);
    return fmt::format("{} of {}", checks.hold, checks.there);
  };
  console.say(
      fmt::format("  print against computation: {} hold; independent computations: {}; "
                  "definitions, not checked: {}",
                  tally(paper::checks::Kind::print), tally(paper::checks::Kind::independent),
                  paper::checks::count_unchecked(paper.sections)));
}

simulate::Scenario papers_scenario() {
  const paper::page::PaperSource file = source(scenario_file);
  return ingest::manifest::parse_scenario(file.text, file.name);
}

/// Claims and figures, in words of that language.
void describe(const paper::claims::ArguedJoint& papers, const paper::claims::ArguedJoint& joint,
              const wording::Language& language, paper::page::ArguedPaper& paper) {
  const wording::WordsIn words(language);
  paper.claims = paper::claims::put_claims(papers, joint);
  paper.figures = figures::figure_set(joint.dataset, joint.calibration);
  std::erase_if(paper.figures, [](const figures::ReportFigure& figure) {
    constexpr int first = 11;  // of the identification
    constexpr int last = 22;
    return figure.paper_number < first || figure.paper_number > last;
  });
}

std::string found_on(const paper::claims::Finding& finding) {
  const char* outcome = !finding.holds ? "not asked" : *finding.holds ? "holds" : "does not hold";
  return fmt::format("{} ({})", outcome, finding.found);
}

/// The paper's argument on the scenario's joint.
ExitStatus run_claims(const PaperOptions& options, const std::vector<std::string>& arguments,
                      Console& console) {
  paper::page::ArguedPaper paper;
  paper.provenance = calibration::make_provenance(arguments);
  paper.source = {options.scenario, read_file(options.scenario)};
  const simulate::Scenario scenario =
      ingest::manifest::parse_scenario(paper.source.text, options.scenario);
  paper.joint = scenario.name;
  render::workers::FigureRenderer renderer(options.processes,
                                           render::workers::Prepared::charts_and_scenes);
  console.progress("simulating and identifying the paper's joint", 0, 2);
  const paper::claims::ArguedJoint papers(papers_scenario());
  console.progress("simulating and identifying " + scenario.name, 1, 2);
  const paper::claims::ArguedJoint joint(scenario);
  describe(papers, joint, wording::Language{}, paper);
  for (const paper::claims::Claim& claim : paper.claims) {
    console.say(fmt::format("  {}\n    here: {}\n    on the paper's joint: {}", claim.what,
                            found_on(claim.on_this_joint), found_on(claim.on_papers_joint)));
  }
  const std::string json = paper::page::claims_json(paper);
  if (!options.language.is_english()) {
    const std::vector<figures::ReportFigure> english = std::move(paper.figures);
    describe(papers, joint, options.language, paper);
    figures::take_english_data(english, paper.figures);
  }
  const std::vector<render::workers::DrawnFigure> drawn = draw(renderer, paper.figures, console);
  paper.provenance.drawing = api::software_that_drew(drawn);
  const wording::WordsIn words(options.language);
  write_file_atomically(options.output, paper::page::claims_page(paper, joint.calibration, drawn,
                                                                 json, options.language));
  console.say("paper: " + options.output);
  return tell_failures(drawn, console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

ExitStatus run_paper(const PaperOptions& options, const std::vector<std::string>& arguments,
                     Console& console) {
  check_output_can_be_written(options.output);
  console.make_way_for(options.output);
  if (!options.scenario.empty()) return run_claims(options, arguments, console);
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
  paper.presliding = joint.presliding;
  console.progress("checking it", 0, 1);
  describe(joint, wording::Language{}, paper);
  const std::string json = paper::page::paper_json(paper);
  if (!options.language.is_english()) {
    const std::vector<figures::ReportFigure> english = std::move(paper.figures);
    describe(joint, options.language, paper);
    figures::take_english_data(english, paper.figures);
  }

  paper::page::fit_to_page(paper.figures);
  const std::vector<render::workers::DrawnFigure> drawn = draw(renderer, paper.figures, console);
  paper.provenance.drawing = api::software_that_drew(drawn);
  const std::vector<paper::page::PaperTally> tallies = paper::page::tally_of(paper, drawn);
  write_file_atomically(options.output,
                        page_in(options.language, paper, joint.calibration, drawn, json));
  tell_outcome(paper, tallies, console);
  console.say("paper: " + options.output);
  if (tell_failures(drawn, console) > 0) return ExitStatus::figure_failed;
  return paper::page::is_all_well(paper, tallies) ? ExitStatus::done : ExitStatus::verdict_failed;
}

}  // namespace

Run add_paper(CLI::App& app) {
  const auto options = std::make_shared<PaperOptions>();
  CLI::App& command =
      *app.add_subcommand("paper", "regenerate the paper, and check it against the printed one");
  command.add_option("SCENARIO", options->scenario,
                     "another joint (TOML): what of the paper's argument holds there");
  command.add_option("-o,--output", options->output, "page (HTML) to write")
      ->required()
      ->check(page_file());
  add_processes(command, options->processes);
  add_language(command, options->language);
  command.footer(
      "\nSimulates the paper's joint, identifies it, draws all figures, and compares every "
      "figure,\ntable and equation with what is printed. Status 1 if a check does not hold.\n"
      "With SCENARIO the paper's claims are hypotheses about that joint: which hold there is\nno "
      "failure.");
  return [options](const Invocation& call) {
    return run_paper(*options, call.arguments, call.console);
  };
}

}  // namespace tribolog::cli
