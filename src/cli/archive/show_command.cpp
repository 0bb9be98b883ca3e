#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/archive_json.h"
#include "inspect/text_table.h"

#include "cli/archive/archive_commands.h"

namespace tribolog::cli {
namespace {

using namespace archive;

std::string facts_text(const Entry& entry) {
  const Facts& f = entry.facts;
  TextTable table(0);
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) table.add({name, printable(text, 400)});
  };
  const auto number = [](const std::optional<double>& value, const char* unit) {
    return value ? fmt::format("{:.6g} {}", *value, unit) : "";
  };
  add("id", entry.id);
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
  add("verdict", to_string(f.verdict) + ": " + f.sentence);
  add("revision", entry.revision > 1 ? std::to_string(entry.revision) : "");
  add("tribolog", f.tool_version + " (" + f.git_revision + ")");
  return table.text();
}

std::string quantities_text(const std::vector<Quantity>& quantities) {
  TextTable table(0);
  table.add({"quantity", "value", "95 %", "unit", "verdict"});
  for (const Quantity& q : quantities) {
    const auto& e = q.estimate;
    table.add({printable(q.words), e ? fmt::format("{:.6g}", e->value) : "",
               e ? fmt::format("{:.6g} to {:.6g}", e->low, e->high) : "", printable(q.unit),
               to_string(q.verdict)});
  }
  return table.text();
}

std::string documents_text(const std::vector<StoredDocument>& documents) {
  static const char* const kinds[] = {"calibration", "report", "input"};
  TextTable table(0);
  table.add({"kept", "bytes", "stored", "SHA-256"});
  for (const StoredDocument& d : documents) {
    const std::string kind = kinds[static_cast<std::size_t>(d.kind)];
    table.add({d.name.empty() ? kind : printable(d.name), std::to_string(d.bytes),
               std::to_string(d.stored_bytes), d.sha256.substr(0, 2 * shown_digits) + "..."});
  }
  return table.text();
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
    CalibrationArchive kept = where->open(sql::Access::read);
    const Entry entry = kept.find(options->id);
    const auto quantities = kept.quantities(entry);
    const auto documents = kept.documents(entry);
    if (options->json) {
      print_json(entry_json(entry, quantities, kept.inputs(entry), documents));
    } else {
      call.console.say(facts_text(entry) + "\n" + quantities_text(quantities) + "\n" +
                       documents_text(documents));
    }
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
