#include <CLI/CLI.hpp>

#include "base/atomic_file.h"
#include "base/standard_output.h"
#include "cli/archive_commands.h"
#include "cli/shared_options.h"
#include "exports/results/calibration_exports.h"

namespace tribolog::cli {
namespace {

struct ExportOptions {
  std::string id;
  std::string format;
  std::string output;
  std::string side;
  exports::results::SimulatorOptions simulator;
};

void check(ExportOptions& options) {
  if (!options.side.empty() && options.format != "modelica") {
    throw UsageError(
        "archive export: --side is for modelica; tables have both sides, URDF and "
        "MJCF the joint's");
  }
  if (options.simulator.arm_inertia_kgm2 && options.format != "mjcf") {
    throw UsageError("archive export: --arm-inertia is for mjcf");
  }
  options.simulator.side = options.side == "motor" ? joint::Side::motor : joint::Side::joint;
}

std::string text_of(const ExportOptions& options, const exports::results::ArchivedJoint& joint) {
  if (options.format == "csv") return exports::results::csv_table(joint);
  if (options.format == "json") return exports::results::json_document(joint);
  if (options.format == "latex") return exports::results::latex_table(joint);
  if (options.format == "urdf") return exports::results::urdf_joint(joint, options.simulator);
  if (options.format == "mjcf") return exports::results::mjcf_joint(joint, options.simulator);
  return exports::results::modelica_friction(joint, options.simulator);
}

}  // namespace

Run add_export(CLI::App& archive) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App& command =
      *archive.add_subcommand("export", "export one calibration for use in other programs");
  command.add_option("ID", options->id, "the first digits of its id")->required();
  command.add_option("--format", options->format, "csv, json, latex, urdf, mjcf or modelica")
      ->required()
      ->check(CLI::IsMember({"csv", "json", "latex", "urdf", "mjcf", "modelica"}));
  command.add_option("-o,--output", options->output, "file to write; default: standard output");
  command.add_flag("--doubtful-too", options->simulator.doubtful_too,
                   "urdf, mjcf, modelica: also numbers whose verdict is not usable");
  command
      .add_option("--side", options->side,
                  "modelica: side of the gear on which the bearing is; default: joint")
      ->check(CLI::IsMember({"joint", "motor"}));
  command
      .add_option("--arm-inertia", options->simulator.arm_inertia_kgm2,
                  "mjcf: inertia of all that the joint moves, about its axis (kg·m²), as in the "
                  "model's bodies; what was identified beyond it is the armature")
      ->check(number_between(0, 1e9));
  const auto where = add_archive_options(command);
  command.footer(
      "\nEach file states in its comments what it describes, and the conversions of units and "
      "sides.\ncsv, json, latex: every quantity on both sides of the gear, marked with its "
      "verdict.\nurdf: <dynamics damping friction>. mjcf: <joint damping frictionloss "
      "armature>.\nmodelica: tau_pos and peak of "
      "Modelica.Mechanics.Rotational.Components.BearingFriction.");
  return [where, options](const Invocation& call) {
    check(*options);
    where->protect_from(options->output);
    call.console.make_way_for(options->output);
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    exports::results::ArchivedJoint joint;
    joint.entry = kept.find(options->id);
    joint.quantities = kept.quantities(joint.entry);
    joint.calibration =
        kept.document(joint.entry, calibration::DocumentKind::calibration).value_or("");
    const std::string text = text_of(*options, joint);
    if (options->output.empty()) {
      print(text);
    } else {
      write_file_atomically(options->output, text);
      call.console.say("export: " + printable(options->output, longest_path));
    }
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
