#include "cli/identification.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "identify/identify.h"
#include "ingest/dataset/dataset_file.h"
#include "ingest/dataset/row_choice.h"
#include "ingest/manifest/manifest_file.h"
#include "joint/dataset.h"
#include "joint/degrees.h"
#include "wording/words.h"

namespace tribolog::cli {

// What became of the rows of the logs, in lines to be said.

namespace {

constexpr std::size_t longest_reason = 200;

/// A log with all recordings that are cut from it.
class Log {
 public:
  explicit Log(const joint::InputFile& input) : name_(input.name), rows_(input.rows_read) {}

  [[nodiscard]] bool is(const joint::InputFile& input) const { return input.name == name_; }

  void add(const joint::InputFile& input) {
    ++recordings_;
    used_ += input.rows_used;
    for (const joint::SkippedRows& skipped : input.skipped) {
      const auto known =
          std::find_if(skipped_.begin(), skipped_.end(),
                       [&](const joint::SkippedRows& one) { return one.reason == skipped.reason; });
      if (known == skipped_.end()) {
        skipped_.push_back(skipped);
      } else if (!ingest::dataset::is_of_whole_file(skipped)) {
        known->count += skipped.count;
      }
    }
  }

  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Windows may overlap: then rows are used more than once.
  [[nodiscard]] std::size_t used() const { return std::min(used_, rows_); }

  void tell(std::vector<std::string>& lines) const {
    const bool is_cut_up = recordings_ > 1;
    std::size_t skipped_within = 0;
    for (const joint::SkippedRows& one : skipped_) {
      if (is_cut_up && ingest::dataset::is_outside_window(one)) continue;
      skipped_within += one.count;
      lines.push_back(fmt::format("  {}: {} rows skipped: {}", printable(name_), one.count,
                                  printable(wording::words(one.reason), longest_reason)));
    }
    const std::size_t within = used_ + skipped_within;
    if (!is_cut_up || within == rows_) return;
    lines.push_back(fmt::format(
        "  {}: {} recordings; {}", printable(name_), recordings_,
        within > rows_ ? "some of their windows overlap"
                       : fmt::format("{} of {} rows are in none of them", rows_ - within, rows_)));
  }

