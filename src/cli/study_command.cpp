#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "api/drawing.h"
#include "base/atomic_file.h"
#include "base/input_file.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/drawing.h"
#include "cli/embedded_examples.h"
#include "cli/shared_options.h"
#include "exports/simulation/simulation_files.h"
#include "figures/experiments/study_figures.h"
#include "figures/figure_csv.h"
#include "ingest/manifest/scenario_file.h"
#include "report/experiments/study_page.h"
#include "statistics/distributions.h"
#include "statistics/order_statistics.h"
#include "study/misfit.h"
#include "study/trust.h"
#include "wording/language.h"
#include "wording/words.h"

namespace tribolog::cli {

namespace {

struct StudyCommandOptions {
  std::string scenario;  ///< Empty: the paper's joint with realistic noise, which is built in.
  std::string output;    ///< The page (HTML).
  std::string json;      ///< All numbers; empty: only within the page.
  /// Of each case; with `mixed` joints. None: as many as the study has by itself.
  std::optional<std::size_t> runs;
  unsigned long long seed{1};
  std::size_t threads{0};            ///< 0: all cores.
  std::vector<std::string> factors;  ///< Keys; none: all.
  bool misfit{false};     ///< On joints and logs that the method's model does not describe.
  bool sound{false};      ///< The same on joints that it does describe.
  bool unstated{false};   ///< With `sound`: manifests that do not state which effects are absent.
  bool mixed{false};      ///< On joints drawn at random, with many small effects at once.
  bool less_data{false};  ///< On sound joints of which less was recorded than one would wish.
  std::vector<std::string> disturbances;  ///< With `misfit`: keys; none: all.
  std::vector<std::string> joints;        ///< With `misfit`: keys; none: all.
  std::string logs;  ///< With these three: directory for the first run of each case or joint.
  int processes{2};
  wording::Language language;
};

constexpr const char* usual_scenario = "scenario_noise.toml";
constexpr std::uint64_t largest_scenario_bytes = 1 << 20;
constexpr std::size_t usual_runs = 200;

struct NamedScenario {
  std::string file;
  std::string text;
  simulate::Scenario scenario;
};

/// The scenario named, or the paper's joint with the noise of a real drive.
NamedScenario scenario_of(const StudyCommandOptions& options) {
  if (!options.scenario.empty()) {
    return {calibration::command_line_text({options.scenario}),
            read_file(options.scenario, largest_scenario_bytes),
            ingest::manifest::read_scenario(options.scenario)};
  }
  const std::string name = std::string("examples/paper/") + usual_scenario;
  std::string text(text_of(embedded_examples(), usual_scenario));
  simulate::Scenario scenario = ingest::manifest::parse_scenario(text, name);
  return {name, std::move(text), std::move(scenario)};
}

nlohmann::json misfit_json(const std::vector<study::MisfitCase>& cases) {
  nlohmann::json list = nlohmann::json::array();
  for (const study::MisfitCase& c : cases) {
    nlohmann::json quantities = nlohmann::json::object();
    for (const study::MisfitQuantity& q : c.quantities) {
      quantities[to_string(q.quantity)] = {{"truth", q.truth},
                                           {"found", q.found},
                                           {"judged", q.judged},
                                           {"usable", q.usable},
                                           {"inside", q.inside},
                                           {"wrong", q.wrong},
                                           {"wrong_usable", q.wrong_usable},
                                           {"by_chance", q.by_chance},
                                           {"worst_usable", q.worst_usable},
                                           {"rms_error", q.rms_error},
                                           {"half_width", q.half_width}};
    }
    list.push_back({{"joint", c.joint},
                    {"disturbance", c.disturbance},
                    {"size", c.size},
                    {"runs", c.runs},
                    {"named", c.has_cause ? nlohmann::json(c.named) : nlohmann::json(nullptr)},
                    {"harmed", c.harmed},
                    {"harmed_and_named", c.harmed_and_named},
                    {"quantities", quantities}});
  }
  return {{"schema", "tribolog-misfit-1"}, {"cases", list}};
}

/// What the study is made for, in a few lines: wrong numbers that are called usable, and causes
/// that are not named where they do harm. What no log can show, such as a wrong torque constant, is
/// left out.
void say_outcome(const std::vector<study::MisfitCase>& cases, Console& console) {
  std::set<std::string> hidden;
  for (const study::Disturbance& d : study::disturbances()) {
    if (d.is_hidden) hidden.insert(d.key);
  }
  std::size_t numbers = 0;
  std::size_t usable = 0;
  std::size_t wrong = 0;
  double by_chance = 0;
  std::vector<std::string> where;
  std::map<std::string, std::pair<std::size_t, std::size_t>> named;  // of runs harmed
  for (const study::MisfitCase& c : cases) {
    if (c.harmed > 0) {
      named[c.disturbance].first += c.harmed_and_named;
      named[c.disturbance].second += c.harmed;
    }
    if (hidden.contains(c.disturbance)) continue;
    for (const study::MisfitQuantity& q : c.quantities) {
      numbers += q.found;
      usable += q.usable;
      wrong += q.wrong_usable;
      by_chance += q.by_chance;
      if (q.wrong_usable == 0) continue;
      where.push_back(fmt::format(
          "{}, {}: {} in {} of {} runs, at most {:.2g} times what matters", c.joint,
          c.disturbance.empty() ? "sound" : fmt::format("{} {:g}", c.disturbance, c.size),
          to_string(q.quantity), q.wrong_usable, c.runs, q.worst_usable));
    }
  }
  console.say(
      fmt::format("wrong and usable: {} of {} numbers, {} of them usable; {:.1f} by chance, where "
                  "intervals are wider than what matters",
                  wrong, numbers, usable, by_chance));
  for (const std::string& one : where) console.say("  " + one);
  if (named.empty()) return;
  constexpr double enough = 0.8;
  std::size_t named_runs = 0;
  std::size_t runs = 0;
  std::vector<std::string> seldom;
  for (const auto& [key, of] : named) {
    named_runs += of.first;
    runs += of.second;
    const double share = static_cast<double>(of.first) / static_cast<double>(of.second);
    if (share < enough) seldom.push_back(fmt::format("{} {:.0f} %", key, 100 * share));
  }
  console.say(fmt::format("cause named: in {:.1f} % of the {} runs that it harms; seldom: {}",
                          100.0 * static_cast<double>(named_runs) / static_cast<double>(runs), runs,
                          seldom.empty() ? "none" : fmt::format("{}", fmt::join(seldom, ", "))));
}

/// How each quantity fared in a case, a line each.
void say_quantities(const study::MisfitCase& c, Console& console) {
  console.say(fmt::format("{}, {} {:g}:", c.joint, c.disturbance, c.size));
  for (const study::MisfitQuantity& q : c.quantities) {
    const double judged = std::max(1.0, static_cast<double>(q.judged));
    console.say(fmt::format(
        "  {}: found {} of {}, inside {:.0f} %, usable {}, wrong and usable {}; error (RMS) {:.2g} "
        "and half width {:.2g} times what matters",
        to_string(q.quantity), q.found, c.runs, 100 * static_cast<double>(q.inside) / judged,
        q.usable, q.wrong_usable, q.rms_error, q.half_width));
  }
}

/// How a quantity fared over all joints.
struct QuantitySum {
  std::size_t found{};
  std::size_t judged{};
  std::size_t inside{};
  std::size_t usable{};
  std::size_t wrong_usable{};
  std::vector<double> half_widths;  ///< Of each joint, as shares of what matters.
  std::vector<double> widths;       ///< Of each joint, over 1.96 root mean squares of its errors.

