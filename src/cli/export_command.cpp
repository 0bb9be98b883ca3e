#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "archive/store/digest.h"
#include "base/atomic_file.h"
#include "base/closest_match.h"
#include "base/input_file.h"
#include "base/standard_output.h"
#include "calibration/read_calibration.h"
#include "cli/archive_commands.h"
#include "cli/commands.h"
#include "cli/given_files.h"
#include "cli/shared_options.h"
#include "exports/results/calibration_exports.h"
#include "exports/results/robot_model.h"

namespace tribolog::cli {
namespace {

std::optional<double> speed_of(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const bool is_speed = read.ec == std::errc() && read.ptr == end && std::isfinite(value);
  return is_speed && value >= 0 ? std::optional(value) : std::nullopt;
}

/// @throw UsageError
calibration::SpeedRange speed_range(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) {
    const auto low = speed_of(std::string_view(text).substr(0, colon));
    const auto high = speed_of(std::string_view(text).substr(colon + 1));
    if (low && high && *low <= *high) return {*low, *high};
  }
  throw UsageError("--range: found " + in_quotes(text) +
                   ", expected two speeds of the joint in rad/s, the lower first, as in 0.1:3");
}

/// What formats of simulators take, and a robot's model.
void add_simulator_options(CLI::App& command, exports::results::SimulatorOptions& options) {
  command.add_flag("--doubtful-too", options.doubtful_too,
                   "also numbers whose verdict is not usable, from urdf on");
  command
      .add_option_function<std::string>(
          "--range",
          [&options](const std::string& text) { options.range_rad_s = speed_range(text); },
          "speeds of the joint (rad/s), LOW:HIGH, over which dry friction and a viscous "
          "coefficient "
          "are to be nearest to the friction identified; default: all that are usable")
      ->type_name("LOW:HIGH");
  command
      .add_option("--arm-inertia", options.arm_inertia_kgm2,
                  "inertia of all that the joint moves, about its axis (kg·m²), as in the model's "
                  "bodies; what was identified beyond it is the armature")
      ->check(number_between(0, 1e9));
}

struct ExportOptions {
  std::string of;  ///< An id, or a file.
  std::string format;
  std::string output;
  std::string side;
  bool all{false};  ///< Of the archive, those that the filter leaves.
  archive::store::Filter filter;
  exports::results::SimulatorOptions simulator;
};

void check(ExportOptions& options) {
  if (!options.side.empty() && options.format != "modelica") {
    throw UsageError(
        "export: --side is for modelica; tables have both sides, the other formats "
        "the joint's");
  }
  if (options.simulator.arm_inertia_kgm2 && options.format != "mjcf" &&
      options.format != "mjcf-lugre" && options.format != "isaaclab" && options.format != "usd" &&
      options.format != "bam") {
    throw UsageError("export: --arm-inertia is for mjcf, mjcf-lugre, isaaclab, usd and bam");
  }
  options.simulator.side = options.side == "motor" ? joint::Side::motor : joint::Side::joint;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const exports::results::ExportFormat& one : exports::results::export_formats()) {
    names.emplace_back(one.name);
  }
  return names;
}

std::string text_of(const ExportOptions& options, const exports::results::ArchivedJoint& joint) {
  const auto& formats = exports::results::export_formats();
  const auto format = std::find_if(formats.begin(), formats.end(),
                                   [&](const auto& one) { return options.format == one.name; });
  return format->text_of(joint, options.simulator);
}

/// All but what is exported.
void add_options(CLI::App& command, ExportOptions& options) {
  command
      .add_option("--format", options.format, fmt::format("{}", fmt::join(format_names(), ", ")))
      ->required()
      ->check(one_of(format_names()));
  command.add_option("-o,--output", options.output, "file to write; default: standard output");
  add_simulator_options(command, options.simulator);
  command
      .add_option("--side", options.side,
                  "modelica: side of the gear on which the bearing is; default: joint")
      ->check(one_of(std::vector<std::string>{"joint", "motor"}));
  std::string formats =
      "\nEach file states in its comments what it describes, and the conversions of "
      "units and sides.\n";
  for (const exports::results::ExportFormat& one : exports::results::export_formats()) {
    formats += fmt::format("{}: {}\n", one.name, one.content);
  }
  command.footer(
      formats +
      "From urdf on, numbers of the joint's side that are usable. A format that knows dry "
      "friction and a\nviscous coefficient alone gets Coulomb torque and viscous "
      "coefficient where both are usable,\nelse the line nearest to the friction at the "
      "usable speeds, or those of --range, marked as an\napproximation with its largest "
      "error.");
}

exports::results::ArchivedJoint archived(archive::store::CalibrationArchive& kept,
                                         const calibration::Entry& entry) {
  exports::results::ArchivedJoint joint;
  joint.entry = entry;
  joint.quantities = kept.quantities(entry);
  joint.calibration = kept.document(entry, calibration::DocumentKind::calibration).value_or("");
  return joint;
}

