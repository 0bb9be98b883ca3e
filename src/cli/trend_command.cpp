#include <algorithm>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/archive_commands.h"
#include "cli/drawing.h"
#include "cli/shared_options.h"
#include "figures/figure_csv.h"
#include "figures/timeline/trend_figures.h"
#include "history/history_json.h"
#include "history/joint_trend.h"
#include "report/timeline/trend_page.h"
#include "wording/words.h"

namespace tribolog::cli {
namespace {

using history::JointTrend;
using history::TrendState;

/// A page of more would be slow to draw and to read.
constexpr std::size_t most_joints_of_a_page = 12;

struct TrendOptions {
  archive::store::Filter filter;
  std::string output;
  history::Baseline baseline;
  std::optional<double> limit_percent;
  bool json{false};
  bool fails_on_warning{false};
  int processes{2};
  wording::Language language;
};

void tell(const history::JointTrend& trend, Console& console) {
  console.say(printable(report::timeline::joint_words(trend), longest_note));
  console.say(text_of(report::timeline::trend_table(trend, "")));
  for (const std::string& note : report::timeline::trend_notes(trend)) {
    console.say(printable(note, longest_note));
  }
  const std::vector<std::string> changes = report::timeline::change_sentences(trend);
  for (const std::string& change : changes) {
    console.say(printable("change: " + change, longest_note));
  }
  if (changes.empty()) {
    console.say(fmt::format("outcome: {}", wording::words(history::statement_of(trend.state()))));
  }
}

ExitStatus write_page(const TrendOptions& options, const std::vector<history::JointTrend>& trends,
                      const Invocation& call) {
  if (trends.empty())
    throw UsageError("there is no calibration of that robot, serial number and joint");
  if (trends.size() > most_joints_of_a_page) {
    throw UsageError(fmt::format(
        "these are {} joints; a page holds at most {}; choose with --robot, --serial and --joint",
        trends.size(), most_joints_of_a_page));
  }
  const auto figures = figures::figures_in(
      options.language, [&] { return figures::timeline::trend_figures(trends); });
  return write_history_page({options.output, options.processes, options.language}, figures, call,
                            [&](const calibration::Provenance& provenance,
                                const std::vector<render::workers::DrawnFigure>& drawn) {
                              return report::timeline::trend_page(trends, provenance, figures,
                                                                  drawn, options.language);
                            });
}

}  // namespace

Run add_archive_trend(CLI::App& archive) {
  const auto options = std::make_shared<TrendOptions>();
  options->filter.latest_revisions = true;
  CLI::App& command =
      *archive.add_subcommand("trend", "joints over time: what changed, and since when");
  add_filter(command, options->filter);
  command.add_option("-o,--output", options->output, "page (HTML) to write")->check(page_file());
  command.add_flag("--json", options->json, "as JSON, to standard output");
  CLI::Option* const count =
      command
          .add_option("--baseline", options->baseline.count,
                      "number of first calibrations that only set the baseline")
          ->check(whole_number())
          ->capture_default_str();
  command
      .add_option("--baseline-from", options->baseline.from,
                  "instead: baseline from this date on; older calibrations are not used")
      ->excludes(count);
  command.add_option("--baseline-to", options->baseline.to, "and up to the end of this date")
      ->excludes(count);
  constexpr double least_percent = 0.01;
  constexpr double most_percent = 1000;
  command
      .add_option("--limit", options->limit_percent,
                  "percent of change that you accept: of a drift the date on which it is reached")
      ->check(number_between(least_percent, most_percent))
      ->type_name("PERCENT");
  command.add_flag("--fail-on-warning", options->fails_on_warning,
                   "exit with status 1 if there is a change");
  add_processes(command, options->processes);
  add_language(command, options->language);
  const auto where = add_archive_options(command);
  command.footer(
      "\nEach quantity has a control chart (CUSUM), and a straight line over time for slow drifts. "
      "A\nchange is reported with the date from which it is visible; a single odd calibration is "
      "told, but is not one.\nFriction is corrected to one temperature where the calibrations "
      "state it.");
  return [where, options](const Invocation& call) {
    where->protect_from(options->output);
    make_way(call.console, options->output, options->json);
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    std::vector<history::JointTrend> trends =
        history::joint_trends(kept.measured(options->filter), options->baseline);
    if (options->limit_percent) history::state_limits(trends, *options->limit_percent);
    if (options->json) {
      print_json(history::trend_json(trends));
    } else {
      if (trends.empty()) call.console.say("no calibrations");
      for (const history::JointTrend& trend : trends) tell(trend, call.console);
    }
    if (!options->output.empty()) {
      const ExitStatus written = write_page(*options, trends, call);
      if (written != ExitStatus::done) return written;
    }
    const bool warns = std::any_of(trends.begin(), trends.end(), [](const history::JointTrend& t) {
      return t.state() == history::TrendState::warning;
    });
    return warns && options->fails_on_warning ? ExitStatus::verdict_failed : ExitStatus::done;
  };
}

}  // namespace tribolog::cli
