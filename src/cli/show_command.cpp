// `tribolog show` and `tribolog archive show`: a calibration on the console, whether it comes from
// a file or from an archive.

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "archive/store/archive_json.h"
#include "base/enum_text.h"
#include "base/error.h"
#include "base/input_file.h"
#include "calibration/archived_calibration.h"
#include "calibration/friction_speeds.h"
#include "calibration/read_calibration.h"
#include "cli/archive_commands.h"
#include "cli/commands.h"
#include "cli/given_files.h"
#include "inspect/survey/text_table.h"
#include "report/engine/embedded_json.h"
#include "wording/rounding.h"

namespace tribolog::cli {
namespace {

struct ShowOptions {
  std::string file;  ///< A report or another page (HTML), or a calibration (JSON).
  bool json{false};
};

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

/// Value, interval, unit and verdict of each: SI, motor side. Friction has a table of its own.
std::string quantities_text(const std::vector<calibration::Quantity>& quantities) {
  inspect::survey::TextTable table(0);
  table.add({"quantity", "value", "95 %", "unit", "verdict"});
  for (const calibration::Quantity& q : quantities) {
    if (calibration::speed_of_friction(q.name)) continue;
    const auto& e = q.estimate;
    table.add(
        {printable(q.words), e ? wording::six_digits(e->value) : "",
         e ? fmt::format("{} to {}", wording::six_digits(e->low), wording::six_digits(e->high))
           : "",
         printable(q.unit), calibration::to_string(q.verdict)});
  }
  return table.text();
}

/// Friction at a few of its speeds, SI, motor side; empty: the calibration has none.
std::string friction_text(const calibration::RecordedCurves& curves) {
  constexpr std::size_t shown_speeds = 10;
  const auto& all = curves.friction_at_speed;
  if (all.empty()) return "";
  const bool is_ampere = curves.torque_unit == joint::TorqueUnit::ampere;
  inspect::survey::TextTable table(0);
  table.add({"friction at rad/s", is_ampere ? "A" : "N·m", "95 %", "verdict"});
  for (const calibration::FrictionAtSpeed& f : calibration::of_a_table(all, shown_speeds)) {
    table.add({wording::without_exponent(fmt::format("{:.3g}", f.speed_rad_s)),
               wording::six_digits(f.torque_Nm.value),
               fmt::format("{} to {}", wording::six_digits(f.torque_Nm.low),
                           wording::six_digits(f.torque_Nm.high)),
               calibration::to_string(f.verdict)});
  }
  return "\n" + table.text();
}

// `tribolog archive show`.

std::string documents_text(const std::vector<archive::store::StoredDocument>& documents) {
  inspect::survey::TextTable table(0);
  table.add({"kept", "bytes", "stored", "SHA-256"});
  for (const archive::store::StoredDocument& d : documents) {
    const std::string kind = own_name(d.kind);
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

Run add_archive_show(CLI::App& archive) {
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
      const std::string json =
          kept.document(entry, calibration::DocumentKind::calibration).value_or("");
      call.console.say(facts_text(entry.facts, entry.id, entry.revision) + "\n" +
                       quantities_text(quantities) + friction_text(calibration::read_curves(json)) +
                       "\n" + documents_text(documents) + reviews_text(reviews));
    }
    return ExitStatus::done;
  };
}

// `tribolog show`.

namespace {

constexpr const char* robot_element = "tribolog-robot";

/// Of a directory that a whole robot's report was written to, its page.
std::string file_to_show(const std::string& named) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(named, ignored)) return named;
  return (std::filesystem::path(named) / "index.html").string();
}

std::string text_in(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::string number_in(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? wording::six_digits(found->get<double>())
                                                     : "";
}

/// Those that stand at the top of a report, where there are any.
bool is_headline(const std::string& key) {
  return key == "cog_angle" || key == "gravity_torque" || key == "break_away_torque" ||
         key == "coulomb_torque" || key == "viscous_coefficient";
}

/// Each joint's verdict, and a row for each of its headline numbers. @param page as its page embeds
/// it.
std::string robot_text(const nlohmann::json& page) {
  inspect::survey::TextTable facts(0);
  for (const char* const key : {"robot", "serial"}) {
    const std::string text = text_in(page, key);
    if (!text.empty()) facts.add({key, printable(text, 400)});
  }
  std::string shown = facts.text();
  for (const nlohmann::json& joint : page.at("joints")) {
    const std::string refusal = text_in(joint, "refusal");
    shown += fmt::format("\n{}: {}\n", printable(text_in(joint, "name")),
                         refusal.empty() ? text_in(joint, "verdict") + " - " +
                                               printable(text_in(joint, "sentence"), 400)
                                         : "refused - " + printable(refusal, 400));
    if (!joint.contains("quantities")) continue;
    inspect::survey::TextTable numbers(2);
    for (const nlohmann::json& q : joint.at("quantities")) {
      if (!is_headline(text_in(q, "key"))) continue;
      const nlohmann::json& e = q.at("estimate");
      numbers.add({printable(text_in(q, "words")), number_in(e, "value"),
                   e.is_null() ? "" : number_in(e, "low") + " to " + number_in(e, "high"),
                   printable(text_in(q, "unit")), text_in(q, "verdict")});
    }
    shown += numbers.text();
  }
  return shown;
}

ExitStatus run_show(const ShowOptions& options, Console& console) {
  const std::string file = file_to_show(options.file);
  const report::engine::EmbeddedJson numbers = numbers_in(file);
  if (numbers.element == robot_element && !options.json) {
    try {
      console.say(robot_text(nlohmann::json::parse(numbers.json)));
    } catch (const nlohmann::json::exception&) {
      throw InputError({file, 0, 0},
                       {"the numbers in the page are not a robot's", "", "", "they were changed"});
    }
    return ExitStatus::done;
  }
  if (numbers.element != calibration_element) {
    if (!options.json) {
      throw UsageError(fmt::format("{}: the page contains {}, which only --json shows",
                                   printable(options.file, longest_path), numbers.element));
    }
    print_json(numbers.json);
    return ExitStatus::done;
  }
  const calibration::NewCalibration made = calibration::entry_of_calibration(numbers.json, file);
  if (options.json) {
    print_json(numbers.json);
  } else {
    console.say(facts_text(made.facts, "", 1) + "\n" + quantities_text(made.quantities) +
                friction_text(calibration::read_curves(numbers.json)));
  }
  return ExitStatus::done;
}

}  // namespace

Run add_show(CLI::App& app) {
  const auto options = std::make_shared<ShowOptions>();
  CLI::App& command =
      *app.add_subcommand("show", "the numbers of a report, read from the report itself");
  command
      .add_option("FILE", options->file,
                  "report (HTML), calibration (JSON), or directory or page of a whole robot")
      ->required();
  command.add_flag("--json", options->json, "all of them as JSON, to standard output");
  command.footer(
      "\nEvery tribolog page embeds its numbers as JSON; --json returns them as they\nare. Values "
      "are SI, torques at the motor. Of a whole robot each joint's verdict and headline "
      "numbers\nare "
      "shown.");
  return [options](const Invocation& call) { return run_show(*options, call.console); };
}

}  // namespace tribolog::cli
