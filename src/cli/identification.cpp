#include "cli/identification.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "calibration/friction_speeds.h"
#include "joint/degrees.h"
#include "wording/rounding.h"
#include "wording/words.h"

namespace tribolog::cli {

// What became of the rows of the logs, in lines to be said.

namespace {

constexpr std::size_t longest_reason = 200;

/// Rows of another recording, of another time or told apart by what they say: with a file of
/// several recordings, most of them.
bool is_outside_window(const SkippedRows& skipped) {
  return skipped.reason.code == "skipped.outside_window" ||
         skipped.reason.code == "skipped.other_recording";
}

/// Rows that every recording of the file lacks, whatever its window.
bool is_of_whole_file(const SkippedRows& skipped) {
  return skipped.reason.code == "skipped.cut_off" || skipped.reason.code == "skipped.not_usable";
}

/// A log with all recordings that are cut from it.
class Log {
 public:
  explicit Log(const InputFile& input) : name_(input.name), rows_(input.rows_read) {}

  [[nodiscard]] bool is(const InputFile& input) const { return input.name == name_; }

  void add(const InputFile& input) {
    ++recordings_;
    used_ += input.rows_used;
    for (const SkippedRows& skipped : input.skipped) {
      const auto known = std::find_if(
          skipped_.begin(), skipped_.end(),
          [&](const SkippedRows& one) { return one.reason.words == skipped.reason.words; });
      if (known == skipped_.end()) {
        skipped_.push_back(skipped);
      } else if (!is_of_whole_file(skipped)) {
        known->rows += skipped.rows;
      }
    }
  }

  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Windows may overlap: then rows are used more than once.
  [[nodiscard]] std::size_t used() const { return std::min(used_, rows_); }

