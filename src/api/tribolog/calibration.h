#pragma once
// A calibration: what was identified about a joint, with intervals and verdicts. Made by
// identifying a dataset, or read from the JSON of an earlier calibration.

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

/// Immutable. Copies share the contents and cost nothing; any number of threads may use it at once.
///
/// Functions that take a language throw Failure usage if it does not exist. Words are taken from
/// the file as they are if the program that wrote it did not store codes with them.
class TRIBOLOG_EXPORT Calibration {
 public:
  /// From the text that to_json() returns, of this version or an older one.
  /// @param name of the file, for messages.
  /// @throw Failure input_refused: not JSON, not a calibration, or one with impossible contents.
  static Calibration from_json(const std::string& json,
                               const std::string& name = "calibration.json");
  /// The same, from a file. @throw Failure input_refused: also if it cannot be read.
  static Calibration read(const std::string& path);

  /// UTF-8, indented, ends with a line feed; schema "tribolog-calibration-1"
  /// (share/tribolog/calibration.schema.json). What was read is returned byte for byte.
  [[nodiscard]] const std::string& to_json() const;
  /// Writes it atomically: the file is either complete or unchanged. @throw Failure output_failed
  void write(const std::string& path) const;

  [[nodiscard]] Joint joint() const;
  /// Overall, from all quantities that decide.
  [[nodiscard]] Verdict verdict() const;
  /// The reason, in one sentence.
  [[nodiscard]] Message sentence(const std::string& language = "en") const;
  /// What users of the numbers have to know, most important first.
  [[nodiscard]] std::vector<Message> findings(const std::string& language = "en") const;

  /// All results, in the report's order.
  [[nodiscard]] std::vector<Quantity> quantities(const std::string& language = "en") const;
  /// The quantity of that name, if there is one.
  [[nodiscard]] std::optional<Quantity> quantity(const std::string& name,
                                                 const std::string& language = "en") const;
  /// Friction at speeds from the slowest to the fastest that were measured, rising; for
  /// feed-forward and simulation. Empty if none was measured, or by an older file.
  [[nodiscard]] std::vector<FrictionAtSpeed> friction_at_speeds(
      const std::string& language = "en") const;
  /// The estimator that gave the mass, e.g. "midline"; empty if no mass was found.
  [[nodiscard]] std::string estimator() const;

  [[nodiscard]] std::vector<Check> checks(const std::string& language = "en") const;
  [[nodiscard]] std::vector<Stage> stages(const std::string& language = "en") const;
  [[nodiscard]] std::vector<InputFile> inputs(const std::string& language = "en") const;

  /// Whether the recordings are available, which report and figures need. A calibration read from
  /// JSON does not have them: identify its dataset again.
  [[nodiscard]] bool has_recordings() const;

 private:
  struct Contents;
  friend struct api::Inside;
  TRIBOLOG_HIDDEN explicit Calibration(std::shared_ptr<const Contents> contents);
  std::shared_ptr<const Contents> contents_;
};

struct IdentifyOptions {
  /// Seed of everything random: the same dataset and seed give the same numbers on every machine.
  /// Default: as in the manifest, or 1.
  std::optional<std::uint64_t> seed;
  /// Number of simulations in the known-truth check: what was identified is simulated and
  /// identified again, to see whether it is recovered. 0: no such check.
  std::size_t truth_runs{0};
  /// 0: one per core. Does not affect the numbers.
  std::size_t threads{0};
  /// Command line of the program, its name first: recorded in the calibration as its origin, with
  /// the directories of absolute paths removed. May be empty.
  std::vector<std::string> command_line;
  Progress progress;
};

/// Runs the whole method. A result that the recordings do not show is not a failure: its quantity
/// says so, and what to record. Starts its own threads, which end before it returns.
/// The time in the calibration is that of the clock or, for reproducible output, of the environment
/// variable SOURCE_DATE_EPOCH.
/// @throw Failure usage: SOURCE_DATE_EPOCH cannot be used.
TRIBOLOG_EXPORT Calibration identify_joint(const Dataset& dataset,
                                           const IdentifyOptions& options = {});

}  // namespace tribolog
