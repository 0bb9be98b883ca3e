#include "cli/shared_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/closest_match.h"
#include "ingest/manifest/gear_ratio.h"
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

CLI::Validator one_of(std::vector<std::string> words) {
  std::string listed = fmt::format("{}", fmt::join(words, ","));
  return {[words = std::move(words)](const std::string& text) {
            if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
            const std::string meant = did_you_mean(text, words);
            return fmt::format("{} is not usable, expected one of {}{}", in_quotes(text),
                               fmt::join(words, ", "), meant.empty() ? "" : "; " + meant);
          },
          "{" + std::move(listed) + "}"};
}

CLI::Validator gear_ratio() {
  return {[](std::string& text) {
            if (text.find(':') == std::string::npos) return std::string();
            try {
              text = fmt::format("{}", ingest::manifest::parse_gear_ratio(text));
            } catch (const std::invalid_argument& refused) {
              return std::string(refused.what());
            }
            return std::string();
          },
          "", "gear ratio"};
}

namespace {

/// Endings that say another format than HTML, and how that is come by.
std::string way_to(std::string_view ending) {
  constexpr std::array pictures{"png", "svg", "jpg", "jpeg", "gif", "tif", "tiff", "webp", "eps"};
  constexpr std::array documents{"docx", "doc", "odt", "rtf", "tex", "md", "ppt", "pptx", "odp"};
  constexpr std::array tables{"csv", "tsv", "xlsx", "xls", "ods", "mat", "xml"};
  constexpr std::array files{"json", "toml", "yaml", "db", "sqlite", "tribolog", "zip"};
  const auto is_among = [&](const auto& endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
  };
  if (ending == "pdf") {
    return "print it from a browser for a PDF; tribolog figures --format pdf gives the figures "
           "as PDF";
  }
  if (is_among(pictures)) return "tribolog figures --format png (or svg, pdf) gives the figures";
  if (is_among(documents)) {
    return "word processors open it; tribolog figures gives the figures, tribolog export --format "
           "latex a table";
  }
  if (is_among(tables)) return "tribolog export --format csv (or mat, dcc) gives the numbers";
  return is_among(files) ? "tribolog identify -o FILE.json gives the numbers" : "";
}

std::string lower_ending_of(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

}  // namespace

CLI::Validator page_file() {
  return {[](const std::string& file) {
            std::error_code ignored;
            const std::string way = way_to(lower_ending_of(file));
            if (way.empty() || std::filesystem::is_directory(file, ignored)) return std::string();
            const std::string stem = std::filesystem::path(file).stem().string();
            return fmt::format("{} is not usable, the page is HTML: write it to {}; {}",
                               in_quotes(file), in_quotes(stem + ".html"), way);
          },
          ""};
}

void add_fail_on(CLI::App& command, std::optional<Verdict>& fail_on) {
  command
      .add_option_function<std::string>(
          "--fail-on", [&fail_on](const std::string& word) { fail_on = verdicts.at(word); },
          "exit with status 1 at this verdict or a worse one: doubtful, not-identifiable")
      ->check(one_of(verdicts))
      ->type_name("VERDICT");
}

void add_seed(CLI::App& command, std::optional<std::uint64_t>& seed) {
  command
      .add_option("--seed", seed,
                  "seed of the known-truth check's simulations; default: the manifest's, or 1")
      ->check(whole_number());
  command
      .add_option_function<std::string>(
          "--resamples", [](const std::string& /*count*/) {},
          "no effect: intervals are those of the model, and nothing is resampled any more")
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
  constexpr std::size_t usual = 6;
  CLI::Option* runs =
      command
          .add_option("--truth-runs", truth_runs,
                      "simulations of what was identified, each identified again; 0: no such check")
          ->check(CLI::Range(std::size_t{0}, most))
          ->capture_default_str();
  command
      .add_flag_callback(
          "--check", [&truth_runs] { truth_runs = usual; },
          fmt::format("the known-truth check with {} simulations", usual))
      ->excludes(runs);
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
      ->check(one_of(language_codes()))
      ->type_name("CODE");
}

}  // namespace tribolog::cli
