#include "calibration/read_calibration.h"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/closest_match.h"
#include "base/enum_text.h"
#include "base/error.h"
#include "calibration/friction_speeds.h"
#include "calibration/json_values.h"
#include "ingest/text/fields.h"
#include "joint/quantity.h"
#include "statistics/order_statistics.h"

namespace tribolog::calibration {
namespace {

using ReadJson = nlohmann::json;

[[noreturn]] void refuse(const std::string& file, const std::string& what,
                         const std::string& expected) {
  throw InputError({file, 0, 0},
                   {what, "", expected, "tribolog identify writes a file that can be archived"});
}

/// Reads members, and names the one that is missing or of another type.
class Members {
 public:
  Members(const ReadJson& object, std::string path, const std::string& file)
      : object_(object), path_(std::move(path)), file_(file) {
    if (!object.is_object()) refuse(file_, path_ + " is missing", "an object");
  }

  [[nodiscard]] Members object(const char* key) const {
    return {member(key), path_ + "." + key, file_};
  }
  [[nodiscard]] const ReadJson& list(const char* key) const {
    const ReadJson& value = member(key);
    if (!value.is_array()) refuse(file_, path_ + "." + key + " is missing", "a list");
    return value;
  }
  /// Empty for null.
  [[nodiscard]] std::string text(const char* key) const {
    const ReadJson& value = member(key);
    if (value.is_null()) return "";
    if (!value.is_string()) refuse(file_, path_ + "." + key, "a text");
    return value.get<std::string>();
  }
  [[nodiscard]] std::optional<double> number(const char* key) const {
    const ReadJson& value = member(key);
    if (value.is_null()) return std::nullopt;
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      refuse(file_, path_ + "." + key, "a number");
    }
    return value.get<double>();
  }
  [[nodiscard]] Verdict verdict(const char* key) const {
    if (const auto verdict = own_names<Verdict>.find(text(key))) return *verdict;
    refuse(file_, path_ + "." + key, "usable, doubtful or not_identifiable");
  }
  [[nodiscard]] std::optional<statistics::Estimate> estimate(const char* key) const {
    if (member(key).is_null()) return std::nullopt;
    const Members e = object(key);
    const auto value = e.number("estimate");
    if (!value) return std::nullopt;
    const statistics::Estimate estimate{*value, e.number("low").value_or(*value),
                                        e.number("high").value_or(*value),
                                        Statement::verbatim(e.text("method"))};
    if (estimate.low > estimate.value || estimate.high < estimate.value) {
      refuse(file_, path_ + "." + key + " lies outside of its interval", "low <= estimate <= high");
    }
    return estimate;
  }

 private:
  [[nodiscard]] const ReadJson& member(const char* key) const {
    static const ReadJson none;
    const auto at = object_.find(key);
    return at == object_.end() ? none : *at;
  }

