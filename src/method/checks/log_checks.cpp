// The clock of the log: how even it is, and what is missing.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog::method::checks {

namespace {

constexpr double gap_intervals = 5;  ///< From so many sampling intervals on it is a gap.

const char* const words_of_consequence =
    "speed and acceleration are differences of the angle over the clock, and are wrong with it";

struct Clock {
  double jitter_percent{};
  double missing_percent{};
  double longest_gap_s{};
  std::size_t gaps{};
};

Clock clock_of(const CheckedRecording& r) {
  Clock clock;
  const std::vector<double>& t = r.recording->t_s;
  if (t.size() < 3) return clock;
  double squares = 0;
  double missing = 0;
  std::size_t regular = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double interval = t[i] - t[i - 1];
    if (interval > gap_intervals * r.interval_s) {
      ++clock.gaps;
      missing += interval - r.interval_s;
      clock.longest_gap_s = std::max(clock.longest_gap_s, interval);
      continue;
    }
    squares += std::pow(interval / r.interval_s - 1, 2);
    ++regular;
  }
  clock.jitter_percent =
      100 * std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, regular)));
  clock.missing_percent = 100 * missing / (t.back() - t.front());
  return clock;
}

}  // namespace

DataCheck check_clock_jitter(const CheckedDataset& data) {
  // An interval that scatters by half of itself is no clock that a speed can be taken from; logs
  // over a network scatter by some ten per cent.
  constexpr double most_percent = 50;
  DataCheck check;
  check.name = "clock_jitter";
  check.title = "Even clock";
  check.measure = "scatter of the sampling interval";
  check.unit = percent_sign;
  check.at_most = most_percent;
  double interval = 0;
  for (const CheckedRecording& r : data.recordings) {
    const double jitter = clock_of(r).jitter_percent;
    if (!take_if_worst(check, jitter, r.recording->name)) continue;
    interval = r.interval_s;
  }
  if (!check.measured) return not_applicable(check.name, check.title, "no recording");
  check.found = fmt::format("the interval of {:.4g} ms scatters by {:.1f} % of itself",
                            1e3 * interval, *check.measured);
  check.state = passed_or_fails(check);
  if (check.state == CheckState::passed) return check;
  check.consequence = words_of_consequence;
  check.experiment =
      "log the time at which the drive sampled, not the time at which the row was "
      "written";
  return check;
}

DataCheck check_clock_gaps(const CheckedDataset& data) {
  constexpr double most_percent = 5;
  DataCheck check;
  check.name = "clock_gaps";
  check.title = "No gaps in time";
  check.measure = "time lost in gaps";
  check.unit = percent_sign;
  check.at_most = most_percent;
  Clock worst;
  for (const CheckedRecording& r : data.recordings) {
    const Clock clock = clock_of(r);
    if (!take_if_worst(check, clock.missing_percent, r.recording->name)) continue;
    worst = clock;
  }
  if (!check.measured) return not_applicable(check.name, check.title, "no recording");
  if (worst.gaps == 0) {
    return passed_by_all(
        check, fmt::format("no interval is longer than {} sampling intervals", gap_intervals));
  }
  check.found = fmt::format("{} gap{}, the longest {:.3g} s", worst.gaps,
                            worst.gaps == 1 ? "" : "s", worst.longest_gap_s);
  check.state = *check.measured <= most_percent ? CheckState::warns : CheckState::fails;
  check.consequence =
      "what happened in the gaps is unknown: a reversal or a settling may be "
      "missing, and slopes across a gap are no speeds";
  check.experiment =
      "log locally in the controller, or at a lower rate that the connection carries";
  return check;
}

// Where the effort comes from: whether it is a measurement, and whether anybody said so.

namespace {

bool is_torque(joint::EffortKind kind) {
  return kind == joint::EffortKind::motor_torque || kind == joint::EffortKind::joint_torque;
}

/// What of the manifest contradicts what the logger writes; empty: nothing.
std::string contradiction(const joint::Drive& drive, const joint::LoggedEffort& logged) {
  const joint::EffortKind stated = drive.kind();
  const std::string start =
      fmt::format("{} writes into column '{}' ", logged.logger, logged.column);
  if (logged.is_target && stated != joint::EffortKind::target_torque) {
    return start + "a target of its controller; the manifest states a measured " +
           joint::to_string(stated);
  }
  if (!logged.is_target && stated == joint::EffortKind::target_torque) {
    return start + "a measurement; the manifest states a target_torque";
  }
  if (!logged.kind || logged.is_target) return "";
  if ((*logged.kind == joint::EffortKind::motor_current) !=
      (stated == joint::EffortKind::motor_current)) {
    return start + "a " + joint::to_string(*logged.kind) + "; the manifest states a " +
           joint::to_string(stated);
  }
  if (!is_torque(stated)) return "";  // the side of a current is that of its torque constant
  const bool other_side = logged.side && *logged.side != drive.side() && drive.gear_ratio() != 1;
  if (other_side) {
    return start + fmt::format("a torque on the {} side; the manifest states the {} side",
                               joint::to_string(*logged.side), joint::to_string(drive.side()));
  }
  if (logged.is_behind_gear && stated == joint::EffortKind::motor_torque) {
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
  const joint::Drive& drive = data.manifest->drive;
  const bool is_confirmed = data.manifest->effort_is_confirmed;
  check.recording = "all";
  check.state = CheckState::passed;
  check.found = fmt::format("{}, {} side, as the manifest states", joint::to_string(drive.kind()),
                            joint::to_string(drive.side()));
  if (drive.kind() == joint::EffortKind::target_torque) {
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
                              joint::to_string(drive.kind()), joint::to_string(drive.side()));
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
  for (const joint::InputFile& input : *data.inputs) {
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

// The logged temperature: how far it moved over all recordings.

DataCheck check_temperature(const CheckedDataset& data) {
  // Viscosity of a gear's grease changes by some 3 to 5 % a kelvin.
  constexpr double warning_K = 5;
  constexpr double most_K = 10;
  DataCheck check;
  check.name = "temperature";
  check.title = "Temperature";
  double low = 0, high = 0;
  for (const CheckedRecording& r : data.recordings) {
    for (const double degrees : r.recording->temperature_C) {
      low = check.measured ? std::min(low, degrees) : degrees;
      high = check.measured ? std::max(high, degrees) : degrees;
      check.measured = high - low;
    }
  }
  if (!check.measured) {
    return not_applicable(check.name, check.title, "no temperature is logged");
  }
  check.recording = "all";
  check.measure = "range of the temperature over all recordings";
  check.unit = kelvin;
  check.at_most = warning_K;
  check.found = fmt::format("{:.3g} to {:.3g} °C", low, high);
  check.state = passed_or_warns_up_to(most_K, check);
  if (check.state == CheckState::passed) return check;
  check.consequence =
      "friction changes by some per cent for each kelvin, so recordings of "
      "different temperature do not belong to one curve";
  check.experiment = "warm the joint up first, and record all roles at one temperature";
  return check;
}

}  // namespace tribolog::method::checks
