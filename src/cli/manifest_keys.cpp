#include "cli/manifest_keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/enum_text.h"
#include "friction/catalogue.h"
#include "ingest/log/register.h"
#include "ingest/log/units.h"
#include "ingest/manifest/toml_table.h"
#include "joint/dataset.h"
#include "joint/effects.h"
#include "joint/gravity_load.h"
#include "wording/words.h"

namespace tribolog::cli {
namespace {

using Keys = std::vector<ManifestKey>;
using ingest::log::Quantity;

constexpr const char* required = "required";
constexpr const char* none = "–";

/// "10⁻⁶", "6.3×10³", "50"
std::string magnitude(double value) {
  constexpr double small = 1e-3;
  constexpr double large = 1e4;
  if (value == 0 || (value >= small && value < large)) return fmt::format("{:g}", value);
  static constexpr std::array<std::string_view, 10> superscripts = {"⁰", "¹", "²", "³", "⁴",
                                                                    "⁵", "⁶", "⁷", "⁸", "⁹"};
  constexpr double exact = 1e-9;
  const int power = static_cast<int>(std::floor(std::log10(value) + exact));
  const double factor = value / std::pow(10.0, power);
  std::string text = std::abs(factor - 1) < exact ? "10" : fmt::format("{:g}×10", factor);
  if (power < 0) text += "⁻";
  for (const char digit : std::to_string(std::abs(power))) {
    text += superscripts.at(static_cast<std::size_t>(digit - '0'));
  }
  return text;
}

/// By the key's own range, of numbers of either sign "to either side of 0".
std::string number(std::string_view key, bool has_sign = false) {
  const ingest::manifest::KeyRange range = ingest::manifest::range_of_key(key);
  const std::string unit = range.unit.empty() ? "" : " " + range.unit;
  if (has_sign) return fmt::format("number, at most {}{} in size", magnitude(range.largest), unit);
  return fmt::format("number, {} to {}{}", magnitude(range.smallest), magnitude(range.largest),
                     unit);
}

/// What stands on the end of a number's range, as no key's name says it.
std::string number_between(const char* lowest, const char* highest, const char* unit = "") {
  return fmt::format("number, {} to {}{}{}", lowest, highest, *unit == 0 ? "" : " ", unit);
}

std::string any_word_of(const std::vector<std::string>& words) {
  return fmt::format("`{}`", fmt::join(words, "`, `"));
}

std::string units_of(Quantity quantity) {
  return ingest::log::known_units(quantity) + ", or a multiple such as `" +
         std::string(ingest::log::example_of_multiple(quantity)) + "`";
}

ManifestTable top_table() {
  return {{""},
          false,
          "The tables of the file, and one key that stands before them.",
          {{"schema", "`tribolog-dataset-1`", required, "the layout of this file"},
           {"robot", "table", required, "which robot was measured, when and by whom"},
           {"joint", "table", required,
            "which joint, and its gear; `[[joints]]` in its place for a whole robot"},
           {"effort", "table", required, "what the torque or current is; never guessed"},
           {"columns", "table", none, "which column of the logs is which"},
           {"log", "table", none, "what a text log does not show by itself"},
           {"recording", "tables", required, "the recordings, each with its role: one or more"},
           {"limit", "tables", none, "what you accept; the report states whether it is met"},
           {"uncertainty", "table", none, "errors that no recording shows"},
           {"effects", "table", none, "sizes of disturbing effects that you know"},
           {"known_gravity", "table", none, "gravity torque by the design, to compare with"},
           {"known_load", "tables", none, "gravity of further axes, subtracted when logs are read"},
           {"other_joint", "tables", none, "other joints whose angles the logs contain"},
           {"payload", "table", none, "what the joint carried"},
           {"temperature", "table", none, "how warm the joint was"},
           {"surrogate", "table", none, "where the surrogate mass is thought to be"},
           {"reference", "table", none, "a friction curve that is known, to compare with"},
           {"certificate", "table", none, "what a calibration certificate states besides"},
           {"intervals", "table", none, "the seed of simulations"}}};
}

ManifestTable robot_table() {
  return {{"robot"},
          false,
          "Report and archive go by these names. `name`, `serial` and the joint's name identify a "
          "joint in the "
          "archive.",
          {{"name", "text", required, "the robot's name"},
           {"serial", "text", none, "its serial number"},
           {"operator", "text", none, "who measured"},
           {"measured_on", "date or text, `2026-11-22` or `2026-11-22T14:05:00+01:00`", none,
            "when; without it a trend over time uses the date of the report"},
           {"note", "text", none, "a remark, printed in the report"},
           {"description", "name of a file", none,
            "the arm: TOML for drawings of it, or URDF with masses, from which gravity of moving "
            "neighbours follows"},
           {"gravity", "three numbers, m/s², 9.7 to 9.9 in size", "[0, 0, -9.80665]",
            "direction of gravity in the frame of the base; for a URDF alone"}}};
}

ManifestTable joint_table() {
  return {{"joint"},
          false,
          "In a manifest of a whole robot these keys stand in each of `[[joints]]`.",
          {{"name", "text", required, "the joint's name"},
           {"gear_ratio", number("gear_ratio") + "; or `\"101:1\"`", required,
            "motor angle divided by joint angle; 1 for a direct drive, or where a log has the "
            "joint side alone"},
           {"gravity", "`none`", none,
            "gravity does not turn the joint (a vertical axis, a bare motor): friction is judged "
            "alone"},
           {"friction_at_rad_s", "list of numbers above 0 rad/s, at most 20",
            "five of those measured", "speeds of the joint at which the report states friction"}}};
}

ManifestTable effort_table() {
  return {
      {"effort"},
      false,
      "The same column is ampere on one robot and newton metre on another, so it has to be stated.",
      {{"kind", any_word_of(own_names<joint::EffortKind>.all()), required,
        "`target_torque`: a controller's value, no measurement, and no number from it is usable; "
        "`none`: the log "
        "has no torque, and its motion alone is checked"},
       {"side", any_word_of({"motor", "joint"}), required,
        "the side of the gear on which the torque acts; not with kind `none`"},
       {"torque_constant_Nm_A", number("torque_constant_Nm_A") + "; or `\"unknown\"`",
        "required for `motor_current`",
        "torque per ampere on that side; `\"unknown\"`: all torques are given in amperes"},
       {"sign", "1 or -1", "1", "-1: the torque counts the other way round than the angle"},
       {"confirmed", "true or false", "true",
        "false: kind and side are only proposed, and every torque is doubtful"},
       {"gravity_removed", "true or false", "false",
        "true: the controller had taken gravity off before logging"}}};
}

std::vector<ManifestTable> column_tables() {
  const ManifestKey name{"name", "text", required,
                         "the column's name in the log; `#3` is the third column"};
  const ManifestKey sign{"sign", "1 or -1", "1", "-1: the column counts the other way round"};
  const ManifestKey side{"side", any_word_of({"motor", "joint"}), "`joint`",
                         "the side of the gear that was measured"};
  const ManifestKey confirmed{
      "confirmed", "true or false", "true",
      "false: the unit is only proposed, and every number that it scales is doubtful"};
  const ManifestKey of_register{"register", "one of " + ingest::log::register_names(), none,
                                "the register was logged without its sign (65528 for -8)"};
  const ManifestKey file{
      "file", "name of a file", "the recording's",
      "the log in which the column is, where a logger writes a file for each quantity"};
  const ManifestKey time{"time", "text", "the name of the recording's time",
                         "the name of the time in that `file`, if it has one"};
  const auto column = [&](const std::string& unit, std::initializer_list<ManifestKey> more) {
    Keys keys{name, {"unit", "text", required, unit}};
    keys.insert(keys.end(), more.begin(), more.end());
    keys.insert(keys.end(), {of_register, file, time});
    return keys;
  };
  const std::string angle_or_speed = "of an angle: " + units_of(Quantity::angle) +
                                     "; of a speed: " + units_of(Quantity::angular_speed);
  return {
      {{"columns", "recording.columns"},
       false,
       "Each is a table: `angle = { name = \"q_deg\", unit = \"deg\" }`. What a recording states "
       "in "
       "`[recording.columns]` replaces what `[columns]` says.",
       {{"time", "table", required, "the clock; not of friction points"},
        {"angle", "table", required, "the angle of joint or motor; not of friction points"},
        {"speed", "table", none,
         "the speed, which is only compared with the angle's slope; required of friction points"},
        {"effort", "table", "required unless kind is `none`", "the torque or the current"},
        {"temperature", "table", none, "the joint's temperature"},
        {"load", "table", none, "of friction points: the torque that loads the gear"},
        {"rows", "table", none, "which rows are this joint's, where each row is one joint's"},
        {"bristle", "table", none, "of simulated logs: the bristle's deflection"},
        {"bristle_rate", "table", none, "of simulated logs: its rate"}}},
      {{"columns.time"},
       false,
       "",
       {name,
        {"unit", "text", required, units_of(Quantity::time) + "; or `iso8601`, `hh:mm:ss`"},
        {"rate_Hz", number("rate_Hz"), none,
         "in place of all other keys: rows without a clock come at this rate"},
        {"plus", "table", none,
         "a second column that is added: a date to a time of day, nanoseconds to seconds"},
        {"any_rate", "true or false", "false", "true: accept a rate that no log usually has"},
        confirmed,
        of_register}},
      {{"columns.time.plus"},
       false,
       "",
       {{"name", "text", required, "the column that is added to the time"},
        {"unit", "text", required, "`yyyy-mm-dd` beside a time of day; else a unit of time"}}},
      {{"columns.angle", "columns.speed"},
       false,
       "",
       column(angle_or_speed, {side, sign, confirmed})},
      {{"columns.effort"},
       false,
       "",
       column("of a current where `[effort] kind` is `motor_current`: " +
                  units_of(Quantity::current) + "; else of a torque: " + units_of(Quantity::torque),
              {sign})},
      {{"columns.temperature"}, false, "", column(units_of(Quantity::temperature), {})},
      {{"columns.load"}, false, "", column(units_of(Quantity::torque), {side, sign})},
      {{"columns.bristle", "columns.bristle_rate"}, false, "", column(angle_or_speed, {confirmed})},
      {{"columns.rows"},
       false,
       "",
       {{"name", "text", required, "the column that tells whose a row is"},
        {"value", "text", required, "what is in it where a row is this joint's"}}}};
}

ManifestTable log_table() {
  return {{"log"},
          false,
          "Separators and most dialects are detected.",
          {{"decimal_comma", "true or false", "false", "numbers are written as 3,14"},
           {"delimiter", any_word_of({"comma", "semicolon", "tab", "spaces"}), "detected",
            "what separates columns"},
           {"encoding", any_word_of({"utf8", "latin1"}), "`utf8`", "of the columns' names"},
           {"header_line", "whole number from 1", "detected", "the line of the columns' names"},
           {"skip_bad_rows", "true or false", "false",
            "leave out and count unusable rows and impossible numbers, up to 1 % of all"}}};
}

ManifestTable recording_table() {
  return {{"recording"},
          true,
          "Any number of each role; each role is optional.",
          {{"role", any_word_of(own_names<joint::Role>.all()), required, "what was run"},
           {"file", "name of a file", required, "the log, relative to the manifest"},
           {"from_s", number("from_s", true), "the log's beginning",
            "begin of the part that is meant, on the log's clock"},
           {"to_s", number("to_s", true), "the log's end", "its end"},
           {"note", "text", none, "a remark"},
           {"columns", "table", "as `[columns]`", "columns of this recording that differ"}}};
}

ManifestTable limit_table() {
  std::vector<std::string> quantities;
  for (const joint::LimitedQuantity& one : joint::limited_quantities()) {
    quantities.emplace_back(one.key);
  }
  return {{"limit"},
          true,
          "One or more of the four numbers. A limit is met only if the whole interval keeps it.",
          {{"quantity", any_word_of(quantities), required,
            "what is limited, with side and unit in its name"},
           {"min", "number, in that unit", none, "no less"},
           {"max", "number, in that unit", none, "no more"},
           {"half_width", "number above 0, in that unit", none,
            "the widest half of the 95 % interval; it replaces the program's own need"},
           {"half_width_percent", number("half_width_percent"), none,
            "the same, as a percentage of the number"}}};
}

std::vector<ManifestTable> uncertainty_tables() {
  const std::string share = number_between("0", "50", "%");
  return {
      {{"uncertainty"},
       false,
       "Half widths at 95 %. They widen the expanded uncertainty, not the estimate's own interval.",
       {{"torque_constant_percent", share, none,
         "of the torque constant, or of the torque sensor's scale"},
        {"gear_ratio_percent", share, none, "of the gear ratio: a belt; teeth are counted"},
        {"surrogate_distance_percent", share, none, "of the surrogate mass's distance"},
        {"gravity_percent", share, none, "of the acceleration of gravity"},
        {"angle_zero_deg", number("angle_zero_deg"), none, "of the joint angle's zero"},
        {"hoses_percent", share, none,
         "change of the torque of hoses and cables over a radian, of the gravity torque"},
        {"description_percent", share, "10", "of the masses of a URDF; only with one"},
        {"id", "table", none, "where each error comes from"}}},
      {{"uncertainty.id"},
       false,
       "Two calibrations that name the same source share its error, and are compared without it.",
       {{"torque_constant", "text", none,
         "source of the torque constant: \"torque stand 3, March 2026\""},
        {"gear_ratio", "text", none, "of the gear ratio"},
        {"surrogate_distance", "text", none, "of the distance"},
        {"gravity", "text", none, "of the acceleration of gravity"},
        {"angle_zero", "text", none, "of the angle's zero"},
        {"hoses", "text", none, "of what is stated of hoses"},
        {"description", "text", none, "of the description's masses"}}}};
}

ManifestTable effects_table() {
  ManifestTable table{{"effects"},
                      false,
                      "Sizes of one standard deviation, zero included: `hoses_percent = 0` says "
                      "that there are none. "
                      "What each percentage is of: [model.md](model.md).",
                      {}};
  for (const joint::Effect& effect : joint::statable_effects()) {
    const std::string unit = effect.unit == "percent" ? "%" : std::string(effect.unit);
    table.keys.push_back({effect.stated_key(),
                          fmt::format("number, 0 to {:g} {}", effect.cap * effect.typical, unit),
                          fmt::format("{:g} {}", effect.typical, unit),
                          wording::words_for("effect", effect.key)});
  }
  return table;
}

std::vector<ManifestTable> circumstances_tables() {
  return {
      {{"known_gravity"},
       false,
       "The joint's own gravity by its design. A difference beyond both uncertainties makes every "
       "torque doubtful, "
       "and the likely cause is named.",
       {{"amplitude_Nm", number("amplitude_Nm"), required,
         "the largest gravity torque at the joint; 0: none"},
        {"q_peak_deg", number("q_peak_deg", true), "required unless the amplitude is 0",
         "the joint angle at which it is largest"},
        {"percent", number_between("0", "50", "%"),
         fmt::format("{:g}", joint::StatedGravity::usual_percent),
         "half width of the amplitude at 95 %"}}},
      {{"known_load"},
       true,
       "Subtracted when logs are read: amplitude × cos(sum of the angles + phase).",
       {{"amplitude_Nm", number("amplitude_Nm", true), required, "its amplitude at the joint"},
        {"angles", "array of texts", required, "columns of the log whose sum it follows"},
        {"unit", "text", "`rad`", "unit of those columns"},
        {"phase_deg", number("phase_deg", true), "0", "the phase"},
        {"roles", "array of roles", "all", "the recordings that have the columns"},
        {"note", "text", none, "a remark"}}},
      {{"other_joint"},
       true,
       "In a manifest of a whole robot the other joints are found by themselves.",
       {{"name", "text", required, "the other joint's name, as the description has it"},
        {"angle", "table", required, "its column in this joint's logs"},
        {"gear_ratio", number("gear_ratio"), "required where `side` is `motor`", "of that joint"}}},
      {{"other_joint.angle"},
       false,
       "",
       {{"name", "text", required, "the column's name"},
        {"unit", "text", required, units_of(Quantity::angle)},
        {"sign", "1 or -1", "1", "-1: the column counts the other way round"},
        {"side", any_word_of({"motor", "joint"}), "`joint`",
         "the side of the gear that was measured"}}},
      {{"payload"},
       false,
       "With mass and distance the gravity torque found is checked.",
       {{"mass_kg", number("mass_kg"), none, "the mass that the joint carried"},
        {"distance_m", number("distance_m"), none, "its distance from the axis"},
        {"note", "text", none, "what it was"}}},
      {{"temperature"},
       false,
       "",
       {{"degC", number("degC", true), none, "temperature of the joint"}}},
      {{"surrogate"},
       false,
       "",
       {{"distance_m", number("distance_m"), "0.5",
         "distance of the surrogate mass, freely chosen"},
        {"gravity_m_s2", number("gravity_m_s2"), "9.81",
         "acceleration of gravity by which mass follows from torque"}}}};
}

ManifestTable reference_table() {
  ManifestTable table{{"reference"},
                      false,
                      "One of these; the keys of each are those that `tribolog models` lists.",
                      {}};
  const auto add = [&](const std::string& law) {
    table.keys.push_back({law, "table", none, wording::words_for("friction_model", law)});
  };
  for (const friction::StaticLawEntry& law : friction::static_friction_laws()) add(law.name);
  for (const friction::FrictionModelEntry& model : friction::dynamic_friction_models())
    add(model.name);
  return table;
}

std::vector<ManifestTable> certificate_tables() {
  return {{{"certificate"},
           false,
           "For `tribolog export --format dcc`; it changes no number.",
           {{"number", "text", "`tribolog-` and 12 digits of the calibration",
             "the laboratory's own number"},
            {"replaces", "text", none, "number of the certificate that this one replaces"},
            {"laboratory", "text", none, "who measured"},
            {"laboratory_address", "text", none, "the laboratory's address"},
            {"country", "two letters, as `DE`", "`ZZ`", "the laboratory's country by ISO 3166-1"},
            {"customer", "text", none, "for whom"},
            {"customer_address", "text", none, "the customer's address"},
            {"place", "text", none,
             "where it was measured; `laboratory`, `customer`, `laboratoryBranch` and "
             "`customerBranch` are words of "
             "the schema"},
            {"received_on", "date", none, "when the robot was received"},
            {"procedure", "text", none, "the laboratory's own procedure"},
            {"conditions", "text", none, "conditions beside `[temperature]` and `[payload]`"},
            {"humidity_percent", number_between("0", "100", "%"), none, "relative humidity"},
            {"adjustment", "text", none, "results before and after an adjustment, in words"},
            {"decision_rule", "text", none, "in words"},
            {"responsible", "text", none, "who authorises the certificate"},
            {"instrument", "tables", none, "what was measured with, once for each"}}},
          {{"certificate.instrument"},
           true,
           "",
           {{"name", "text", required, "what was measured with, as its certificate calls it"},
            {"identification", "text", none, "its serial or inventory number"},
            {"traceability", "text", none, "number of its certificate, or a statement"},
            {"used_for", "text", none, "what it measured"}}}};
}

ManifestTable intervals_table() {
  return {{"intervals"},
          false,
          "",
          {{"seed", "whole number", "1", "seed of the known-truth check's simulations"},
           {"resamples", "whole number", none, "accepted in older manifests, without effect"}}};
}

void add(std::vector<ManifestTable> more, std::vector<ManifestTable>& tables) {
  for (ManifestTable& table : more) tables.push_back(std::move(table));
}

/// "`[robot]`", "`[[limit]]`"
std::string heading_of(const ManifestTable& table) {
  if (table.names.front().empty()) return "The file";
  std::vector<std::string> names;
  for (const std::string& name : table.names) {
    names.push_back(table.is_repeated ? "`[[" + name + "]]`" : "`[" + name + "]`");
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string markdown_of(const ManifestTable& table) {
  std::string text = fmt::format("### {}\n\n", heading_of(table));
  if (!table.states.empty()) text += table.states + "\n\n";
  text += "| key | value | default | what it states |\n|---|---|---|---|\n";
  for (const ManifestKey& key : table.keys) {
    text +=
        fmt::format("| `{}` | {} | {} | {} |\n", key.name, key.value, key.otherwise, key.states);
  }
  return text;
}

}  // namespace

std::vector<ManifestTable> manifest_tables() {
  std::vector<ManifestTable> tables{top_table(), robot_table(), joint_table(), effort_table()};
  add(column_tables(), tables);
  tables.push_back(log_table());
  tables.push_back(recording_table());
  tables.push_back(limit_table());
  add(uncertainty_tables(), tables);
  tables.push_back(effects_table());
  add(circumstances_tables(), tables);
  tables.push_back(reference_table());
  add(certificate_tables(), tables);
  tables.push_back(intervals_table());
  return tables;
}

std::string manifest_reference(const std::string& table) {
  std::string text;
  for (const ManifestTable& one : manifest_tables()) {
    const bool is_meant =
        table.empty() ||
        std::any_of(one.names.begin(), one.names.end(), [&](const std::string& name) {
          return name == table || name.starts_with(table + ".");
        });
    if (is_meant) text += (text.empty() ? "" : "\n") + markdown_of(one);
  }
  return text;
}

}  // namespace tribolog::cli