 private:
  std::string name_;
  std::size_t rows_;
  std::size_t recordings_{};
  std::size_t used_{};
  std::vector<joint::SkippedRows> skipped_;
};

/// One line for each reason why rows were skipped, and one with all rows read and used. A log that
/// several recordings are cut from is counted once; of it, it is said how many of its rows are in
/// no recording, if any.
std::vector<std::string> row_accounts(const std::vector<joint::InputFile>& inputs) {
  std::vector<Log> logs;
  for (const joint::InputFile& input : inputs) {
    if (input.conversions.empty()) continue;  // no recording's own file: its rows are counted there
    auto log =
        std::find_if(logs.begin(), logs.end(), [&](const Log& one) { return one.is(input); });
    if (log == logs.end()) log = logs.emplace(logs.end(), input);
    log->add(input);
  }
  std::vector<std::string> lines;
  std::size_t read = 0;
  std::size_t used = 0;
  for (const Log& log : logs) {
    log.tell(lines);
    read += log.rows();
    used += log.used();
  }
  lines.push_back(fmt::format("  rows: {} read, {} used", read, used));
  return lines;
}

constexpr std::size_t longest_note = 400;  // on a terminal; the report has all of it

}  // namespace

render::workers::Prepared drawings_of(const std::string& manifest) {
  return ingest::manifest::read_manifest(manifest).manifest.robot_description.empty()
             ? render::workers::Prepared::charts
             : render::workers::Prepared::charts_and_scenes;
}

joint::Dataset load_dataset(const std::string& manifest, Console& console) {
  console.progress("reading " + printable(manifest), 0, 1);
  joint::Dataset dataset = ingest::dataset::read_dataset(manifest);
  for (const Statement& note : dataset.notes) {
    console.warn("note: " + printable(wording::words(note), longest_note));
  }
  return dataset;
}

void protect_inputs(const joint::Dataset& dataset, const std::string& manifest,
                    const std::string& output) {
  const std::filesystem::path directory = std::filesystem::path(manifest).parent_path();
  std::vector<std::string> files{manifest};
  if (dataset.robot) files.push_back((directory / dataset.manifest.robot_description).string());
  for (const joint::Recording& recording : dataset.recordings) {
    files.push_back((directory / recording.name).string());
  }
  check_output_can_be_written(output, files);
}

calibration::Calibration run_identification(const joint::Dataset& dataset,
                                            const IdentificationSettings& settings,
                                            Console& console) {
  const joint::IntervalSettings& arguments = settings.intervals;
  const joint::IntervalSettings& stated = dataset.manifest.intervals;
  identify::IdentifyOptions options;
  options.truth_runs = settings.truth_runs;
  options.resamples = arguments.resamples.value_or(stated.resamples.value_or(options.resamples));
  options.seed = arguments.seed.value_or(stated.seed.value_or(options.seed));
  if (!joint::resamples_are_allowed(options.resamples)) {
    throw UsageError(fmt::format("--resamples {} is not usable; it must be {}", options.resamples,
                                 wording::words(joint::allowed_resamples())));
  }
  return identify::identify(dataset, options, [&](const std::string& stage, int done, int all) {
    console.progress(stage, static_cast<std::size_t>(done), static_cast<std::size_t>(all));
  });
}

std::vector<calibration::Setting> interval_configuration(
    const method::intervals::IntervalsResult& intervals) {
  if (intervals.resamples == 0) return {{{"setting.resamples"}, {"setting.closed_forms"}}};
  return {{{"setting.resamples"}, Statement::verbatim(std::to_string(intervals.resamples))},
          {{"setting.seed"}, Statement::verbatim(std::to_string(intervals.seed))}};
}

void tell_outcome(const calibration::Calibration& c, Console& console) {
  const auto say = [&](const std::string& name, const statistics::Estimate& e, double factor,
                       const char* unit) {
    const statistics::Estimate s = statistics::scaled(e, factor);
    console.say(fmt::format("  {:<34} {:.6g} {} (95 %: {:.6g} to {:.6g})", name, s.value, unit,
                            s.low, s.high));
  };
  console.say(fmt::format("verdict: {} - {}", calibration::to_string(c.judgement.verdict),
                          wording::words(c.judgement.sentence)));
  for (const method::checks::DataCheck* check :
       c.data_checks.in_state(method::checks::CheckState::fails)) {
    console.say(
        printable(fmt::format("  check fails: {}: {}", wording::words_for("check", check->name),
                              wording::words(check->found)),
                  600));
  }
  for (const calibration::QuantityVerdict& quantity : c.judgement.quantities) {
    if (quantity.verdict == calibration::Verdict::usable || !quantity.decides) continue;
    console.say(printable(fmt::format("  {}: {}: {}", calibration::to_string(quantity.verdict),
                                      wording::words_for("quantity", quantity.key),
                                      wording::words(quantity.reasons.front())),
                          600));
  }
  const double n = c.manifest.drive.gear_ratio();
  if (c.q_peak_rad)
    say("gravity peak at joint angle", *c.q_peak_rad, joint::degrees_per_rad, "deg");
  if (const method::hysteresis::SurrogateMass* mass = c.masses.find(c.selection.recommended)) {
    say("surrogate mass, " + mass->estimator, mass->mass_kg, 1, "kg");
    say("gravity torque at the joint", mass->gravity_Nm, n, "N·m");
  }
  if (const auto& line = c.friction.coulomb_viscous) {
    say("Coulomb torque at the joint", line->coulomb_Nm, n, "N·m");
  }
  for (const std::string& line : row_accounts(c.inputs)) console.say(line);
}

ExitStatus status_of(const calibration::Calibration& calibration,
                     const std::optional<calibration::Verdict>& fail_on) {
  const bool fails =
      fail_on && static_cast<int>(calibration.judgement.verdict) >= static_cast<int>(*fail_on);
  return fails ? ExitStatus::verdict_failed : ExitStatus::done;
}

}  // namespace tribolog::cli
