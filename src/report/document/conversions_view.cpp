// From the columns of the logs to signals at the joint and the motor, and where speeds come from.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "base/error.h"
#include "joint/dataset.h"
#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/torques_in.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using wording::tr;
using wording::tr_count;

constexpr int digits_of_time = 3;
constexpr std::size_t most_logs_named = 3;

std::string signal_in_words(joint::LoggedSignal signal) {
  return wording::words_for("signal", to_string(signal));
}

/// In quotes a name is no symbol with an index.
std::string named(const std::string& column) { return tr("“{column}”", {{"column", column}}); }

std::string step_in_words(const joint::ConversionStep& step,
                          const joint::ColumnConversion& conversion) {
  const std::string factor = (step.divides ? "÷ " : "× ") + wording::as_stated(step.number);
  switch (step.reason) {
    case joint::ConversionStep::Reason::unit:
      return tr("{factor} (from {unit})", {{"factor", factor}, {"unit", conversion.unit}});
    case joint::ConversionStep::Reason::sign:
      return tr("{factor} (sign stated)", {{"factor", factor}});
    case joint::ConversionStep::Reason::torque_constant:
      return tr("{factor} (torque constant)", {{"factor", wording::with_unit(factor, "N·m/A")}});
    case joint::ConversionStep::Reason::gear:
      return tr("{factor} (gear ratio)", {{"factor", factor}});
  }
  return "";
}

std::string steps_in_words(const joint::ColumnConversion& conversion) {
  std::string words;
  for (const joint::ConversionStep& step : conversion.steps) {
    if (!words.empty()) words += ' ';
    words += step_in_words(step, conversion);
  }
  return words.empty() ? tr("as logged") : words;
}

std::string logs_in_words(const std::vector<std::string>& files) {
  std::string named;
  for (std::size_t i = 0; i < std::min(files.size(), most_logs_named); ++i) {
    named += (named.empty() ? "" : ", ") + elements::log_name(files[i]);
  }
  if (files.size() <= most_logs_named) return named;
  return tr("{logs} and {others} more",
            {{"logs", named}, {"others", wording::count(files.size() - most_logs_named)}});
}

std::string unit_of_angles(const joint::KnownLoad& load) {
  if (load.radian_per_unit == 1) return "rad";
  return wording::with_unit(wording::as_stated(load.radian_per_unit), "rad");
}

std::string roles_in_words(const std::vector<joint::Role>& roles) {
  std::string words;
  for (const joint::Role role : roles)
    words += (words.empty() ? "" : ", ") + joint::to_string(role);
  return words.empty() ? tr("all") : words;
}

std::string at_the_side(const std::string& si_unit, joint::Side side) {
  const std::string unit = wording::shown_units(si_unit);
  return side == joint::Side::motor ? tr("{unit}, motor side", {{"unit", unit}})
                                    : tr("{unit}, joint side", {{"unit", unit}});
}

/// As a torque of the joint that is subtracted at the motor.
std::string load_at_motor(const joint::KnownLoad& load, double gear_ratio) {
  if (gear_ratio == 1) return load_formula(load);
  return tr("{load} ÷ {gear_ratio} (gear ratio)",
            {{"load", load_formula(load)}, {"gear_ratio", wording::as_stated(gear_ratio)}});
}

/// The columns that have the angles of other joints.
std::string moved_columns(const joint::Manifest& m) {
  std::string columns;
  for (const joint::OtherJoint& other : m.other_joints) {
    if (other.samples > 0) columns += (columns.empty() ? "" : ", ") + named(other.angle);
  }
  return columns;
}

std::string taken_off_in_words(const joint::ArmGravity& arm, double gear_ratio) {
  constexpr int digits = 3;
  const std::string largest =
      wording::with_unit(wording::significant(arm.largest_Nm, digits), "N·m");
  return tr(
      "by the masses of {file}, against the posture of the first sweep: up to {torque} at the "
      "joint ÷ {gear_ratio} (gear ratio)",
      {{"file", printable(arm.description)},
       {"torque", largest},
       {"gear_ratio", wording::as_stated(gear_ratio)}});
}

Table conversions_table(const calibration::Calibration& c) {
  Table table;
  table.id = "table-conversions";
  table.is_stacked = true;
  table.caption = tr("How each column was used");
  table.columns = {
      {tr("Signal"), "", false},      {tr("Column"), "", false}, {tr("Unit in the log"), "", false},
      {tr("Steps"), "", false, true}, {tr("Factor"), "", true},  {tr("Result"), "", false},
      {tr("Logs"), "", false}};
  for (const joint::SharedConversion& shared : joint::shared_conversions(c.inputs)) {
    const joint::ColumnConversion& one = shared.conversion;
    const std::string unit =
        one.is_proposed ? tr("{unit}: proposed, not confirmed", {{"unit", one.unit}}) : one.unit;
    table.rows.push_back({{signal_in_words(one.signal), named(one.column), unit,
                           steps_in_words(one), wording::as_stated(one.factor()),
                           one.side ? at_the_side(one.si_unit, *one.side) : one.si_unit,
                           shared.is_of_all ? tr("all") : logs_in_words(shared.files)},
                          false});
  }
  const double n = c.manifest.drive.gear_ratio();
  for (const joint::KnownLoad& load : c.manifest.known_loads) {
    std::string angles;
    for (const std::string& name : load.angles)
      angles += (angles.empty() ? "" : ", ") + named(name);
    table.rows.push_back({{tr("Known load, subtracted from the torque"), angles,
                           unit_of_angles(load), load_at_motor(load, n), "–",
                           at_the_side("N·m", joint::Side::motor), roles_in_words(load.roles)},
                          false});
  }
  const std::optional<joint::ArmGravity>& arm = c.manifest.arm_gravity;
  if (arm && arm->samples > 0) {
    table.rows.push_back({{tr("Gravity of the other joints' motion, subtracted from the torque"),
                           moved_columns(c.manifest), "–", taken_off_in_words(*arm, n), "–",
                           at_the_side("N·m", joint::Side::motor), tr("all that have the columns")},
                          false});
  }
  return table;
}

