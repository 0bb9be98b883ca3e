#include "cli/shared_options.h"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wording/words.h"

namespace tribolog::cli {
namespace {

const std::map<std::string, Verdict> verdicts{{"doubtful", Verdict::doubtful},
                                              {"not-identifiable", Verdict::not_identifiable}};

/// "en (the default), pl"
std::string codes_in_words() {
  std::string codes;
  for (const wording::Language& one : wording::languages()) {
    codes += (codes.empty() ? "" : ", ") + one.code + (one.is_english() ? " (the default)" : "");
  }
  return codes;
}

std::vector<std::string> language_codes() {
  std::vector<std::string> codes;
  for (const wording::Language& one : wording::languages()) codes.push_back(one.code);
  return codes;
}

}  // namespace

CLI::Validator number_between(double lowest, double highest) {
  return {[lowest, highest](const std::string& text) {
            char* end = nullptr;
            const double number = std::strtod(text.c_str(), &end);
            const bool is_number = !text.empty() && end == text.c_str() + text.size();
            if (is_number && number >= lowest && number <= highest) return std::string();
            return fmt::format("{} is not usable, expected a number from {:g} to {:g}", text,
                               lowest, highest);
          },
          fmt::format("[{:g} - {:g}]", lowest, highest)};
}

CLI::Validator whole_number() {
  return {[](const std::string& text) {
            std::uint64_t number = 0;
            const char* const end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, number);
            if (read.ec == std::errc() && read.ptr == end) return std::string();
            return text + " is not usable, expected a whole number from 0 to 18446744073709551615";
          },
          "WHOLE NUMBER"};
}

void add_fail_on(CLI::App& command, std::optional<Verdict>& fail_on) {
  command
      .add_option_function<std::string>(
          "--fail-on", [&fail_on](const std::string& word) { fail_on = verdicts.at(word); },
          "exit with status 1 at this verdict or a worse one: doubtful, not-identifiable")
      ->check(CLI::IsMember(verdicts))
      ->type_name("VERDICT");
}

void add_intervals(CLI::App& command, joint::IntervalSettings& intervals) {
  command
      .add_option("--resamples", intervals.resamples,
                  "resamples of the bootstrap behind the intervals: " +
                      wording::words(joint::allowed_resamples()) +
                      "; default: the manifest's, or 1000")
      ->check(whole_number());
  command
      .add_option("--seed", intervals.seed, "seed of the resamples; default: the manifest's, or 1")
      ->check(whole_number());
}

void add_archiving(CLI::App& command, ArchivingOptions& archiving) {
  constexpr double longest_s = 3600;
  command
      .add_option_function<std::vector<std::string>>(
          "--archive",
          [&archiving](const std::vector<std::string>& given) {
            archiving.location = given.empty() ? "" : given.front();
          },
          "keep the numbers and the report in this archive (a file, or postgresql://...); without "
          "a value, in the user's own")
      ->expected(0, 1)
      ->type_name("LOCATION");
  command.add_flag("--archive-inputs", archiving.inputs, "also archive manifest and recordings");
  command.add_flag("--archive-again", archiving.again,
                   "if the same inputs are already archived: keep this one as well");
  command
      .add_option("--wait", archiving.wait_s,
                  "seconds to wait while another process writes to the archive")
      ->check(number_between(0, longest_s))
      ->capture_default_str();
}

void add_processes(CLI::App& command, int& processes) {
  command.add_option("-j,--processes", processes, "processes that draw figures")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

void add_dataset(CLI::App& command, DatasetChoice& dataset) {
  command.add_option("DATASET", dataset.manifest, "dataset manifest (TOML)")->required();
  command
      .add_option("--joint", dataset.joint,
                  "one joint of a whole robot's manifest, [[joints]], by its name")
      ->type_name("NAME");
}

void add_truth_runs(CLI::App& command, std::size_t& truth_runs) {
  constexpr std::size_t most = 10'000;
  command
      .add_option("--truth-runs", truth_runs,
                  "simulations of what was identified, each identified again; 0: no such check")
      ->check(CLI::Range(std::size_t{0}, most))
      ->capture_default_str();
}

void add_threads(CLI::App& command, std::size_t& threads) {
  command.add_option("--threads", threads, "0: all cores; changes no number")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1024}))
      ->capture_default_str();
}

void add_language(CLI::App& command, wording::Language& language) {
  command
      .add_option(
          "--language", language.code,
          fmt::format("language of the texts: {}; numbers, units and JSON are the same in each",
                      codes_in_words()))
      ->check(CLI::IsMember(language_codes()))
      ->type_name("CODE");
}

}  // namespace tribolog::cli
