// `tribolog show` and `tribolog archive show`: a calibration on the console, whether it comes from
// a file or from an archive.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/store/archive_json.h"
#include "base/error.h"
#include "base/input_file.h"
#include "calibration/archived_calibration.h"
#include "calibration/read_calibration.h"
#include "cli/archive_commands.h"
#include "cli/commands.h"
#include "inspect/survey/text_table.h"
#include "report/embedded_json.h"
#include "wording/rounding.h"

namespace tribolog::cli {
namespace {

/// One line for each fact that is stated. @param id empty: it has none. @param revision 1: the only
/// one.
std::string facts_text(const calibration::Facts& f, const std::string& id, int revision) {
  inspect::survey::TextTable table(0);
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) table.add({name, printable(text, 400)});
  };
  const auto number = [](const std::optional<double>& value, const char* unit) {
    return value ? wording::six_digits(*value) + " " + unit : "";
  };
  add("id", id);
  add("robot", f.of.robot);
  add("serial", f.of.serial);
  add("joint", f.of.joint);
  add("measured", f.time_is_stated ? f.measured_at : "");
  add("measured on", f.time_is_stated ? "" : f.measured_on);
  add("identified", f.created_utc);
  add("operator", f.operator_name);
  add("temperature", number(f.temperature_C, "°C"));
  add("payload", f.payload);
  add("payload mass", number(f.payload_kg, "kg"));
  add("gear ratio", fmt::format("{:.6g}", f.gear_ratio));
  add("sampling rate", number(f.sampling_Hz, "Hz"));
  add("note", f.note);
  add("verdict", calibration::to_string(f.verdict) + ": " + f.sentence);
  add("revision", revision > 1 ? std::to_string(revision) : "");
  add("tribolog", f.tool_version + " (" + f.git_revision + ")");
  return table.text();
}

/// Value, interval, unit and verdict of each: SI, motor side.
std::string quantities_text(const std::vector<calibration::Quantity>& quantities) {
  inspect::survey::TextTable table(0);
  table.add({"quantity", "value", "95 %", "unit", "verdict"});
  for (const calibration::Quantity& q : quantities) {
    const auto& e = q.estimate;
    table.add(
        {printable(q.words), e ? wording::six_digits(e->value) : "",
         e ? fmt::format("{} to {}", wording::six_digits(e->low), wording::six_digits(e->high))
           : "",
         printable(q.unit), calibration::to_string(q.verdict)});
  }
  return table.text();
}

// `tribolog archive show`.

std::string documents_text(const std::vector<archive::store::StoredDocument>& documents) {
  static const char* const kinds[] = {"calibration", "report", "input"};
  inspect::survey::TextTable table(0);
  table.add({"kept", "bytes", "stored", "SHA-256"});
  for (const archive::store::StoredDocument& d : documents) {
    const std::string kind = kinds[static_cast<std::size_t>(d.kind)];
    table.add({d.name.empty() ? kind : printable(d.name), std::to_string(d.bytes),
               std::to_string(d.stored_bytes),
               d.sha256.substr(0, 2 * calibration::shown_digits) + "..."});
  }
  return table.text();
}

std::string reviews_text(const std::vector<calibration::Review>& reviews) {
  if (reviews.empty()) return "";
  inspect::survey::TextTable table(0);
  table.add({"decision", "by", "at", "note"});
  for (const calibration::Review& review : reviews) {
    table.add({calibration::to_string(review.decision), printable(review.reviewer), review.at_utc,
               printable(review.note, 400)});
  }
  return "\n" + table.text();
}

}  // namespace

Run add_show(CLI::App& archive) {
  struct Options {
    std::string id;
    bool json{false};
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = *archive.add_subcommand("show", "one calibration: its numbers and facts");
  command.add_option("ID", options->id, "the first digits of its id")->required();
  const auto where = add_archive_options(command);
  command.add_flag("--json", options->json, "as JSON, to standard output");
  return [where, options](const Invocation& call) {
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    const calibration::Entry entry = kept.find(options->id);
    const auto quantities = kept.quantities(entry);
    const auto documents = kept.documents(entry);
    const auto reviews = kept.reviews(entry);
    if (options->json) {
      print_json(
          archive::store::entry_json(entry, quantities, kept.inputs(entry), documents, reviews));
    } else {
      call.console.say(facts_text(entry.facts, entry.id, entry.revision) + "\n" +
                       quantities_text(quantities) + "\n" + documents_text(documents) +
                       reviews_text(reviews));
    }
    return ExitStatus::done;
  };
}

// `tribolog show`.

namespace {

constexpr const char* result_element = "tribolog-result";

/// A calibration as it is, or what a page carries.
report::EmbeddedJson numbers_of(const std::string& text, const std::string& file) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] == '{') return {result_element, text};
  return report::embedded_json(text, file);
}

}  // namespace

std::string calibration_in(const std::string& file) {
  report::EmbeddedJson numbers = numbers_of(read_file(file), file);
  if (numbers.element == result_element) return std::move(numbers.json);
  throw UsageError(fmt::format("{}: the page contains {}, and no calibration",
                               printable(file, longest_path), numbers.element));
}

CLI::App& add_show(CLI::App& app, ShowOptions& show) {
  CLI::App& command =
      *app.add_subcommand("show", "the numbers of a report, read from the report itself");
  command.add_option("FILE", show.file, "report (HTML) or calibration (JSON)")->required();
  command.add_flag("--json", show.json, "all of them as JSON, to standard output");
  command.footer(
      "\nEvery tribolog page embeds its numbers as JSON; --json returns them as they\nare. Values "
      "are SI, torques at the motor.");
  return command;
}

ExitStatus run_show(const ShowOptions& options, Console& console) {
  const report::EmbeddedJson numbers = numbers_of(read_file(options.file), options.file);
  if (numbers.element != result_element) {
    if (!options.json) {
      throw UsageError(fmt::format("{}: the page contains {}, which only --json shows",
                                   printable(options.file, longest_path), numbers.element));
    }
    print_json(numbers.json);
    return ExitStatus::done;
  }
  const calibration::NewCalibration made =
      calibration::entry_of_calibration(numbers.json, options.file);
  if (options.json) {
    print_json(numbers.json);
  } else {
    console.say(facts_text(made.facts, "", 1) + "\n" + quantities_text(made.quantities));
  }
  return ExitStatus::done;
}

}  // namespace tribolog::cli