/// @throw UsageError for a format that holds one joint.
std::string text_of_all(const ExportOptions& options, archive::store::CalibrationArchive& kept) {
  const bool is_csv = options.format == "csv";
  if (!is_csv && options.format != "json") {
    throw UsageError("archive export: --all is for csv and json");
  }
  std::string text = is_csv ? exports::results::archive_csv_header() : "";
  for (const calibration::Entry& entry : kept.list(options.filter)) {
    const exports::results::ArchivedJoint joint = archived(kept, entry);
    text += is_csv ? exports::results::archive_csv_rows(joint)
                   : exports::results::json_document(joint, true);
  }
  return text;
}

void write(const ExportOptions& options, const std::string& text, Console& console) {
  if (options.output.empty()) {
    print(text);
  } else {
    write_file_atomically(options.output, text);
    console.say("export: " + printable(options.output, longest_path));
  }
}

}  // namespace

Run add_archive_export(CLI::App& archive) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App& command =
      *archive.add_subcommand("export", "export one calibration for use in other programs");
  auto* const id = command.add_option("ID", options->of, "the first digits of its id");
  add_options(command, *options);
  command
      .add_flag("--all", options->all,
                "every calibration: csv, a row each quantity; json, a line each")
      ->excludes(id);
  add_filter(command, options->filter);
  const auto where = add_archive_options(command);
  return [where, options](const Invocation& call) {
    check(*options);
    if (options->of.empty() != options->all) {
      throw UsageError("archive export: either the ID of a calibration or --all is needed");
    }
    where->protect_from(options->output);
    call.console.make_way_for(options->output);
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    write(*options,
          options->all ? text_of_all(*options, kept)
                       : text_of(*options, archived(kept, kept.find(options->of))),
          call.console);
    return ExitStatus::done;
  };
}

// `tribolog export`, of a file.

namespace {

exports::results::ArchivedJoint joint_of_file(const std::string& file) {
  const std::string json = calibration_in(file);
  const calibration::NewCalibration made = calibration::entry_of_calibration(json, file);
  exports::results::ArchivedJoint joint;
  joint.is_archived = false;
  joint.entry.facts = made.facts;
  joint.entry.identity = archive::store::identity_of(made.inputs);
  joint.entry.id = archive::store::id_of(joint.entry.identity, 1);
  joint.quantities = made.quantities;
  joint.calibration = json;
  return joint;
}

}  // namespace

Run add_export(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App& command = *app.add_subcommand(
      "export", "the numbers of a report or calibration for use in other programs");
  command.add_option("FILE", options->of, "report (HTML) or calibration (JSON)")->required();
  add_options(command, *options);
  return [options](const Invocation& call) {
    check(*options);
    if (!options->output.empty()) check_output_can_be_written(options->output, {options->of});
    call.console.make_way_for(options->output);
    const exports::results::ArchivedJoint joint = joint_of_file(options->of);
    write(*options, text_of(*options, joint), call.console);
    return ExitStatus::done;
  };
}

// `tribolog apply`: the numbers in the user's own model.

namespace {

struct ApplyOptions {
  std::string of;     ///< Report or calibration.
  std::string model;  ///< URDF, SDF or MJCF.
  std::string output;
  std::string joint;  ///< Its name in the model; empty: as in the calibration.
  exports::results::SimulatorOptions simulator;
};

void apply(const ApplyOptions& options, Console& console) {
  check_output_can_be_written(options.output, {options.of, options.model});
  const exports::results::ArchivedJoint joint = joint_of_file(options.of);
  const std::string name = options.joint.empty() ? joint.entry.facts.of.joint : options.joint;
  const exports::results::PatchedModel made = exports::results::with_friction(
      read_file(options.model), options.model, name, joint, options.simulator);
  write_file_atomically(options.output, made.text);
  console.say(fmt::format("{}, joint {}:", made.format, printable(name)));
  for (const std::string& change : made.changes) console.say("  " + change);
  for (const std::string& remark : made.remarks) console.say("  " + remark);
  console.say("model: " + printable(options.output, longest_path));
}

}  // namespace

Run add_apply(CLI::App& app) {
  const auto options = std::make_shared<ApplyOptions>();
  CLI::App& command = *app.add_subcommand(
      "apply", "the joint's friction in your own URDF, SDF or MJCF, all else byte for byte");
  command.add_option("FILE", options->of, "report (HTML) or calibration (JSON)")->required();
  command.add_option("MODEL", options->model, "the robot's model: URDF, SDF or MJCF")->required();
  command.add_option("-o,--output", options->output, "the new model")->required();
  command.add_option("--joint", options->joint,
                     "the joint's name in the model; default: as in the calibration");
  add_simulator_options(command, options->simulator);
  return [options](const Invocation& call) {
    apply(*options, call.console);
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