  void add(const study::MisfitQuantity& q) {
    found += q.found;
    judged += q.judged;
    inside += q.inside;
    usable += q.usable;
    wrong_usable += q.wrong_usable;
    if (q.judged == 0) return;
    half_widths.push_back(q.half_width);
    if (q.judged > 1 && q.rms_error > 0) {
      widths.push_back(q.half_width / (statistics::normal_975 * q.rms_error));
    }
  }

  std::string line(const std::string& name) const {
    std::string out =
        fmt::format("  {}: found {}, inside {:.1f} %, usable {}, wrong and usable {}", name, found,
                    100 * static_cast<double>(inside) / std::max(1.0, static_cast<double>(judged)),
                    usable, wrong_usable);
    if (!half_widths.empty()) {
      const auto [least, most] = std::minmax_element(half_widths.begin(), half_widths.end());
      out += fmt::format("; half width {:.2g} to {:.2g} times what matters", *least, *most);
    }
    if (!widths.empty()) {
      out += fmt::format(", {:.2f} times 1.96 RMS (median of the joints; at most {:.2f})",
                         statistics::median_of(widths),
                         *std::max_element(widths.begin(), widths.end()));
    }
    return out;
  }
};

/// How each quantity fared with each lack of data, over all joints, a line each.
void say_sums(const std::vector<study::MisfitCase>& cases, Console& console) {
  std::vector<std::string> order;
  std::map<std::string, std::map<joint::Quantity, QuantitySum>> sums;
  std::map<std::string, std::size_t> runs;
  for (const study::MisfitCase& c : cases) {
    if (!sums.contains(c.disturbance)) order.push_back(c.disturbance);
    runs[c.disturbance] += c.runs;
    for (const study::MisfitQuantity& q : c.quantities) sums[c.disturbance][q.quantity].add(q);
  }
  for (const std::string& key : order) {
    console.say(fmt::format("{}, {} runs:", key.empty() ? "all data" : key, runs[key]));
    for (const auto& [quantity, sum] : sums[key]) console.say(sum.line(to_string(quantity)));
  }
}

study::KeepLogs keep_in(const std::string& directory) {
  if (directory.empty()) return {};
  return [directory](const study::MisfitCase& of, const simulate::Scenario& laid,
                     const std::vector<joint::Recording>& logs) {
    const std::string name = of.disturbance.empty()
                                 ? of.joint
                                 : fmt::format("{}-{}-{:g}", of.joint, of.disturbance, of.size);
    exports::simulation::write_simulation(laid, logs, directory + "/" + name);
  };
}

std::vector<study::MisfitCase> run_mixed_cases(const StudyCommandOptions& options,
                                               const study::MisfitProgress& progress) {
  study::MixedOptions study;
  study.joints = options.runs.value_or(study.joints);
  study.seed = options.seed;
  study.threads = options.threads;
  study.keep_logs = keep_in(options.logs);
  return study::run_mixed_study(study, progress);
}

/// @throw std::invalid_argument as run_misfit_study().
std::vector<study::MisfitCase> run_misfit_cases(const StudyCommandOptions& options,
                                                const study::MisfitProgress& progress) {
  study::MisfitOptions study;
  study.runs = options.runs.value_or(usual_runs);
  study.seed = options.seed;
  study.threads = options.threads;
  study.disturbances = options.disturbances;
  study.joints = options.joints;
  study.only_sound = options.sound;
  study.unstated = options.unstated;
  study.lacks = options.less_data;
  study.keep_logs = keep_in(options.logs);
  return study::run_misfit_study(study, progress);
}

bool has_joints_of_its_own(const StudyCommandOptions& options) {
  return options.misfit || options.sound || options.mixed || options.less_data;
}

ExitStatus run_misfit_command(const StudyCommandOptions& options, Console& console) {
  if (options.json.empty()) {
    throw UsageError("study --misfit, --sound, --mixed and --less-data need --json FILE");
  }
  if (!options.output.empty() || !options.scenario.empty() || !options.factors.empty()) {
    throw UsageError(
        "--misfit, --sound, --mixed and --less-data have joints of their own: SCENARIO, --factor "
        "and -o do not apply");
  }
  check_output_can_be_written(options.json, {});
  console.make_way_for(options.json);
  const auto progress = [&](const std::string& name, std::size_t done, std::size_t all) {
    console.progress(name, done, all);
  };
  std::vector<study::MisfitCase> cases;
  try {
    cases =
        options.mixed ? run_mixed_cases(options, progress) : run_misfit_cases(options, progress);
  } catch (const std::invalid_argument& refused) {
    throw UsageError(refused.what());
  }
  AtomicFiles files;
  files.add(options.json, misfit_json(cases).dump(1) + "\n");
  files.commit();
  if (options.mixed) {
    for (const study::MisfitCase& c : cases) say_quantities(c, console);
  }
  if (options.sound || options.less_data) say_sums(cases, console);
  say_outcome(cases, console);
  console.say("numbers: " + options.json);
  return ExitStatus::done;
}

ExitStatus run_study_command(const StudyCommandOptions& options,
                             const std::vector<std::string>& arguments, Console& console) {
  if (options.sound && !options.disturbances.empty()) {
    throw UsageError("--sound lays no --disturbance: choose one of them");
  }
  if (options.unstated && !options.sound) {
    throw UsageError("--unstated is for --sound, which is not given");
  }
  if (options.unstated && !options.logs.empty()) {
    throw UsageError("--logs keeps manifests that state the effects: leave out --unstated");
  }
  if (int{options.misfit} + int{options.sound} + int{options.mixed} + int{options.less_data} > 1) {
    throw UsageError(
        "--misfit, --sound, --mixed and --less-data are studies of their own: choose one");
  }
  if (options.mixed && !(options.disturbances.empty() && options.joints.empty())) {
    throw UsageError("--mixed draws joints and effects: --joint and --disturbance do not apply");
  }
  if (!options.logs.empty() && !has_joints_of_its_own(options)) {
    throw UsageError(
        "--logs keeps what --misfit, --sound, --mixed or --less-data simulates: none is given");
  }
  if (has_joints_of_its_own(options)) return run_misfit_command(options, console);
  if (options.output.empty() && options.json.empty()) {
    throw UsageError("study needs -o FILE, --json FILE, --misfit, --sound, --mixed or --less-data");
  }
  std::vector<std::string> inputs;
  if (!options.scenario.empty()) inputs.push_back(options.scenario);
  check_outputs_differ({options.output, options.json});
  for (const std::string& output : {options.output, options.json}) {
    if (output.empty()) continue;
    check_output_can_be_written(output, inputs);
    console.make_way_for(output);
  }
  report::experiments::StudyReport report;
  report.provenance = calibration::make_provenance(arguments);
  NamedScenario named = scenario_of(options);
  report.scenario_file = std::move(named.file);
  report.scenario_text = std::move(named.text);
  std::optional<render::workers::FigureRenderer> renderer;
  if (!options.output.empty()) renderer.emplace(options.processes);  // starts while the study runs
  study::StudyOptions study;
  study.runs = options.runs.value_or(usual_runs);
  study.seed = options.seed;
  study.threads = options.threads;
  study.factors = options.factors;
  try {
    report.study = study::run_study(
        named.scenario, study, [&](const std::string& name, std::size_t done, std::size_t all) {
          console.progress(fmt::format("{} runs: {}", study.runs, name), done, all);
        });
  } catch (const std::invalid_argument& refused) {
    throw InputError({report.scenario_file, 0, 0},
                     {"cannot be studied", wording::words(refused), "", ""});
  }
  if (!options.json.empty()) {
    AtomicFiles numbers;
    numbers.add(options.json, report::experiments::study_json(report));
    numbers.commit();
  }
  std::vector<render::workers::DrawnFigure> drawn;
  if (renderer) {
    const std::vector<figures::ReportFigure> figures = figures::figures_in(
        options.language, [&] { return figures::experiments::study_figures(report.study); });
    drawn = draw(*renderer, figures, console);
    report.provenance.drawing = api::software_that_drew(drawn);
    const wording::WordsIn words(options.language);
    AtomicFiles page;
    page.add(options.output,
             report::experiments::study_page(report, figures, drawn, options.language));
    page.commit();
  }
  console.say(wording::words(study::study_sentence(report.study)));
  if (!options.json.empty()) console.say("numbers: " + options.json);
  if (renderer) console.say("study: " + options.output);
  return tell_failures(drawn, console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

}  // namespace

Run add_study(CLI::App& app) {
  const auto options = std::make_shared<StudyCommandOptions>();
  CLI::App& command =
      *app.add_subcommand("study", "Monte-Carlo study: where the method can be trusted");
  constexpr std::size_t most = 1'000'000;
  command.add_option("SCENARIO", options->scenario,
                     "scenario file (TOML); default: the paper's joint with realistic noise");
  command.add_option("-o,--output", options->output, "page (HTML) to write")->check(page_file());
  command.add_option("--json", options->json, "file for all numbers (JSON)");
  command
      .add_option("--factor", options->factors,
                  "study only this one (may be repeated); default: all")
      ->check(one_of(std::vector<std::string>{"torque_noise", "torque_step", "encoder",
                                              "ripple_one_position", "ripple_eight_positions",
                                              "amplitude", "cycles"}));
  command.add_flag("--misfit", options->misfit,
                   "joints and logs that the method's model does not describe");
  command.add_flag("--sound", options->sound,
                   "twelve joints that the model describes: coverage, and share called usable");
  command.add_flag("--unstated", options->unstated,
                   "with --sound: manifests that do not state which effects the joints lack");
  command.add_flag("--mixed", options->mixed,
                   "joints drawn at random, with many small effects at once");
  command.add_flag("--less-data", options->less_data,
                   "sound joints of which less was recorded than one would wish");
  command.add_option("--disturbance", options->disturbances,
                     "with --misfit or --less-data: lay this one alone (may be given again); "
                     "default: all");
  command.add_option("--joint", options->joints,
                     "with --misfit, --sound or --less-data: on this joint alone (may be given "
                     "again)");
  command.add_option("--logs", options->logs,
                     "with --misfit, --sound or --less-data: directory for the logs of each case's "
                     "first run; with --mixed: of each joint");
  command.add_option("--runs", options->runs, "runs per case; with --mixed joints, else 100")
      ->check(CLI::Range(std::size_t{2}, most))
      ->default_str(std::to_string(usual_runs));
  command.add_option("--seed", options->seed, "seed of all noise")
      ->check(whole_number())
      ->capture_default_str();
  add_threads(command, options->threads);
  add_processes(command, options->processes);
  add_language(command, options->language);
  command.footer(
      "\nSimulates the scenario many times, each run with its own noise, identifies each,\nand "
      "compares every estimator with the truth: bias, scatter, and coverage of the stated 95 "
      "%\nintervals, one factor at a time around the base case: white torque noise, torque "
      "step,\nencoder, ripple from one and from eight motor positions, amplitude and cycles of "
      "the\noscillation. 200 runs of about thirty cases take some minutes on two cores; --runs "
      "20\nshows the biases in seconds.");
  return [options](const Invocation& call) {
    return run_study_command(*options, call.arguments, call.console);
  };
}

}  // namespace tribolog::cli
