// The clock of the log: how even it is, and what is missing.

#include <algorithm>
#include <cmath>
#include <string>

#include "method/checks/check_list.h"

namespace tribolog::method::checks {

namespace {

constexpr double gap_intervals = 5;  ///< This many sampling intervals or more count as a gap.

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
  check.name = CheckName::clock_jitter;
  check.measure = {"measure.interval_scatter"};
  check.unit = percent_sign;
  check.at_most = most_percent;
  double interval = 0;
  for (const CheckedRecording& r : data.recordings) {
    const double jitter = clock_of(r).jitter_percent;
    if (!take_if_worst(check, jitter, r.recording->name)) continue;
    interval = r.interval_s;
  }
  if (!check.measured) return not_applicable(check.name, {"not_applicable.no_recording"});
  check.found = {"clock.interval_scatters",
                 {{"interval_ms", 1e3 * interval}, {"scatter_percent", *check.measured}}};
  check.state = passed_or_fails(check);
  if (check.state == CheckState::passed) return check;
  check.consequence = {"clock.speeds_wrong"};
  check.experiment = {"clock.log_time_of_sampling"};
  return check;
}

DataCheck check_clock_gaps(const CheckedDataset& data) {
  constexpr double most_percent = 5;
  DataCheck check;
  check.name = CheckName::clock_gaps;
  check.measure = {"measure.time_in_gaps"};
  check.unit = percent_sign;
  check.at_most = most_percent;
  Clock worst;
  for (const CheckedRecording& r : data.recordings) {
    const Clock clock = clock_of(r);
    if (!take_if_worst(check, clock.missing_percent, r.recording->name)) continue;
    worst = clock;
  }
  if (!check.measured) return not_applicable(check.name, {"not_applicable.no_recording"});
  if (worst.gaps == 0) {
    return passed_by_all(check, {"clock.no_gap", {{"intervals", gap_intervals}}});
  }
  check.found = {"clock.gaps", {{"gaps", worst.gaps}, {"longest_s", worst.longest_gap_s}}};
  check.state = *check.measured <= most_percent ? CheckState::warns : CheckState::fails;
  check.consequence = {"clock.gaps_hide_motion"};
  check.experiment = {"clock.log_locally"};
  return check;
}

// Where the effort comes from: whether it is a measurement, and whether that is stated.

namespace {

bool is_torque(joint::EffortKind kind) {
  return kind == joint::EffortKind::motor_torque || kind == joint::EffortKind::joint_torque;
}

/// What in the manifest contradicts what the logger writes; empty: nothing.
Statement contradiction(const joint::Drive& drive, const joint::LoggedEffort& logged) {
  const joint::EffortKind stated = drive.kind();
  const StatedValue logger{"logger", logged.logger};
  const StatedValue column{"column", logged.column};
  if (logged.is_target && stated != joint::EffortKind::target_torque) {
    return {"effort_column.is_target", {logger, column, {"stated", joint::to_string(stated)}}};
  }
  if (!logged.is_target && stated == joint::EffortKind::target_torque) {
    return {"effort_column.is_measurement", {logger, column}};
  }
  if (!logged.kind || logged.is_target) return {};
  if ((*logged.kind == joint::EffortKind::motor_current) !=
      (stated == joint::EffortKind::motor_current)) {
    return {"effort_column.is_other_kind",
            {logger,
             column,
             {"written", joint::to_string(*logged.kind)},
             {"stated", joint::to_string(stated)}}};
  }
  if (!is_torque(stated)) return {};  // the side of a current is that of its torque constant
  const bool other_side = logged.side && *logged.side != drive.side() && drive.gear_ratio() != 1;
  if (other_side) {
    return {*logged.side == joint::Side::motor ? Code{"effort_column.is_on_motor_side"}
                                               : Code{"effort_column.is_on_joint_side"},
            {logger, column}};
  }
  if (logged.is_behind_gear && stated == joint::EffortKind::motor_torque) {
    return {"effort_column.is_behind_gear", {logger, column}};
  }
  return {};
}

/// The effort as the manifest states it, confirmed or proposed.
Statement stated_effort(const joint::Drive& drive, bool is_confirmed) {
  const bool at_motor = drive.side() == joint::Side::motor;
  const Code confirmed = at_motor ? Code{"effort.stated_at_motor"} : Code{"effort.stated_at_joint"};
  const Code proposed =
      at_motor ? Code{"effort.proposed_at_motor"} : Code{"effort.proposed_at_joint"};
  return {is_confirmed ? confirmed : proposed, {{"effort", joint::to_string(drive.kind())}}};
}

}  // namespace

DataCheck check_effort_provenance(const CheckedDataset& data) {
  DataCheck check;
  check.name = CheckName::effort_provenance;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  const joint::Drive& drive = data.manifest->drive;
  const bool is_confirmed = data.manifest->effort_is_confirmed;
  check.recording = "all";
  if (drive.kind() == joint::EffortKind::target_torque) {
    check.state = CheckState::fails;
    check.found = is_confirmed ? Code{"effort.is_target"} : Code{"effort.is_target_proposed"};
    check.consequence = {"effort.friction_of_model"};
    check.experiment = {"effort.record_measurement"};
    return check;
  }
  if (data.manifest->torque_is_in_amperes) {
    check.state = CheckState::fails;
    check.found = {"effort.constant_unknown"};
    check.consequence = {"effort.is_of_amperes"};
    check.experiment = {"effort.state_constant"};
    return check;
  }
  check.state = is_confirmed ? CheckState::passed : CheckState::fails;
  check.found = stated_effort(drive, is_confirmed);
  if (is_confirmed) return check;
  check.consequence = {"effort.wrong_by_one_factor"};
  check.experiment = {"effort.confirm"};
  return check;
}

DataCheck check_effort_column(const CheckedDataset& data) {
  DataCheck check;
  check.name = CheckName::effort_column;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.effort_as_stated"};
  check.unit = percent_sign;
  check.at_least = 100;
  Statement first;
  RecordingCounts logs;
  for (const joint::InputFile& input : *data.inputs) {
    if (!input.logged_effort) continue;
    const Statement found = contradiction(data.manifest->drive, *input.logged_effort);
    if (first.empty()) first = found;
    logs.add(found.empty(), input.name);
  }
  if (logs.all() == 0) {
    return not_applicable(check.name, {"not_applicable.logger_unknown"});
  }
  logs.take_share(check);
  if (logs.others() == 0) {
    return passed_by_all(check, {"effort_column.as_stated"});
  }
  check.state = CheckState::fails;
  check.found = first;
  check.consequence = {"effort_column.other_than_identified"};
  check.experiment = {"effort_column.state_as_logged"};
  return check;
}

// The logged temperature: how far it varied over all recordings.

DataCheck check_temperature(const CheckedDataset& data) {
  // Viscosity of a gear's grease changes by some 3 to 5 % a kelvin.
  constexpr double warning_K = 5;
  constexpr double most_K = 10;
  DataCheck check;
  check.name = CheckName::temperature;
  double low = 0, high = 0;
  for (const CheckedRecording& r : data.recordings) {
    for (const double degrees : r.recording->temperature_C) {
      low = check.measured ? std::min(low, degrees) : degrees;
      high = check.measured ? std::max(high, degrees) : degrees;
      check.measured = high - low;
    }
  }
  if (!check.measured) {
    return not_applicable(check.name, {"not_applicable.no_temperature"});
  }
  check.recording = "all";
  check.measure = {"measure.temperature_range"};
  check.unit = kelvin;
  check.at_most = warning_K;
  check.found = {"temperature.range", {{"low_C", low}, {"high_C", high}}};
  check.state = passed_or_warns_up_to(most_K, check);
  if (check.state == CheckState::passed) return check;
  check.consequence = {"temperature.no_one_curve"};
  check.experiment = {"temperature.record_at_one"};
  return check;
}

}  // namespace tribolog::method::checks
