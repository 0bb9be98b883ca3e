#include "base/atomic_file.h"
#include "calibration/calibration_json.h"
#include "cli/archiving.h"
#include "cli/commands.h"
#include "cli/identification.h"

namespace tribolog {

ExitStatus run_identify(const IdentifyArguments& options, const std::vector<std::string>& arguments,
                        Console& console) {
  check_output_can_be_written(options.output, {options.dataset, options.archiving.file()});
  console.make_way_for(options.output);
  Provenance provenance = make_provenance(arguments);
  Archiving archiving(options.archiving);
  const Dataset dataset = load_dataset(options.dataset, console);
  protect_inputs(dataset, options.dataset, options.output);
  const Calibration calibration =
      run_identification(dataset, {options.intervals, options.truth_runs}, console);
  provenance.configuration = interval_configuration(calibration.intervals);
  const std::string json = calibration_json(calibration, provenance);
  AtomicFiles files;
  files.add(options.output, json);
  archiving.keep_numbers(json, options.output, options.dataset, console);
  files.commit();
  tell_outcome(calibration, console);
  console.say("calibration: " + printable(options.output, longest_path));
  return status_of(calibration, options.fail_on);
}

}  // namespace tribolog
