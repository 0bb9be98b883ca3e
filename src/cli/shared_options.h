#pragma once
// Options that several commands have, each with the same words.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/archiving.h"
#include "cli/identification.h"
#include "joint/dataset.h"
#include "tribolog/values.h"
#include "wording/language.h"

namespace tribolog::cli {

/// A finite number from lowest to highest: CLI::Range takes "nan".
CLI::Validator number_between(double lowest, double highest);
/// Digits alone: "-5" would become a huge number.
CLI::Validator whole_number();

/// One of the words, in the order given; a refusal names the closest.
CLI::Validator one_of(std::vector<std::string> words);

/// Of a map its keys.
template <class Value>
CLI::Validator one_of(const std::map<std::string, Value>& named) {
  std::vector<std::string> words;
  for (const auto& [word, value] : named) words.push_back(word);
  return one_of(std::move(words));
}

/// "101" or "101:1"; the value is the number then.
CLI::Validator gear_ratio();

/// Where a page (HTML) is written: not to a file whose name ends in that of another format.
CLI::Validator page_file();

/// `--fail-on VERDICT`
void add_fail_on(CLI::App& command, std::optional<Verdict>& fail_on);
/// `--seed`, and `--resamples` of programs that resampled
void add_seed(CLI::App& command, std::optional<std::uint64_t>& seed);
/// `--archive [LOCATION]`, `--archive-inputs`, `--archive-again`, `--wait`
void add_archiving(CLI::App& command, ArchivingOptions& archiving);
/// `-j,--processes`
void add_processes(CLI::App& command, int& processes);
/// `--truth-runs` and `--check`
/// DATASET and --joint.
void add_dataset(CLI::App& command, DatasetChoice& dataset);
void add_truth_runs(CLI::App& command, std::size_t& truth_runs);
/// `--threads`
void add_threads(CLI::App& command, std::size_t& threads);
/// `--language CODE`
void add_language(CLI::App& command, wording::Language& language);

}  // namespace tribolog::cli
