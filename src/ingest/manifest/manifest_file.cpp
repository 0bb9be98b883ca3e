#include "ingest/manifest/manifest_file.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/enum_text.h"
#include "base/input_file.h"
#include "ingest/log/log_format.h"
#include "ingest/manifest/manifest_tables.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/robot_joints.h"
#include "ingest/manifest/scenario_tables.h"
#include "ingest/manifest/toml_document.h"
#include "ingest/manifest/toml_table.h"
#include "ingest/text/csv_lines.h"
#include "ingest/text/fields.h"
#include "joint/dataset.h"
#include "wording/words.h"

namespace tribolog::ingest::manifest {
namespace {

const std::string effort_hint =
    "state kind = \"motor_current\", \"motor_torque\" or \"joint_torque\": the same column is "
    "ampere on one robot and newton metre on another, so it is never guessed; \"target_torque\" "
    "where it is a controller's value, \"none\" where nothing was recorded";

void read_identity(const TomlTable& top, joint::Manifest& manifest) {
  const TomlTable robot = top.table("robot", "[robot] with the robot's name");
  manifest.robot = required_name(robot, "the report and the archive go by the robot's name");
  manifest.serial = robot.text_or("serial", "");
  manifest.operator_name = robot.text_or("operator", "");
  manifest.measured_on = read_date(robot, "measured_on");
  manifest.note = robot.text_or("note", "");
  const std::string description = read_description_name(robot);
  manifest.arm_gravity = read_arm_gravity(robot, description);
  if (!manifest.arm_gravity) manifest.robot_description = description;
  robot.refuse_unknown_keys();
}

/// Friction points of a joint without a gear need none: their torque is one, on whatever side.
TomlTable effort_of(const TomlTable& top, const TomlTable& joint, const std::string& file) {
  constexpr const char* of_points = "kind = \"joint_torque\"\nside = \"joint\"\n";
  if (!top.has("effort")) {
    const std::vector<TomlTable> recordings = top.tables("recording");
    const bool are_points =
        !recordings.empty() && std::all_of(recordings.begin(), recordings.end(), [](const auto& r) {
          return r.says("role", "friction_points");
        });
    if (are_points && joint.number_or("gear_ratio", 0) == 1)
      return TomlTable::parse(of_points, file);
  }
  return top.table("effort", effort_hint);
}

/// Torques are then numbers of amperes.
bool has_unknown_constant(const TomlTable& effort) {
  return effort.says("torque_constant_Nm_A", "unknown") && effort.says("kind", "motor_current");
}

/// Side and constant of an effort that is not there have no meaning, and are unknown keys.
joint::Drive read_drive(const TomlTable& joint, const TomlTable& effort) {
  const double gear_ratio =
      joint.number("gear_ratio", Sign::positive, "motor angle / joint angle; 1 for a direct drive");
  refuse_voltage_kind(effort);
  const auto kind = static_cast<joint::EffortKind>(
      effort.choice("kind", own_names<joint::EffortKind>.all(), effort_hint));
  if (kind == joint::EffortKind::none) return {gear_ratio, kind, joint::Side::motor};
  const auto side = static_cast<joint::Side>(effort.choice(
      "side", {"motor", "joint"}, "\"motor\": before the gear, or \"joint\": after it"));
  if (has_unknown_constant(effort)) return {gear_ratio, kind, side, 1.0};
  const auto constant = effort.find_number("torque_constant_Nm_A", Sign::positive);
  if (kind == joint::EffortKind::motor_current && !constant) {
    effort.refuse("torque_constant_Nm_A",
                  {" is missing", "", "newton metres per ampere, on the side stated",
                   "without it a current cannot become a torque"});
  }
  return guarded(effort, "torque_constant_Nm_A",
                 [&] { return joint::Drive(gear_ratio, kind, side, constant); });
}

double read_sign(const TomlTable& effort) {
  const double sign = effort.number_or("sign", 1.0);
  if (sign != 1.0 && sign != -1.0) {
    effort.refuse("sign", {"not usable", fmt::format("{}", sign), "1 or -1", ""});
  }
  return sign;
}

/// The table's other key is of programs that resampled: it is accepted in manifests of that time.
std::optional<std::uint64_t> read_seed(const TomlTable& intervals) {
  static_cast<void>(intervals.count_or("resamples", 0));
  std::optional<std::uint64_t> seed;
  if (intervals.has("seed")) seed = intervals.count_or("seed", 0);
  intervals.refuse_unknown_keys();
  return seed;
}

/// @param arm where the description has masses.
joint::StatedUncertainty read_uncertainty(const TomlTable& table,
                                          const std::optional<joint::ArmGravity>& arm) {
  joint::StatedUncertainty stated;
  const auto percent = [&](const char* key) {
    const auto value = table.find_number(key, Sign::not_negative);
    constexpr double most = 50;  // beyond it no number is known
    if (value && *value > most) {
      table.refuse(key, {"is more than half of the number", fmt::format("{}", *value),
                         fmt::format("percent, from 0 to {}", most),
                         "the half width of the interval that holds it in 95 of 100 cases"});
    }
    return value;
  };
  stated.torque_constant_percent = percent("torque_constant_percent");
  stated.gear_ratio_percent = percent("gear_ratio_percent");
  stated.surrogate_distance_percent = percent("surrogate_distance_percent");
  stated.gravity_percent = percent("gravity_percent");
  stated.angle_zero_deg = table.find_number("angle_zero_deg", Sign::not_negative);
  stated.hoses_percent = percent("hoses_percent");
  if (arm) {
    stated.description_percent = percent("description_percent");
  } else if (table.has_misplaced("description_percent")) {
    table.refuse("description_percent", {"is for a description with masses", "",
                                         "[robot] description = \"arm.urdf\"", ""});
  }
  if (const auto id = table.find_table("id")) {
    for (const char* const influence : {"torque_constant", "gear_ratio", "surrogate_distance",
                                        "gravity", "angle_zero", "hoses", "description"}) {
      const std::string text = id->text_or(influence, "");
      if (!text.empty()) stated.id[influence] = text;
    }
    id->refuse_unknown_keys();
  }
  table.refuse_unknown_keys();
  return stated;
}

joint::EffectSizes read_effects(const TomlTable& table) {
  joint::EffectSizes sizes;
  for (const joint::Effect& effect : joint::statable_effects()) {
    const std::string key = effect.stated_key();
    const auto size = table.find_number(key.c_str(), Sign::not_negative);
    if (!size) continue;
    const double most = effect.cap * effect.typical;
    if (*size > most) {
      table.refuse(key, {"is larger than on any known joint", fmt::format("{}", *size),
                         fmt::format("from 0 (it has none) to {}", most),
                         fmt::format("{} is typical", effect.typical)});
    }
    sizes.state(effect, *size);
  }
  table.refuse_unknown_keys();
  return sizes;
}

void read_circumstances(const TomlTable& top, joint::Manifest& manifest) {
  if (const auto payload = top.find_table("payload")) {
    manifest.payload_kg = payload->find_number("mass_kg", Sign::not_negative);
    manifest.payload_distance_m = payload->find_number("distance_m", Sign::positive);
    manifest.payload = payload->text_or("note", "");
    payload->refuse_unknown_keys();
  }
  if (const auto temperature = top.find_table("temperature")) {
    manifest.temperature_C = temperature->find_number("degC");
    temperature->refuse_unknown_keys();
  }
  if (const auto surrogate = top.find_table("surrogate")) {
    manifest.surrogate_distance_m =
        surrogate->number_or("distance_m", manifest.surrogate_distance_m, Sign::positive);
    manifest.gravity_m_s2 =
        surrogate->number_or("gravity_m_s2", manifest.gravity_m_s2, Sign::positive);
    surrogate->refuse_unknown_keys();
  }
  if (const auto uncertainty = top.find_table("uncertainty")) {
    manifest.uncertainty = read_uncertainty(*uncertainty, manifest.arm_gravity);
  }
  if (const auto effects = top.find_table("effects")) manifest.effects = read_effects(*effects);
  if (manifest.arm_gravity) {
    std::optional<double>& percent = manifest.uncertainty.description_percent;
    if (!percent) percent = manifest.arm_gravity->description_percent;
    manifest.arm_gravity->description_percent = *percent;
  }
  if (const auto intervals = top.find_table("intervals")) {
    manifest.seed = read_seed(*intervals);
  }
  manifest.known_loads = read_known_loads(top);
  manifest.known_gravity = read_known_gravity(top);
  manifest.limits = read_limits(top);
  manifest.certificate = read_certificate(top);
  if (const auto reference = top.find_table("reference")) {
    manifest.reference = read_known_curve(*reference);
  }
}

void refuse_missing_columns(const TomlTable& recording, joint::EffortKind kind,
                            const ColumnEntries& columns) {
  const auto need = [&](bool is_there, const char* name, const char* hint) {
    if (is_there) return;
    throw InputError(recording.where(),
                     {fmt::format("no column is stated for the {}", name), "",
                      fmt::format("{} = {{name = ..., unit = ...}} in [columns]", name), hint});
  };
  need(columns.time.has_value(), "time", "");
  need(columns.angle.has_value(), "angle", "");
  need(columns.effort.has_value() || kind == joint::EffortKind::none, "effort",
       "without torque or current nothing can be identified; where neither was recorded, "
       "effort.kind "
       "= \"none\" checks the motion alone");
}

/// Friction points have neither time nor angle: what [columns] says of those is of the recordings.
void keep_columns_of_points(const TomlTable& table, joint::EffortKind kind, RecordingEntry& entry) {
  if (kind == joint::EffortKind::none) {
    table.refuse("role", {"contradicts effort.kind", "friction points, effort of kind 'none'", "",
                          "their torque is what they are there for"});
  }
  for (const char* key : {"from_s", "to_s"}) {
    if (!table.has(key)) continue;
    table.refuse(key, {"is not for friction points", "", "", "they have no time"});
  }
  ColumnEntries& c = entry.columns;
  for (std::optional<ColumnEntry>* column : {&c.time, &c.angle, &c.bristle, &c.bristle_rate}) {
    column->reset();
  }
  const auto need = [&](const std::optional<ColumnEntry>& column, const char* name) {
    if (column) return;
    throw InputError(
        table.where(),
        {fmt::format("no column is stated for the {} of friction points", name), "",
         fmt::format("{} = {{name = ..., unit = ...}} in [recording.columns]", name), ""});
  };
  need(c.speed, "speed");
  need(c.effort, "effort");
  for (const auto* column : {&c.speed, &c.effort, &c.temperature, &c.load}) {
    if (!*column || (*column)->file.empty()) continue;
    throw InputError((*column)->where, {"stands in another file", in_quotes((*column)->file),
                                        "all columns of friction points in one", ""});
  }
}

/// "run_1.csv" and "slow/run_2.csv" of "../logs/run_1.csv" and "../logs/slow/run_2.csv".
void name_recordings(std::vector<RecordingEntry>& all) {
  if (all.empty()) return;
  const auto folder_of = [](const std::string& path) {
    return path.substr(0, path.find_last_of('/') + 1);
  };
  std::string shared = folder_of(all.front().file);
  for (const RecordingEntry& entry : all) {
    while (entry.file.compare(0, shared.size(), shared) != 0) {
      shared.pop_back();
      shared = folder_of(shared);
    }
  }
  for (RecordingEntry& entry : all) entry.name = entry.file.substr(shared.size());
}

RecordingEntry read_recording(const TomlTable& table, joint::EffortKind kind,
                              const ColumnEntries& common) {
  RecordingEntry entry;
  entry.where = table.where();
  entry.role = static_cast<joint::Role>(table.choice("role", own_names<joint::Role>.all()));
  entry.file = table.text("file", "the log, relative to the manifest");
  if (entry.file.empty()) table.refuse("file", {"is empty", "", "the log's name", ""});
  if (entry.file == "-") {
    table.refuse("file", {"standard input is not read", "'-'", "the log's name",
                          "save what comes through it as a file first"});
  }
  entry.from_s = table.find_number("from_s");
  entry.to_s = table.find_number("to_s");
  if (entry.from_s && entry.to_s && *entry.from_s >= *entry.to_s) {
    table.refuse("to_s", {"window is empty", fmt::format("{}..{} s", *entry.from_s, *entry.to_s),
                          "from_s < to_s", ""});
  }
  entry.note = table.text_or("note", "");
  entry.columns = common;
  if (const auto columns = table.find_table("columns")) {
    entry.columns = read_columns(*columns, kind, common);
  }
  if (entry.role == joint::Role::friction_points) {
    keep_columns_of_points(table, kind, entry);
  } else {
    refuse_missing_columns(table, kind, entry.columns);
    if (entry.columns.load) {
      throw InputError(entry.columns.load->where,
                       {"a load is for friction points alone", "", "",
                        "state it in the [recording.columns] of those; a load that a recording "
                        "follows is a [[known_load]]"});
    }
  }
  table.refuse_unknown_keys();
  return entry;
}

/// What a file starts with, as far as it tells whether it is a manifest.
struct FirstRow {
  std::string_view text;  ///< Empty: there is none.
  long line{};
  bool is_binary{};
  bool may_be_manifest{};  ///< It has a key or a table's name.
};

FirstRow first_row_of(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  FirstRow first;
  const log::LogFormat format = log::detect_log_format(text, "");
  first.is_binary = format != log::LogFormat::text && format != log::LogFormat::json;
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  text::RowCursor cursor(text);
  if (!cursor.next()) return first;
  first.text = text::trimmed(cursor.row());
  first.line = cursor.line();
  const bool is_of_excel = first.text.starts_with("sep=");
  const bool has_key = first.text.front() == '[' || first.text.find('=') != std::string_view::npos;
  first.may_be_manifest = !first.is_binary && !is_of_excel && has_key;
  return first;
}

/// A log, say.
void refuse_what_is_no_manifest(std::string_view text, const std::string& file) {
  const auto [row, line, is_binary, may_be_manifest] = first_row_of(text);
  if (row.empty() || may_be_manifest) return;
  constexpr std::size_t longest_shown = 60;
  throw InputError(
      {file, is_binary ? 0 : line, 0},
      {is_binary ? "is a binary log" : "is no manifest",
       is_binary ? "" : in_quotes(row.substr(0, longest_shown)), "a dataset manifest (TOML)",
       "a log is named in one: [[recording]] file = \"log.csv\"; tribolog report "
       "--help shows it"});
}

TomlNode document_in(std::string_view text, const std::string& file) {
  refuse_what_is_no_manifest(text, file);
  precheck_toml(text, file);
  return parse_toml(text, file);
}

bool is_joint_of(const TomlNode& document, const std::string& file, const std::string& joint) {
  const std::vector<std::string> names = joint_names(document, file);
  return std::find(names.begin(), names.end(), joint) != names.end();
}

/// Those that are not stated by themselves.
void add_others(std::vector<joint::OtherJoint> of_robot, std::vector<joint::OtherJoint>& stated) {
  const std::size_t by_themselves = stated.size();
  for (joint::OtherJoint& other : of_robot) {
    const auto end = stated.begin() + static_cast<std::ptrdiff_t>(by_themselves);
    const bool is_stated = std::any_of(
        stated.begin(), end, [&](const joint::OtherJoint& one) { return one.name == other.name; });
    if (!is_stated) stated.push_back(std::move(other));
  }
}

}  // namespace

std::vector<std::string> joints_in_manifest(std::string_view text, const std::string& file) {
  return joint_names(document_in(text, file), file);
}

namespace {

/// Speeds at which friction is to be stated.
std::vector<double> stated_speeds(const TomlTable& joint) {
  constexpr std::size_t most = 20;
  const char* const key = "friction_at_rad_s";
  if (!joint.has(key)) return {};
  std::vector<double> speeds = joint.numbers(key, Sign::positive);
  if (speeds.size() > most) {
    joint.refuse(key, {"has too many speeds", std::to_string(speeds.size()),
                       "at most " + std::to_string(most), ""});
  }
  std::sort(speeds.begin(), speeds.end());
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  return speeds;
}

}  // namespace

ManifestFile parse_manifest(std::string_view text, const std::string& file,
                            const std::string& of_joint) {
  TomlNode document = document_in(text, file);
  std::vector<joint::OtherJoint> others_of_robot;
  if (is_joint_of(document, file, of_joint)) {
    others_of_robot = other_joints_of(document, file, of_joint);
  }
  const TomlTable top = TomlTable::of(document_of_joint(std::move(document), file, of_joint), file);
  (void)top.choice("schema", {"tribolog-dataset-1"});
  ManifestFile result;
  read_identity(top, result.manifest);
  const TomlTable joint = top.table("joint", "[joint] with name and gear_ratio");
  result.manifest.joint = required_name(joint, "");
  const TomlTable effort = effort_of(top, joint, file);
  result.manifest.drive = read_drive(joint, effort);
  if (result.manifest.drive.kind() != joint::EffortKind::none)
    result.effort_sign = read_sign(effort);
  result.manifest.effort_is_confirmed = effort.flag_or("confirmed", true);
  result.manifest.torque_is_in_amperes = has_unknown_constant(effort);
  result.manifest.gravity_is_removed = effort.flag_or("gravity_removed", false);
  const bool has_no_gravity = joint.has("gravity") || result.manifest.gravity_is_removed;
  if (joint.has("gravity")) static_cast<void>(joint.choice("gravity", {"none"}));
  result.manifest.friction_at_rad_s = stated_speeds(joint);
  joint.refuse_unknown_keys();
  effort.refuse_unknown_keys();
  read_circumstances(top, result.manifest);
  result.manifest.other_joints = read_other_joints(top, file);
  add_others(std::move(others_of_robot), result.manifest.other_joints);
  refuse_torques_beside_amperes(effort, result.manifest);
  if (has_no_gravity) {
    if (result.manifest.known_gravity) {
      const InputError::Problem problem{"contradicts [known_gravity]", "", "",
                                        "state one of the two"};
      if (joint.has("gravity")) joint.refuse("gravity", problem);
      effort.refuse("gravity_removed", problem);
    }
    result.manifest.known_gravity = joint::StatedGravity(0, 0);
  }

  const joint::EffortKind kind = result.manifest.drive.kind();
  if (const auto log = top.find_table("log")) result.text_logs = read_text_log_rules(*log);
  ColumnEntries common;
  if (const auto columns = top.find_table("columns")) common = read_columns(*columns, kind, {});
  for (const TomlTable& recording : top.tables("recording")) {
    result.recordings.push_back(read_recording(recording, kind, common));
  }
  name_recordings(result.recordings);
  top.refuse_unknown_keys();
  const bool has_points_alone =
      std::all_of(result.recordings.begin(), result.recordings.end(),
                  [](const RecordingEntry& r) { return r.role == joint::Role::friction_points; });
  // In friction points there is no gravity left to find.
  if (has_points_alone && !result.manifest.known_gravity) {
    result.manifest.known_gravity = joint::StatedGravity(0, 0);
  }
  if (result.recordings.empty()) {
    throw InputError({file, 0, 0},
                     {"no [[recording]] is stated", "", "one or more", "each with role and file"});
  }
  return result;
}

ManifestFile read_manifest(const std::string& path, const std::string& joint) {
  return parse_manifest(read_manifest_text(path), path, joint);
}

std::string read_manifest_text(const std::string& path) {
  constexpr std::size_t looked_at_bytes = std::size_t{1} << 16;
  InputFileSource file(path);
  if (file.likely_bytes() > largest_manifest_bytes) {
    std::string start(looked_at_bytes, '\0');
    start.resize(file.read(start.data(), start.size()));
    refuse_what_is_no_manifest(start, path);
  }
  return read_file(path, largest_manifest_bytes);
}

bool is_impossible_time(const std::string& text) {
  const bool is_like_a_time = text.size() >= std::string_view("2026-01-31").size() &&
                              text.find_first_not_of("0123456789-+:.,TtZz ") == std::string::npos;
  if (!is_like_a_time) return false;
  for (const char* const rest : {"", "Z", ":00", "T00:00:00"}) {
    if (text::read_iso_time(text + rest)) return false;
  }
  return true;
}

}  // namespace tribolog::ingest::manifest