std::string way_to_speed(joint::Role role) {
  switch (role) {
    case joint::Role::rough_sweep:
    case joint::Role::precise_sweep:
      return tr("local slope of the angle at every sample");
    case joint::Role::constant_speed:
      return tr(
          "travel of a plateau divided by its time; the local slope of the angle finds the "
          "plateaus");
    case joint::Role::oscillation:
      return tr(
          "derivative of the curve fitted to the angle: harmonics, or a smoothing spline where a "
          "torque drives it");
    case joint::Role::friction_points:
      break;
    case joint::Role::break_away:
      return tr("travel divided by time across 20 steps of the angle or a tenth of the travel");
  }
  return "–";
}

bool uses_local_slope(joint::Role role) {
  return role != joint::Role::oscillation && role != joint::Role::break_away;
}

/// "9.0 ms", or "9.0 … 12 ms".
std::string range_in_words(double low, double high, const std::string& unit) {
  const std::string first = wording::significant(low, digits_of_time);
  const std::string last = wording::significant(high, digits_of_time);
  return wording::with_unit(first == last ? first : first + " … " + last, unit);
}

/// In how many of the recordings.
std::string logged_in_words(std::size_t logged, std::size_t recordings) {
  if (logged == 0) return tr("no");
  if (logged == recordings) return tr("yes");
  return tr("in {recordings}", {{"recordings", wording::count(logged)}});
}

/// "9.0 … 12 ms, 9 … 12 samples"
std::string window_in_words(const method::motion::SpeedSource& shortest,
                            const method::motion::SpeedSource& longest) {
  constexpr double ms_per_s = 1000;
  const auto [fewest, most] = std::minmax(shortest.window, longest.window);
  const std::string samples = wording::count(fewest);
  return tr_count(
      most, "{time}, {samples} sample", "{time}, {samples} samples",
      {{"time", range_in_words(ms_per_s * shortest.window_s, ms_per_s * longest.window_s, "ms")},
       {"samples", fewest == most ? samples : samples + " … " + wording::count(most)}});
}

Table speeds_table(const std::vector<method::motion::SpeedSource>& sources) {
  Table table;
  table.id = "table-speeds";
  table.is_stacked = true;
  table.caption = tr("Where speeds come from");
  table.columns = {{tr("Recordings"), "", false},
                   {tr("Speed logged"), "", false},
                   {tr("Speed used"), "", false, true},
                   {tr("Window"), "", false},
                   {tr("Cut-off"), "", false}};
  for (const joint::Role role :
       {joint::Role::rough_sweep, joint::Role::precise_sweep, joint::Role::oscillation,
        joint::Role::constant_speed, joint::Role::break_away}) {
    std::vector<method::motion::SpeedSource> of_role;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(of_role),
                 [&](const method::motion::SpeedSource& s) { return s.role == role; });
    if (of_role.empty()) continue;
    const auto logged = static_cast<std::size_t>(
        std::count_if(of_role.begin(), of_role.end(),
                      [](const method::motion::SpeedSource& s) { return s.is_logged; }));
    const auto range = [&](double method::motion::SpeedSource::* number) {
      return std::minmax_element(
          of_role.begin(), of_role.end(),
          [&](const method::motion::SpeedSource& a, const method::motion::SpeedSource& b) {
            return a.*number < b.*number;
          });
    };
    const auto [shortest, longest] = range(&method::motion::SpeedSource::window_s);
    const auto [lowest, highest] = range(&method::motion::SpeedSource::cut_off_Hz);
    const bool has_window = uses_local_slope(role);
    table.rows.push_back(
        {{joint::to_string(role) + " (" + wording::count(of_role.size()) + ")",
          logged_in_words(logged, of_role.size()), way_to_speed(role),
          has_window ? window_in_words(*shortest, *longest) : "–",
          has_window ? range_in_words(lowest->cut_off_Hz, highest->cut_off_Hz, "Hz") : "–"},
         false});
  }
  table.note = tr(
      "Speeds are derivatives of the angle, whether one is logged or not; a logged speed is only "
      "compared with it in the checks on the data. Local slope: mean angle of the half window "
      "after a sample, minus that of the half window before it, divided by the difference of their "
      "mean times. This is the derivative of the angle smoothed by a triangle as wide as the "
      "window, without phase shift; at the cut-off it has fallen by 3 dB.");
  return table;
}

}  // namespace

std::string load_formula(const joint::KnownLoad& load) {
  std::string angles;
  for (const std::string& name : load.angles) angles += (angles.empty() ? "" : " + ") + name;
  const double phase = load.phase_rad * wording::degree_scale().factor;
  if (phase != 0)
    angles +=
        (phase > 0 ? " + " : " − ") + wording::with_unit(wording::as_stated(std::abs(phase)), "°");
  return wording::with_unit(wording::as_stated(load.amplitude_Nm), "N·m") + " cos(" + angles + ")";
}

std::vector<Table> conversion_tables(const calibration::Calibration& c) {
  return {conversions_table(c), speeds_table(c.speed_sources)};
}

}  // namespace tribolog::report::document
