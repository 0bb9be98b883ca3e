// `tribolog archive report` and `tribolog review`: reports out of the archive, with what reviewers
// decided on them.

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/store/calibration_archive.h"
#include "archive/store/digest.h"
#include "base/atomic_file.h"
#include "base/encodings.h"
#include "base/error.h"
#include "base/input_file.h"
#include "calibration/provenance.h"
#include "calibration/read_calibration.h"
#include "cli/archive_commands.h"
#include "cli/remarks_file.h"
#include "cli/shared_options.h"
#include "report/document/sign_off.h"
#include "report/engine/embedded_json.h"

namespace tribolog::cli {
namespace {

/// As it was archived, byte for byte. @throw UsageError: the entry has no report. ArchiveError: it
/// is not what was archived.
std::string original_report(archive::store::CalibrationArchive& kept,
                            const calibration::Entry& entry) {
  auto bytes = kept.document(entry, calibration::DocumentKind::report);
  if (!bytes) {
    throw UsageError(entry.id.substr(0, calibration::shown_digits) +
                     " has no report in the archive; tribolog report --archive keeps one");
  }
  return std::move(*bytes);
}

/// Its bytes as they were archived where nobody decided; else with all decisions.
/// @param further decisions that are not in the archive yet.
/// @throw as original_report().
std::string signed_report(archive::store::CalibrationArchive& kept, const calibration::Entry& entry,
                          const std::vector<calibration::Review>& further = {}) {
  std::vector<calibration::Review> reviews = kept.reviews(entry);
  reviews.insert(reviews.end(), further.begin(), further.end());
  std::string page = original_report(kept, entry);
  if (reviews.empty()) return page;
  std::vector<report::document::SignOff> decisions;
  for (const calibration::Review& review : reviews) {
    decisions.push_back({review.at_utc, review.reviewer,
                         review.decision == calibration::Review::Decision::approved, review.note});
  }
  return report::document::with_sign_off(page, entry.id, decisions, kept.name());
}

}  // namespace

// `tribolog archive report`.

Run add_archive_report(CLI::App& archive) {
  struct Options {
    std::string id;
    std::string output;
    std::string calibration;
    bool original{false};
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *archive.add_subcommand("report", "the report of one calibration, as it was made");
  command.add_option("ID", options->id, "the first digits of its id")->required();
  command.add_option("-o,--output", options->output, "report (HTML) to write")->check(page_file());
  command.add_option("--calibration", options->calibration, "calibration (JSON) to write");
  command.add_flag("--original", options->original,
                   "byte for byte, without the decisions of reviewers");
  const auto where = add_archive_options(command);
  return [where, options](const Invocation& call) {
    if (options->output.empty() && options->calibration.empty()) {
      throw UsageError("archive report: -o REPORT or --calibration FILE is needed");
    }
    where->protect_from(options->output);
    where->protect_from(options->calibration);
    check_outputs_differ({options->output, options->calibration});
    for (const std::string& output : {options->output, options->calibration}) {
      call.console.make_way_for(output);
    }
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    const calibration::Entry entry = kept.find(options->id);
    AtomicFiles files;
    if (!options->output.empty()) {
      files.add(options->output,
                options->original ? original_report(kept, entry) : signed_report(kept, entry));
    }
    if (!options->calibration.empty()) {
      const auto bytes = kept.document(entry, calibration::DocumentKind::calibration);
      if (!bytes)
        throw ArchiveError(printable(kept.name(), longest_path) + ": its calibration is missing");
      files.add(options->calibration, *bytes);
    }
    files.commit();
    const auto tell = [&](const char* what, const std::string& path) {
      if (!path.empty()) call.console.say(what + (": " + printable(path, longest_path)));
    };
    tell("report", options->output);
    tell("calibration", options->calibration);
    return ExitStatus::done;
  };
}

// `tribolog review`.

namespace {

struct ReviewOptions {
  std::string report;
  std::string reviewer;
  std::string note;
  std::string remarks;
  std::string output;
  bool approve{false};
  bool reject{false};
};

bool is_file(const std::string& name) {
  std::error_code error;
  return std::filesystem::exists(name, error);
}

/// The same inputs may be archived with a report made at another time.
std::string hint_for(archive::store::CalibrationArchive& kept, const std::string& page,
                     const std::string& path) {
  const calibration::NewCalibration made =
      calibration::entry_of_calibration(report::engine::embedded_json(page, path).json, path);
  const std::string identity = archive::store::identity_of(made.inputs);
  const calibration::JointName& of = made.facts.of;
  for (const calibration::Entry& entry : kept.list({of.robot, of.serial, of.joint})) {
    if (entry.identity != identity) continue;
    const std::string id = entry.id.substr(0, calibration::shown_digits);
    return fmt::format(
        "the archive has another report of these inputs: tribolog archive report {} "
        "-o FILE gives it, tribolog review {} decides on it",
        id, id);
  }
  return "tribolog archive add CALIBRATION --report REPORT keeps it; --archive names another "
         "archive";
}

calibration::Entry entry_of_report(archive::store::CalibrationArchive& kept,
                                   const std::string& path) {
  const std::string page = report::document::without_sign_off(read_file(path));
  if (const auto entry = kept.find_report(sha256_hex(page))) return *entry;
  throw InputError({path, 0, 0}, {"this report is not in the archive", "",
                                  "one that it contains, unchanged", hint_for(kept, page, path)});
}

/// The note, and below it the remarks, one a line.
std::string note_of(const ReviewOptions& options, archive::store::CalibrationArchive& kept,
                    const calibration::Entry& entry) {
  if (options.remarks.empty()) return options.note;
  const std::vector<Remark> remarks =
      read_remarks(options.remarks, report_number(original_report(kept, entry), kept.name()));
  std::string note = options.note;
  for (std::size_t k = 0; k < remarks.size(); ++k) {
    if (!note.empty()) note += "\n";
    note += fmt::format("[{}] {}: {}", k + 1, remarks[k].place, remarks[k].text);
  }
  return note;
}

}  // namespace

Run add_review(CLI::App& app) {
  const auto options = std::make_shared<ReviewOptions>();
  CLI::App& command = *app.add_subcommand("review", "approve or reject an archived report");
  command.add_option("REPORT", options->report, "the report (HTML), or the id of its calibration")
      ->required();
  auto* const approve = command.add_flag("--approve", options->approve, "the report is good");
  command.add_flag("--reject", options->reject, "it is not")->excludes(approve);
  command.add_option("--reviewer", options->reviewer, "who decides")->required();
  command.add_option("--note", options->note, "reason or condition");
  command.add_option("--remarks", options->remarks,
                     "remarks on points of the loops (JSON), as the report's viewer saves them");
  command
      .add_option("-o,--output", options->output,
                  "report with the decision (HTML) to write; default: the report itself")
      ->check(page_file());
  const auto where = add_archive_options(command);
  command.footer(
      "\nThe decision is kept in the archive with reviewer and time, after earlier ones; none "
      "is\never changed. Reports written from then on show it; `tribolog archive report "
      "ID\n--original` gives the report as it was made, byte for byte.");
  return [where, options](const Invocation& call) {
    if (options->approve == options->reject)
      throw UsageError("tribolog review: either --approve or --reject is needed");
    if (options->reviewer.find_first_not_of(" \t") == std::string::npos)
      throw UsageError("tribolog review: --reviewer is empty");
    const bool is_report = is_file(options->report);
    const std::string output =
        options->output.empty() && is_report ? options->report : options->output;
    where->protect_from(output);
    if (!options->remarks.empty()) check_output_can_be_written(output, {options->remarks});
    call.console.make_way_for(output);
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::write);
    const calibration::Entry entry =
        is_report ? entry_of_report(kept, options->report) : kept.find(options->report);
    const calibration::Review review{calibration::make_provenance({}).created_utc,
                                     options->reviewer,
                                     options->approve ? calibration::Review::Decision::approved
                                                      : calibration::Review::Decision::rejected,
                                     note_of(*options, kept, entry)};
    // Before the decision is kept: a report that cannot be written keeps none.
    const std::string page = output.empty() ? "" : signed_report(kept, entry, {review});
    AtomicFiles files;
    if (!output.empty()) files.add(output, page);
    kept.add_review(entry, review);
    files.commit();
    call.console.say(fmt::format("{} {} by {}", entry.id.substr(0, calibration::shown_digits),
                                 calibration::to_string(review.decision),
                                 printable(review.reviewer)));
    if (!output.empty()) {
      call.console.say("report: " + printable(output, longest_path));
    }
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
