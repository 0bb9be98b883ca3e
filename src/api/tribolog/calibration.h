#pragma once
// A calibration: what was found out about a joint, with intervals and verdicts. Made by identifying
// a dataset, or read from the JSON of one.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tribolog/dataset.h"
#include "tribolog/export.h"
#include "tribolog/values.h"

namespace tribolog {

/// It never changes. Copies share it and cost nothing; any number of threads may use it at once.
///
/// Where a language is asked for there is no such one: Failure usage. Words are as in the file
/// where it is of a program that did not write codes beside them.
class TRIBOLOG_EXPORT Calibration {
 public:
  /// Of the text that to_json() gives, by this version or an older one.
  /// @param name of the file, for messages.
  /// @throw Failure input_refused: no JSON, no calibration, or one that says something impossible.
  static Calibration from_json(const std::string& json,
                               const std::string& name = "calibration.json");
  /// The same, of a file. @throw Failure input_refused: also where it cannot be read.
  static Calibration read(const std::string& path);

  /// UTF-8, indented, ends with a line feed; schema "tribolog-calibration-1"
  /// (share/tribolog/calibration.schema.json). What was read is given back byte for byte.
  [[nodiscard]] const std::string& to_json() const;
  /// Writes it as a file that is either whole or what it was before. @throw Failure output_failed
  void write(const std::string& path) const;

  [[nodiscard]] Joint joint() const;
  /// Over all quantities that decide.
  [[nodiscard]] Verdict verdict() const;
  /// Why, in a sentence.
  [[nodiscard]] Message sentence(const std::string& language = "en") const;
  /// What whoever uses the numbers has to know, the weightiest first.
  [[nodiscard]] std::vector<Message> findings(const std::string& language = "en") const;

  /// All results, in the report's order.
  [[nodiscard]] std::vector<Quantity> quantities(const std::string& language = "en") const;
  /// The one of that name; nothing if there is none.
  [[nodiscard]] std::optional<Quantity> quantity(const std::string& name,
                                                 const std::string& language = "en") const;
  /// By which of the ways to gravity the mass was found, "midline"; empty: none was.
  [[nodiscard]] std::string estimator() const;

  [[nodiscard]] std::vector<Check> checks(const std::string& language = "en") const;
  [[nodiscard]] std::vector<Stage> stages(const std::string& language = "en") const;
  [[nodiscard]] std::vector<InputFile> inputs(const std::string& language = "en") const;

  /// Whether it has its recordings at hand, which report and figures show. One that was read from
  /// JSON has not: identify its dataset again.
  [[nodiscard]] bool has_recordings() const;

 private:
  struct Contents;
  friend struct api::Inside;
  TRIBOLOG_HIDDEN explicit Calibration(std::shared_ptr<const Contents> contents);
  std::shared_ptr<const Contents> contents_;
};

struct IdentifyOptions {
  /// Of the bootstrap behind the intervals: 0 (closed forms), or 100 to 1 000 000. Absent: the
  /// manifest's, or 1000.
  std::optional<std::uint64_t> resamples;
  /// Of everything random: the same dataset and seed give the same numbers on every machine.
  /// Absent: the manifest's, or 1.
  std::optional<std::uint64_t> seed;
  /// Simulations of what was identified, each identified again, to see whether it comes back; 0:
  /// no such check.
  std::size_t truth_runs{0};
  /// 0: one for each core. Changes no number.
  std::size_t threads{0};
  /// Of the program, its name first: stands in the calibration as what made it, without directories
  /// of absolute paths. May be empty.
  std::vector<std::string> command_line;
  Progress progress;
};

/// The whole method. What the recordings do not show is no failure: its quantity says so, with what
/// to record. Starts threads of its own, which end before it returns.
/// The time in the calibration is the clock's, or that of the environment variable
/// SOURCE_DATE_EPOCH, for the same bytes twice.
/// @throw Failure usage: resamples or SOURCE_DATE_EPOCH cannot be used.
TRIBOLOG_EXPORT Calibration identify_joint(const Dataset& dataset,
                                           const IdentifyOptions& options = {});

}  // namespace tribolog
