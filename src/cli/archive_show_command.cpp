#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/store/archive_json.h"
#include "cli/archive_commands.h"
#include "cli/calibration_text.h"
#include "inspect/survey/text_table.h"

namespace tribolog::cli {
namespace {

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

}  // namespace tribolog::cli
