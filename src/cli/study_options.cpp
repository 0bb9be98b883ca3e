#include "cli/command_options.h"
#include "cli/shared_options.h"

namespace tribolog {

CLI::App& add_study(CLI::App& app, StudyCommandOptions& study) {
  CLI::App& command =
      *app.add_subcommand("study", "Monte-Carlo study: where the method can be trusted");
  constexpr std::size_t most = 1'000'000;
  command.add_option("SCENARIO", study.scenario,
                     "scenario file (TOML); default: the paper's joint with realistic noise");
  command.add_option("-o,--output", study.output, "page (HTML) to write")->required();
  command.add_option("--json", study.json, "file for all numbers (JSON)");
  command
      .add_option("--factor", study.factors,
                  "study this one alone (may be given again); default: all")
      ->check(CLI::IsMember({"torque_noise", "torque_step", "encoder", "ripple_one_position",
                             "ripple_eight_positions", "amplitude", "cycles"}));
  command.add_option("--runs", study.runs, "runs of each case")
      ->check(CLI::Range(std::size_t{2}, most))
      ->capture_default_str();
  command.add_option("--seed", study.seed, "seed of all noise")
      ->check(whole_number())
      ->capture_default_str();
  add_threads(command, study.threads);
  command
      .add_option("--resamples", study.resamples,
                  "bootstrap resamples in each run; 0: intervals in closed form")
      ->check(CLI::Range(std::size_t{0}, most))
      ->capture_default_str();
  add_processes(command, study.processes);
  add_language(command, study.language);
  command.footer(
      "\nSimulates the scenario again and again with noise of its own in each run, identifies "
      "each,\n"
      "and holds every estimator against the truth: bias, scatter, and coverage of the stated 95 "
      "%\n"
      "intervals, one factor at a time about the base case: white torque noise, torque step,\n"
      "encoder, ripple from one and from eight motor positions, amplitude and cycles of the\n"
      "oscillation. 200 runs of about thirty cases take some minutes on two cores; --runs 20\n"
      "shows the biases in seconds.");
  return command;
}

}  // namespace tribolog