  void tell(std::vector<std::string>& lines) const {
    const bool is_cut_up = recordings_ > 1;
    std::size_t skipped_within = 0;
    for (const SkippedRows& one : skipped_) {
      if (is_cut_up && is_outside_window(one)) continue;
      skipped_within += one.rows;
      lines.push_back(fmt::format("  {}: {} rows skipped: {}", printable(name_), one.rows,
                                  printable(one.reason.words, longest_reason)));
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
  std::vector<SkippedRows> skipped_;
};

/// One line for each reason why rows were skipped, and one with all rows read and used. A log that
/// several recordings are cut from is counted once; of it, it is said how many of its rows are in
/// no recording, if any.
std::vector<std::string> row_accounts(const std::vector<InputFile>& inputs) {
  std::vector<Log> logs;
  for (const InputFile& input : inputs) {
    if (!input.is_recording) continue;  // no recording's own file: its rows are counted there
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

constexpr std::size_t longest_reading_note = 400;  // on a terminal; the report has all of it
constexpr std::size_t longest_finding = 600;

}  // namespace

Progress progress_on(Console& console) {
  return [&console](const std::string& what, std::size_t done, std::size_t all) {
    console.progress(what, done, all);
  };
}

Dataset load_dataset(const DatasetChoice& choice, Console& console) {
  console.progress("reading " + printable(choice.manifest), 0, 1);
  Dataset dataset = Dataset::read(choice.manifest, choice.joint);
  tell_notes(dataset, "", console);
  return dataset;
}

void tell_notes(const Dataset& dataset, const std::string& before, Console& console) {
  for (const Message& note : dataset.notes()) {
    console.warn(before + "note: " + printable(note.words, longest_reading_note));
  }
}

void protect_inputs(const Dataset& dataset, const std::string& output) {
  check_output_can_be_written(output, dataset.files());
}

IdentifyOptions options_of(const IdentificationSettings& settings) {
  IdentifyOptions options;
  options.seed = settings.seed;
  options.truth_runs = settings.truth_runs;
  options.command_line = settings.arguments;
  return options;
}

Calibration run_identification(const Dataset& dataset, const IdentificationSettings& settings,
                               Console& console) {
  IdentifyOptions options = options_of(settings);
  options.progress = progress_on(console);
  return identify_joint(dataset, options);
}

namespace {

/// "0.05 rad/s: 12.3 ± 0.4 N·m, doubtful"
std::string friction_words(const FrictionAtSpeed& f, const std::string& unit) {
  const std::string at =
      wording::without_exponent(fmt::format("{:.3g}", f.speed_at_joint_rad_s)) + " rad/s: ";
  if (f.verdict == Verdict::not_identifiable) return at + "not identifiable";
  const Estimate& e = f.torque_at_joint;
  const wording::RoundedEstimate rounded =
      wording::round_by_interval({e.value, e.low, e.high, {}}, wording::plain_scale(unit));
  const bool is_lopsided = rounded.half_width.empty() && !rounded.range().empty();
  return at + rounded.plus_minus() + " " + unit +
         (is_lopsided ? " (" + rounded.range() + ")" : "") +
         (f.verdict == Verdict::doubtful ? ", doubtful" : "");
}

/// Of the speeds that the manifest states, or of three; empty: there are none.
std::string friction_line(const Calibration& calibration) {
  constexpr std::size_t speeds_of_a_line = 3;
  const std::vector<FrictionAtSpeed> all = calibration.friction_at_speeds();
  const std::string unit = calibration.joint().torque_is_in_amperes ? "A" : "N·m";
  std::vector<double> speeds_rad_s;
  std::vector<std::string> words;
  for (const FrictionAtSpeed& f : all) {
    speeds_rad_s.push_back(f.speed_rad_s);
    if (f.is_stated) words.push_back(friction_words(f, unit));
  }
  if (words.empty()) {
    for (const std::size_t k : calibration::evenly_in_log(speeds_rad_s, speeds_of_a_line)) {
      words.push_back(friction_words(all[k], unit));
    }
  }
  if (words.empty()) return "";
  return fmt::format("  {:<34} {}", "friction at the joint at", fmt::join(words, "; "));
}

}  // namespace

void tell_outcome(const Calibration& calibration, Console& to) {
  to.say(fmt::format("verdict: {} - {}", code_of(calibration.verdict()),
                     calibration.sentence().words));
  for (const Check& check : calibration.checks()) {
    if (check.state != Check::State::fails) continue;
    to.say(printable(fmt::format("  check fails: {}: {}", check.words, check.found.words),
                     longest_finding));
  }
  for (const Quantity& quantity : calibration.quantities()) {
    if (quantity.verdict == Verdict::usable || !quantity.decides) continue;
    to.say(printable(fmt::format("  {}: {}: {}", code_of(quantity.verdict), quantity.words,
                                 quantity.reasons.front().words),
                     longest_finding));
  }
  const auto say = [&](const char* quantity, const std::string& name) {
    const std::optional<Quantity> found = calibration.quantity(quantity);
    if (!found || !found->at_joint || found->verdict == Verdict::not_identifiable) return;
    if (found->verdict == Verdict::doubtful && !found->decides) return;
    const Estimate& e = *found->at_joint;
    const bool is_angle = found->unit == "rad";
    const double factor = is_angle ? joint::degrees_per_rad : 1;
    using wording::six_digits;
    to.say(fmt::format("  {:<34} {} {} (95 %: {} to {}){}", name, six_digits(factor * e.value),
                       is_angle ? "deg" : found->unit, six_digits(factor * e.low),
                       six_digits(factor * e.high),
                       found->verdict == Verdict::doubtful ? ", doubtful" : ""));
  };
  say("cog_angle", "gravity peak at joint angle");
  say("surrogate_mass", "surrogate mass, " + calibration.estimator());
  say("gravity_torque", "gravity torque at the joint");
  say("coulomb_torque", "Coulomb torque at the joint");
  if (const std::string line = friction_line(calibration); !line.empty()) to.say(line);
  for (const std::string& line : row_accounts(calibration.inputs())) to.say(line);
}

ExitStatus status_of(const Calibration& calibration, const std::optional<Verdict>& fail_on) {
  const bool fails =
      fail_on && static_cast<int>(calibration.verdict()) >= static_cast<int>(*fail_on);
  return fails ? ExitStatus::verdict_failed : ExitStatus::done;
}

}  // namespace tribolog::cli