  const ReadJson& object_;
  std::string path_;
  const std::string& file_;
};

std::optional<double> sampling_rate(const Members& top, const std::string& file) {
  std::vector<double> rates_Hz;
  for (const ReadJson& speed : top.list("speeds")) {
    const Members of_recording(speed, "speeds", file);
    const auto samples = of_recording.number("window_samples");
    const auto seconds = of_recording.number("window_s");
    if (samples && seconds && *seconds > 0) rates_Hz.push_back(*samples / *seconds);
  }
  if (rates_Hz.empty()) return std::nullopt;
  return statistics::median(std::move(rates_Hz));
}

/// Refuses values that no joint can have.
void refuse_impossible(const Facts& f, const std::string& file) {
  constexpr double absolute_zero_C = -273.15;
  const auto need = [&](bool holds, const char* what, const char* expected) {
    if (!holds) refuse(file, std::string(what) + " is not usable", expected);
  };
  need(f.gear_ratio != 0, "drive.gear_ratio", "another number than 0");
  need(f.payload_kg.value_or(0) >= 0, "robot.payload_kg", "a number >= 0");
  need(f.payload_distance_m.value_or(1) > 0, "robot.payload_distance_m", "a number > 0");
  need(f.temperature_C.value_or(0) > absolute_zero_C, "robot.temperature_C",
       "a number above -273.15");
  need(f.sampling_Hz.value_or(1) > 0 && std::isfinite(f.sampling_Hz.value_or(1)),
       "speeds: the number of samples in the window", "more than none");
}

Facts facts_of(const Members& top, const std::string& file) {
  const Members robot = top.object("robot");
  const Members verdict = top.object("verdict");
  const Members provenance = top.object("provenance");
  Facts f;
  f.of = {robot.text("name"), robot.text("serial"), robot.text("joint")};
  f.created_utc = provenance.text("created_utc");
  f.measured_on = robot.text("measured_on");
  f.measured_at = utc_of_iso_text(f.measured_on);
  f.time_is_stated = !f.measured_at.empty();
  if (!f.time_is_stated) f.measured_at = utc_of_iso_text(f.created_utc);
  if (f.measured_at.empty()) {
    refuse(file, "says neither when it was measured nor when it was made",
           "provenance.created_utc");
  }
  f.operator_name = robot.text("operator");
  f.note = robot.text("note");
  f.payload = robot.text("payload");
  f.payload_kg = robot.number("payload_kg");
  f.payload_distance_m = robot.number("payload_distance_m");
  f.temperature_C = robot.number("temperature_C");
  f.gear_ratio = top.object("drive").number("gear_ratio").value_or(1);
  f.sampling_Hz = sampling_rate(top, file);
  f.verdict = verdict.verdict("verdict");
  f.sentence = verdict.text("sentence");
  for (const ReadJson& setting : provenance.list("configuration")) {
    const Members one(setting, "provenance.configuration", file);
    f.configuration += one.text("name") + ": " + one.text("text") + "\n";
  }
  f.tool_version = provenance.text("version");
  f.git_revision = provenance.text("git_revision");
  refuse_impossible(f, file);
  return f;
}

/// A text for the tables must not contain NUL, which PostgreSQL cannot store.
void refuse_nul(const ReadJson& value, const std::string& file) {
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (text.find('\0') != std::string::npos) {
      refuse(file, "the character NUL stands in " + in_quotes(text), "text without it");
    }
    return;  // the elements of a text that is not structured would be itself
  }
  if (!value.is_structured()) return;
  for (const ReadJson& inner : value) refuse_nul(inner, file);
}

std::vector<StatedInfluence> influences_of(const ReadJson& quantity) {
  std::vector<StatedInfluence> influences;
  const ReadJson& parts = member(member(quantity, "budget"), "parts");
  if (!parts.is_array()) return influences;
  for (const ReadJson& part : parts) {
    const ReadJson& name = member(part, "influence");
    const ReadJson& id = member(part, "id");
    const ReadJson& uncertainty = member(part, "standard_uncertainty");
    if (member(part, "type") != "B" || !name.is_string() || !uncertainty.is_number()) continue;
    influences.push_back({name.get<std::string>(), id.is_string() ? id.get<std::string>() : "",
                          uncertainty.get<double>()});
  }
  return influences;
}

joint::TorqueUnit torque_unit_of(const ReadJson& top) {
  const bool is_ampere = member(member(top, "drive"), "torque_is_in_amperes") == true;
  return is_ampere ? joint::TorqueUnit::ampere : joint::TorqueUnit::newton_metre;
}

std::vector<Quantity> quantities_of(const Members& verdict, const std::string& file) {
  std::vector<Quantity> quantities;
  for (const ReadJson& listed : verdict.list("quantities")) {
    const Members one(listed, "verdict.quantities", file);
    quantities.push_back({one.text("key"), one.text("words"), one.text("unit"),
                          one.verdict("verdict"), one.estimate("estimate"), influences_of(listed)});
  }
  return quantities;
}

std::vector<Input> inputs_of(const Members& top, const std::string& file) {
  constexpr double largest = 9e15;  // whole in a double
  std::vector<Input> inputs;
  for (const ReadJson& listed : top.list("inputs")) {
    const Members one(listed, "inputs", file);
    Input input{one.text("name"), one.text("role"), 0, one.text("sha256")};
    const double bytes = one.number("bytes").value_or(-1);
    const bool is_hash = input.sha256.size() == 64 &&
                         input.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!is_hash || bytes < 0 || bytes > largest) {
      refuse(file, "inputs: " + in_quotes(input.name), "its bytes and SHA-256");
    }
    input.bytes = static_cast<std::uint64_t>(bytes);
    inputs.push_back(std::move(input));
  }
  if (inputs.empty()) refuse(file, "names no input", "the files it was made from");
  return inputs;
}

ReadJson parsed(const std::string& json, const std::string& file) {
  try {
    return ReadJson::parse(json);
  } catch (const ReadJson::exception& error) {
    throw InputError({file, 0, 0}, {"is no JSON", error.what(), "a calibration",
                                    "tribolog identify writes a file that can be archived"});
  }
}

// The curves.

