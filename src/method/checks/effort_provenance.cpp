// Where the effort comes from: whether it is a measurement, and whether anybody said so.

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog {
namespace {

bool is_torque(EffortKind kind) {
  return kind == EffortKind::motor_torque || kind == EffortKind::joint_torque;
}

/// What of the manifest contradicts what the logger writes; empty: nothing.
std::string contradiction(const Drive& drive, const LoggedEffort& logged) {
  const EffortKind stated = drive.kind();
  const std::string start =
      fmt::format("{} writes into column '{}' ", logged.logger, logged.column);
  if (logged.is_target && stated != EffortKind::target_torque) {
    return start + "a target of its controller; the manifest states a measured " +
           to_string(stated);
  }
  if (!logged.is_target && stated == EffortKind::target_torque) {
    return start + "a measurement; the manifest states a target_torque";
  }
  if (!logged.kind || logged.is_target) return "";
  if ((*logged.kind == EffortKind::motor_current) != (stated == EffortKind::motor_current)) {
    return start + "a " + to_string(*logged.kind) + "; the manifest states a " + to_string(stated);
  }
  if (!is_torque(stated)) return "";  // the side of a current is that of its torque constant
  const bool other_side = logged.side && *logged.side != drive.side() && drive.gear_ratio() != 1;
  if (other_side) {
    return start + fmt::format("a torque on the {} side; the manifest states the {} side",
                               to_string(*logged.side), to_string(drive.side()));
  }
  if (logged.is_behind_gear && stated == EffortKind::motor_torque) {
    return start + "a torque measured behind the gear; the manifest states a motor_torque";
  }
  return "";
}

}  // namespace

DataCheck check_effort_provenance(const CheckedDataset& data) {
  DataCheck check;
  check.name = "effort_provenance";
  check.title = "Provenance of the effort";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  const Drive& drive = data.manifest->drive;
  const bool is_confirmed = data.manifest->effort_is_confirmed;
  check.recording = "all";
  check.state = CheckState::passed;
  check.found = fmt::format("{}, {} side, as the manifest states", to_string(drive.kind()),
                            to_string(drive.side()));
  if (drive.kind() == EffortKind::target_torque) {
    check.state = CheckState::fails;
    check.found =
        "the effort is a target torque, of a controller or of its model, and no measurement";
    check.consequence =
        "friction found in it is the model's own friction, not the joint's, and so is gravity";
    check.experiment = "record the motor current or a measured torque beside it";
  }
  if (is_confirmed) return check;
  if (check.state == CheckState::passed) {
    check.state = CheckState::warns;
    check.found = fmt::format("{} on the {} side is a proposal, and nobody confirmed it",
                              to_string(drive.kind()), to_string(drive.side()));
    check.consequence =
        "if the column is anything else, every torque and mass is wrong by one factor";
    check.experiment =
        "look up what the driver writes, then state effort.kind and effort.side and delete "
        "'confirmed = false'";
  } else {
    check.found += "; that it is one is a proposal, and nobody confirmed it";
  }
  return check;
}

DataCheck check_effort_column(const CheckedDataset& data) {
  DataCheck check;
  check.name = "effort_column";
  check.title = "Effort against what its logger writes";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  check.measure = "logs whose effort column is what the manifest states";
  check.unit = percent_sign;
  check.at_least = 100;
  std::string first;
  RecordingsAsWanted logs;
  for (const InputFile& input : *data.inputs) {
    if (!input.logged_effort) continue;
    const std::string words = contradiction(data.manifest->drive, *input.logged_effort);
    if (first.empty()) first = words;
    logs.add(words.empty(), input.name);
  }
  if (logs.all() == 0) {
    return not_applicable(check.name, check.title,
                          "the names of the columns are those of no logger that is known");
  }
  logs.take_share(check);
  if (logs.others() == 0) {
    return passed_by_all(check, "the column's name agrees with what the manifest states");
  }
  check.state = CheckState::fails;
  check.found = first;
  check.consequence =
      "if the logger is right, the torque is of another kind, unit or side than what was "
      "identified, or no measurement at all";
  check.experiment = "state effort.kind and effort.side of this column as its logger writes it";
  return check;
}

}  // namespace tribolog
