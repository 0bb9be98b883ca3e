#include <CLI/CLI.hpp>

#include "archive/store/digest.h"
#include "base/atomic_file.h"
#include "base/standard_output.h"
#include "calibration/read_calibration.h"
#include "cli/archive_commands.h"
#include "cli/commands.h"
#include "cli/shared_options.h"
#include "exports/results/calibration_exports.h"

namespace tribolog::cli {
namespace {

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
  if (options.simulator.arm_inertia_kgm2 && options.format != "mjcf") {
    throw UsageError("export: --arm-inertia is for mjcf");
  }
  options.simulator.side = options.side == "motor" ? joint::Side::motor : joint::Side::joint;
}

std::string text_of(const ExportOptions& options, const exports::results::ArchivedJoint& joint) {
  if (options.format == "csv") return exports::results::csv_table(joint);
  if (options.format == "json") return exports::results::json_document(joint);
  if (options.format == "mat") return exports::results::matlab_file(joint);
  if (options.format == "latex") return exports::results::latex_table(joint);
  if (options.format == "dcc") return exports::results::digital_certificate(joint);
  if (options.format == "urdf") return exports::results::urdf_joint(joint, options.simulator);
  if (options.format == "sdf") return exports::results::sdf_joint(joint, options.simulator);
  if (options.format == "ros2") return exports::results::ros2_parameters(joint, options.simulator);
  if (options.format == "mjcf") return exports::results::mjcf_joint(joint, options.simulator);
  return exports::results::modelica_friction(joint, options.simulator);
}

/// All but what is exported.
void add_options(CLI::App& command, ExportOptions& options) {
  command
      .add_option("--format", options.format,
                  "csv, json, mat, latex, dcc, urdf, sdf, mjcf, modelica or ros2")
      ->required()
      ->check(one_of(std::vector<std::string>{"csv", "json", "mat", "latex", "dcc", "urdf", "sdf",
                                              "mjcf", "modelica", "ros2"}));
  command.add_option("-o,--output", options.output, "file to write; default: standard output");
  command.add_flag("--doubtful-too", options.simulator.doubtful_too,
                   "urdf, sdf, mjcf, modelica, ros2: also numbers whose verdict is not usable");
  command
      .add_option("--side", options.side,
                  "modelica: side of the gear on which the bearing is; default: joint")
      ->check(one_of(std::vector<std::string>{"joint", "motor"}));
  command
      .add_option("--arm-inertia", options.simulator.arm_inertia_kgm2,
                  "mjcf: inertia of all that the joint moves, about its axis (kg·m²), as in the "
                  "model's bodies; what was identified beyond it is the armature")
      ->check(number_between(0, 1e9));
  command.footer(
      "\nEach file states in its comments what it describes, and the conversions of units and "
      "sides.\ncsv, json, mat, latex: every quantity on both sides of the gear, marked with its "
      "verdict.\ndcc: Digital Calibration Certificate 3.1.2 (XML), with what [certificate] of the "
      "manifest states.\nurdf, sdf: <dynamics> with damping and friction. mjcf: <joint damping "
      "frictionloss "
      "armature>.\nmodelica: tau_pos and peak of "
      "Modelica.Mechanics.Rotational.Components.BearingFriction.\nros2: parameters of a node, "
      "YAML.");
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

Run add_export(CLI::App& archive) {
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

std::function<Run()> add_export_of_file(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App& command = *app.add_subcommand(
      "export", "the numbers of a report or calibration for use in other programs");
  command.add_option("FILE", options->of, "report (HTML) or calibration (JSON)")->required();
  add_options(command, *options);
  return [&command, options]() -> Run {
    if (!command) return {};
    return [options](const Invocation& call) {
      check(*options);
      if (!options->output.empty()) check_output_can_be_written(options->output, {options->of});
      call.console.make_way_for(options->output);
      const std::string json = calibration_in(options->of);
      const calibration::NewCalibration made = calibration::entry_of_calibration(json, options->of);
      exports::results::ArchivedJoint joint;
      joint.is_archived = false;
      joint.entry.facts = made.facts;
      joint.entry.identity = archive::store::identity_of(made.inputs);
      joint.entry.id = archive::store::id_of(joint.entry.identity, 1);
      joint.quantities = made.quantities;
      joint.calibration = json;
      write(*options, text_of(*options, joint), call.console);
      return ExitStatus::done;
    };
  };
}

}  // namespace tribolog::cli