double number_or_nan(const ReadJson& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> numbers_of(const ReadJson& list) {
  std::vector<double> values;
  if (!list.is_array()) return values;
  for (const ReadJson& value : list) values.push_back(number_or_nan(value));
  return values;
}

/// Of the gravity torque of an estimator; NaN: not recorded.
double half_width_of_gravity(const ReadJson& top, const std::string& estimator) {
  const ReadJson& masses = member(top, "surrogate_masses");
  for (std::size_t k = 0; masses.is_array() && k < masses.size(); ++k) {
    if (member(masses[k], "estimator") != estimator) continue;
    const ReadJson& gravity = member(masses[k], "gravity_Nm");
    return (number_or_nan(member(gravity, "high")) - number_or_nan(member(gravity, "low"))) / 2;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

RecordedFriction friction_of(const ReadJson& top) {
  const ReadJson& viscous = member(top, "viscous");
  const ReadJson& runs = member(viscous, "runs");
  const ReadJson& chosen = member(member(top, "selection"), "recommended");
  if (!runs.is_array() || !chosen.is_string()) return {};
  const std::vector<double> friction =
      numbers_of(member(member(viscous, "curves"), chosen.get<std::string>()));
  if (friction.size() != runs.size()) return {};
  RecordedFriction made;
  made.estimator = chosen.get<std::string>();
  made.from_sweep = member(viscous, "from_sweep") != false;
  const double of_gravity = half_width_of_gravity(top, made.estimator);
  std::vector<int> place(friction.size(), -1);  // of each run among those that are read
  for (std::size_t k = 0; k < friction.size(); ++k) {
    const double speed = number_or_nan(member(runs[k], "speed_rad_s"));
    if (!std::isfinite(speed) || !std::isfinite(friction[k])) continue;
    place[k] = static_cast<int>(made.speed_rad_s.size());
    const ReadJson& partner = member(runs[k], "partner");
    made.partner.push_back(partner.is_number_integer() ? partner.get<int>() : -1);
    made.direction_difference_Nm.push_back(
        number_or_nan(member(runs[k], "direction_difference_Nm")));
    made.speed_rad_s.push_back(speed);
    made.friction_Nm.push_back(friction[k]);
    made.half_width_Nm.push_back(number_or_nan(member(runs[k], "torque_half_width_Nm")));
    made.half_band_Nm.push_back(std::hypot(
        made.half_width_Nm.back(), of_gravity * number_or_nan(member(runs[k], "mean_cos"))));
  }
  for (int& partner : made.partner) {
    const bool is_one = partner >= 0 && static_cast<std::size_t>(partner) < place.size();
    partner = is_one ? place[static_cast<std::size_t>(partner)] : -1;
  }
  return made;
}

std::vector<RecordedLoop> loops_of(const ReadJson& top) {
  std::vector<RecordedLoop> loops;
  const ReadJson& oscillations = member(member(top, "hysteresis"), "oscillations");
  if (!oscillations.is_array()) return loops;
  for (const ReadJson& oscillation : oscillations) {
    const ReadJson& steady = member(oscillation, "steady_loop");
    RecordedLoop loop;
    loop.centre_rad = number_or_nan(member(steady, "centre_rad"));
    loop.from_centre_rad = numbers_of(member(steady, "angle_from_centre_rad"));
    loop.torque_Nm = numbers_of(member(steady, "torque_Nm"));
    const bool is_whole = std::isfinite(loop.centre_rad) && loop.torque_Nm.size() > 2 &&
                          loop.torque_Nm.size() == loop.from_centre_rad.size();
    if (is_whole) loops.push_back(std::move(loop));
  }
  return loops;
}

std::optional<Verdict> verdict_of(const ReadJson& word) {
  for (const Verdict verdict : {Verdict::usable, Verdict::doubtful, Verdict::not_identifiable}) {
    if (word == to_string(verdict)) return verdict;
  }
  return std::nullopt;
}

/// Absent: of an older program, or no interval.
std::optional<statistics::Estimate> interval_of(const ReadJson& one) {
  const double value = number_or_nan(member(one, "estimate"));
  const double low = number_or_nan(member(one, "low"));
  const double high = number_or_nan(member(one, "high"));
  const bool is_one = low <= value && value <= high && std::isfinite(low) && std::isfinite(high);
  return is_one ? std::optional(statistics::Estimate{value, low, high, {}}) : std::nullopt;
}

std::vector<FrictionAtSpeed> friction_at_speed_of(const ReadJson& top) {
  std::vector<FrictionAtSpeed> all;
  const ReadJson& listed = member(top, "friction_at_speed");
  if (!listed.is_array()) return all;
  for (const ReadJson& one : listed) {
    const double speed = number_or_nan(member(one, "speed_rad_s"));
    const std::optional<statistics::Estimate> torque = interval_of(one);
    const std::optional<Verdict> verdict = verdict_of(member(one, "verdict"));
    const ReadJson& reason = member(one, "reason");
    const bool is_rising = all.empty() || speed > all.back().speed_rad_s;
    if (!(speed > 0) || !std::isfinite(speed) || !is_rising || !torque || !verdict) continue;
    all.push_back(
        {speed, *verdict, *torque,
         reason.is_string() ? Statement::verbatim(reason.get<std::string>()) : Statement{}, false,
         interval_of(member(one, "forward")), interval_of(member(one, "backward"))});
  }
  return all;
}

RecordedCurves curves_of(const ReadJson& top) {
  const ReadJson& of_law = member(member(member(top, "model"), "law"), "fastest_rad_s");
  // Of an older calibration the straight line's.
  const ReadJson& fastest =
      of_law.is_number()
          ? of_law
          : member(member(member(top, "friction"), "coulomb_viscous"), "fastest_rad_s");
  std::vector<FrictionAtSpeed> friction = friction_at_speed_of(top);
  std::vector<double> stated;
  const ReadJson& listed = member(top, "friction_stated_at_rad_s");
  if (listed.is_array()) {
    for (const ReadJson& one : listed) stated.push_back(number_or_nan(one));
  }
  mark_stated_speeds(stated, friction);
  return {friction_of(top),
          fastest.is_number() ? std::optional(fastest.get<double>()) : std::nullopt, loops_of(top),
          torque_unit_of(top), std::move(friction)};
}

}  // namespace

std::string utc_of_iso_text(const std::string& text) {
  for (const char* const rest : {"", "Z", ":00", "T00:00:00"}) {
    const auto read = ingest::text::read_iso_time(text + rest);
    if (!read) continue;
    const std::chrono::sys_seconds time{std::chrono::seconds(read->whole)};
    const auto day = std::chrono::floor<std::chrono::days>(time);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss clock(time - day);
    const int year = static_cast<int>(date.year());
    if (year < 0 || year > 9999) return "";  // by its offset
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", year,
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                       clock.hours().count(), clock.minutes().count(), clock.seconds().count());
  }
  return "";
}

double seconds_of_utc(const std::string& utc) {
  const auto time = ingest::text::read_iso_time(utc);
  return time ? static_cast<double>(time->whole) : 0;
}

RecordedCalibration read_calibration(const std::string& json, const std::string& file) {
  const ReadJson whole = parsed(json, file);
  const Members top(whole, "the file", file);
  if (top.text("schema") != "tribolog-calibration-1") {
    refuse(file, "is no calibration", "schema \"tribolog-calibration-1\"");
  }
  refuse_nul(whole, file);
  return {facts_of(top, file), quantities_of(top.object("verdict"), file), inputs_of(top, file),
          curves_of(whole)};
}

RecordedCurves read_curves(const std::string& json) {
  const ReadJson whole = ReadJson::parse(json, nullptr, false);
  return whole.is_discarded() ? RecordedCurves{} : curves_of(whole);
}

std::map<std::string, std::vector<StatedInfluence>> read_influences(const std::string& json) {
  std::map<std::string, std::vector<StatedInfluence>> all;
  const ReadJson whole = ReadJson::parse(json, nullptr, false);
  if (whole.is_discarded()) return all;
  const ReadJson& quantities = member(member(whole, "verdict"), "quantities");
  if (!quantities.is_array()) return all;
  for (const ReadJson& quantity : quantities) {
    const ReadJson& key = member(quantity, "key");
    if (key.is_string()) all[key.get<std::string>()] = influences_of(quantity);
  }
  return all;
}

NewCalibration entry_of_calibration(const std::string& json, const std::string& file) {
  RecordedCalibration read = read_calibration(json, file);
  const std::string unit =
      unit_of(joint::Quantity::coulomb_torque, torque_unit_of(read.quantities));
  for (const FrictionAtSpeed& f : at_standard_speeds(read.curves.friction_at_speed)) {
    read.quantities.push_back({friction_name(f.speed_rad_s),
                               fmt::format("Friction at {:g} rad/s", f.speed_rad_s), unit,
                               f.verdict, f.torque_Nm});
  }
  return {std::move(read.facts),
          std::move(read.quantities),
          std::move(read.inputs),
          {{DocumentKind::calibration, "", json}}};
}

}  // namespace tribolog::calibration
