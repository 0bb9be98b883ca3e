// identify, report and figures of all joints in a robot's manifest: files in a directory.

#include "cli/robot_commands.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "calibration/provenance.h"
#include "cli/drawing.h"
#include "cli/robot_joints.h"
#include "tribolog/failure.h"
#include "tribolog/figures.h"
#include "tribolog/report.h"

namespace tribolog::cli {
namespace {

constexpr const char* page_name = "index.html";

void add_numbers(const std::vector<IdentifiedJoint>& joints, const std::string& directory,
                 AtomicFiles& files) {
  for (const IdentifiedJoint& joint : joints) {
    if (!joint.calibration) continue;
    files.add(directory + "/" + calibration_name(joint), joint.calibration->to_json());
  }
}

/// Makes the directory, and finds out before anything is computed whether files can be written to
/// it.
/// @param page one of them.
void prepare(const DatasetChoice& dataset, const std::string& directory, const std::string& page,
             const ArchivingOptions& archiving, AtomicFiles& files) {
  if (directory == "-") {
    throw UsageError(
        "the manifest is that of a whole robot: -o names a directory, or --joint one joint");
  }
  files.make_directory(directory);
  check_output_can_be_written(directory + "/" + page, {dataset.manifest, archiving.file()});
  static_cast<void>(calibration::make_provenance({}));  // a time that cannot be used is refused now
}

/// Where the numbers go.
struct Keepers {
  AtomicFiles& files;
  Archiving& archiving;
  Console& console;
};

/// Identifies the joints; their numbers are in the archive then, and among the files.
/// @param options of identify or of report.
template <class Options>
std::vector<IdentifiedJoint> identified_and_kept(const Options& options,
                                                 const std::vector<std::string>& joints,
                                                 const std::vector<std::string>& arguments,
                                                 const Keepers& to) {
  std::vector<IdentifiedJoint> done = identify_joints(
      options.dataset.manifest, joints, {options.seed, options.truth_runs, arguments}, to.console);
  protect_inputs(done, options.output);
  add_numbers(done, options.output, to.files);
  keep_numbers(done, options.dataset.manifest, to.archiving, to.console);
  return done;
}

}  // namespace

ExitStatus identify_robot(const IdentifyArguments& options, const std::vector<std::string>& joints,
                          const std::vector<std::string>& arguments, Console& console) {
  AtomicFiles files;
  prepare(options.dataset, options.output, file_names_of(joints).front() + ".calibration.json",
          options.archiving, files);
  Archiving archiving(options.archiving);
  const std::vector<IdentifiedJoint> done =
      identified_and_kept(options, joints, arguments, {files, archiving, console});
  files.commit();
  tell_outcome(done, console);
  console.say("calibrations: " + printable(options.output, longest_path));
  return status_of(done, options.fail_on);
}

ExitStatus report_robot(const ReportOptions& options, const std::vector<std::string>& joints,
                        const std::vector<std::string>& arguments, Console& console) {
  if (!options.calibration.empty()) {
    throw UsageError("--calibration is for one joint; those of a robot's are beside its reports");
  }
  AtomicFiles files;
  prepare(options.dataset, options.output, page_name, options.archiving, files);
  Archiving archiving(options.archiving);
  std::optional<Renderer> renderer;  // starts while the numbers are computed
  if (options.figures) {
    renderer.emplace(RendererOptions{options.processes, options.dataset.manifest});
  }
  const std::vector<IdentifiedJoint> done =
      identified_and_kept(options, joints, arguments, {files, archiving, console});

  std::vector<RobotJoint> shown;
  std::size_t failed_figures = 0;
  for (const IdentifiedJoint& joint : done) {
    RobotJoint& one = shown.emplace_back();
    one.name = joint.name;
    one.refusal = joint.refusal;
    if (!joint.calibration) continue;
    one.calibration = joint.calibration;
    one.earlier = archiving.since_last(joint.archived_as);
    one.kept_as = joint.archived_as;
    one.report = joint.file_name + ".html";
    const Progress on_console = progress_on(console);
    const Report report =
        make_report(*joint.calibration,
                    {options.language.code, one.earlier, joint.archived_as,
                     [&](const std::string& what, std::size_t at, std::size_t all) {
                       on_console(joint.name + ": " + what, at, all);
                     }},
                    renderer ? &*renderer : nullptr);
    files.add(options.output + "/" + one.report, report.html);
    archiving.keep_report(joint.archived_as, report.html, console);
    failed_figures += tell_failures(report.figures, console);
  }
  files.add(options.output + "/" + page_name,
            make_robot_page(shown, {options.language.code, arguments}));
  files.commit();
  tell_outcome(done, console);
  console.say("robot: " + printable(options.output + "/" + page_name, longest_path));
  const ExitStatus status = status_of(done, options.fail_on);
  const bool is_refused = status != ExitStatus::done && status != ExitStatus::verdict_failed;
  return failed_figures > 0 && !is_refused ? ExitStatus::figure_failed : status;
}

ExitStatus draw_robot(const FiguresOptions& options, const std::vector<std::string>& joints,
                      Console& console) {
  const std::vector<std::string> names = file_names_of(joints);
  ExitStatus status = ExitStatus::done;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    FiguresOptions one = options;
    one.dataset.joint = joints[k];
    one.directory = options.directory + "/" + names[k];
    try {
      status = std::max(status, run_figures(one, console));
    } catch (const Failure& failure) {
      console.warn(printable(joints[k]) + ": error: " + failure.what());
      status = std::max(status, static_cast<ExitStatus>(failure.exit_status()));
    }
  }
  return status;
}

}  // namespace tribolog::cli
