#include "ingest/dataset/dataset_file.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/encodings.h"
#include "base/error.h"
#include "base/input_file.h"
#include "base/requirements.h"
#include "ingest/dataset/arm_in_motion.h"
#include "ingest/dataset/companion_columns.h"
#include "ingest/dataset/log_reader.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/layout/log_layout.h"
#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/urdf_file.h"
#include "ingest/text/csv_dialect.h"
#include "joint/degrees.h"

namespace tribolog::ingest::dataset {

// Columns of the logs that no recording uses: nothing is left out in silence.

namespace {

class UnusedColumns {
 public:
  void add(const log::LogTable& table);
  void add(const ReadLog& log);
  /// One for all logs; empty if every column is used.
  [[nodiscard]] Statement note() const;
  /// Names those that may hold the torque that no recording has; empty: there are none.
  [[nodiscard]] Statement note_of_efforts() const;

 private:
  [[nodiscard]] std::vector<std::string> unused() const;
  std::vector<std::string> names_;  ///< Of all columns, in the order in which they came.
  std::set<std::string> known_;
  std::set<std::string> used_;
};

void UnusedColumns::add(const log::LogTable& table) {
  for (const std::string& name : table.header) {
    if (!name.empty() && known_.insert(name).second) names_.push_back(name);
  }
  for (const log::LogColumn& column : table.columns) used_.insert(column.header.full);
}

void UnusedColumns::add(const ReadLog& log) {
  add(log.table);
  for (const auto& [name, column] : log.others) used_.insert(column.header.full);
}

std::vector<std::string> UnusedColumns::unused() const {
  std::vector<std::string> unused;
  for (const std::string& name : names_) {
    if (used_.count(name) == 0) unused.push_back(name);
  }
  return unused;
}

Statement UnusedColumns::note() const {
  const std::vector<std::string> names = unused();
  if (names.empty()) return {};
  return {"reading.column_not_used", {{"columns", list_of_names(names)}}};
}

Statement UnusedColumns::note_of_efforts() const {
  constexpr std::size_t most_listed = 6;
  std::vector<log::ColumnHeader> header;
  for (const std::string& name : unused()) header.push_back(text::read_header_field(name));
  const std::vector<std::string> efforts = layout::possible_efforts(header);
  if (efforts.empty()) return {};
  return {"reading.effort_not_read", {{"columns", list_of_names(efforts, most_listed)}}};
}

constexpr double noticeable_rad = 1e-3;  // of an angle beyond a limit that is given in degrees

joint::InputFile fingerprint(const std::string& name, const std::string& role,
                             std::string_view bytes) {
  joint::InputFile input;
  input.name = name;
  input.role = role;
  input.bytes = bytes.size();
  input.sha256 = sha256_hex(bytes);
  return input;
}

/// The description, its fingerprint, and a note where it is of another joint.
void add_robot(const std::filesystem::path& directory, joint::Dataset& dataset) {
  const std::string& file = dataset.manifest.robot_description;
  const std::string path = (directory / file).string();
  const std::string text = read_file(path, manifest::largest_robot_bytes);
  dataset.robot =
      std::make_shared<const robot::RobotDescription>(manifest::parse_robot(text, path));
  dataset.inputs.push_back(fingerprint(file, "robot", text));
  const std::string& tested = dataset.robot->under_test.joint().name;
  if (tested == dataset.manifest.joint) return;
  dataset.notes.push_back({"reading.robot_of_other_joint",
                           {{"file", printable(file)},
                            {"described", in_quotes(tested)},
                            {"stated", in_quotes(dataset.manifest.joint)}}});
}

/// The description with masses, its fingerprint, and which of its joints is which.
/// @param joints of a robot's manifest; empty: it is a single joint's.
void add_arm(const std::filesystem::path& directory, const std::vector<std::string>& joints,
             ArmInMotion& arm, joint::Dataset& dataset) {
  if (!dataset.manifest.arm_gravity) return;
  const std::string& file = dataset.manifest.arm_gravity->description;
  const std::string path = (directory / file).string();
  const std::string text = read_file(path, manifest::largest_urdf_bytes);
  arm.describe(text, path, joints);
  dataset.inputs.push_back(fingerprint(file, "robot", text));
}

/// A note where a log's angles leave the described range of motion: it counts otherwise, or the
/// description is wrong.
void compare_angles(joint::Dataset& dataset) {
  const robot::ArmJoint& joint = dataset.robot->under_test.joint();
  double lowest_rad = joint.lowest_rad;
  double highest_rad = joint.highest_rad;
  for (const joint::Recording& recording : dataset.recordings) {
    for (const double q_rad : recording.q_rad) {
      lowest_rad = std::min(lowest_rad, q_rad);
      highest_rad = std::max(highest_rad, q_rad);
    }
  }
  const double beyond_rad =
      std::max(joint.lowest_rad - lowest_rad, highest_rad - joint.highest_rad);
  if (beyond_rad <= noticeable_rad) return;
  const double reached_rad = lowest_rad < joint.lowest_rad ? lowest_rad : highest_rad;
  dataset.notes.push_back({"reading.outside_range_of_motion",
                           {{"angle_deg", joint::degrees_per_rad * reached_rad},
                            {"joint", in_quotes(joint.name)},
                            {"file", printable(dataset.manifest.robot_description)},
                            {"lowest_deg", joint::degrees_per_rad * joint.lowest_rad},
                            {"highest_deg", joint::degrees_per_rad * joint.highest_rad}}});
}

/// What became of the rows, which a recording's files share.
/// @tparam Rows joint::Recording or joint::FrictionPoints
template <class Rows>
void count_rows(const Rows& read, joint::InputFile& input) {
  input.rows_read = read.rows_read;
  input.rows_used = read.rows_read;
  for (const joint::SkippedRows& skipped : read.skipped) input.rows_used -= skipped.count;
  input.skipped = read.skipped;
}

/// The table with the columns of its companions, in the order of logged_columns().
log::LogTable joined(const manifest::RecordingEntry& entry, const log::LogTable& own,
                     const std::vector<std::shared_ptr<const ReadLog>>& companions) {
  std::vector<log::LogTable> tables;
  for (const auto& companion : companions) tables.push_back(companion->table);
  log::LogTable table = own;
  join_companions(entry, std::move(tables), table);
  return table;
}

/// Each, also where two recordings have the same one.
void add_note(const manifest::RecordingEntry& entry, joint::Dataset& dataset) {
  if (entry.note.empty()) return;
  const Statement note = Statement::verbatim(entry.note);
  dataset.notes.push_back({"reading.of_file", {{"file", printable(entry.name)}, {"note", note}}});
}

/// An unknown torque constant is none that was multiplied with.
std::vector<joint::ColumnConversion> conversions_by(const manifest::ManifestFile& manifest,
                                                    const manifest::RecordingEntry& entry) {
  std::vector<joint::ColumnConversion> all =
      conversions_of(entry.columns, manifest.manifest.drive, manifest.effort_sign);
  if (!manifest.manifest.torque_is_in_amperes) return all;
  for (joint::ColumnConversion& one : all) {
    std::erase_if(one.steps, [](const joint::ConversionStep& step) {
      return step.reason == joint::ConversionStep::Reason::torque_constant;
    });
  }
  return all;
}

void add_points(const manifest::RecordingEntry& entry, const manifest::ManifestFile& manifest,
                KeptLogs& logs, joint::Dataset& dataset, UnusedColumns& unused) {
  const auto log = logs.read(entry, {}, dataset.notes);
  unused.add(log->table);
  std::optional<log::LogTable> mended;
  if (manifest.text_logs.skip_bad_rows) mended = without_impossible_values(entry, log->table);
  joint::FrictionPoints points =
      make_friction_points(entry, mended ? *mended : log->table, dataset.manifest.drive,
                           manifest.effort_sign, dataset.notes);
  joint::InputFile input = log->file;
  input.role = joint::to_string(entry.role);
  count_rows(points, input);
  input.conversions = conversions_by(manifest, entry);
  dataset.inputs.push_back(std::move(input));
  add_note(entry, dataset);
  dataset.friction_points.push_back(std::move(points));
}

void add_recording(const manifest::RecordingEntry& entry, const manifest::ManifestFile& manifest,
                   KeptLogs& logs, joint::Dataset& dataset, UnusedColumns& unused,
                   ArmInMotion& arm) {
  std::vector<joint::KnownLoad>& loads = dataset.manifest.known_loads;
  const auto own = logs.read(without_companions(entry), loads, dataset.notes, arm.columns());
  unused.add(*own);
  std::vector<std::shared_ptr<const ReadLog>> companions;
  for (const manifest::RecordingEntry& beside : companions_of(entry)) {
    companions.push_back(logs.read(beside, {}, dataset.notes));
    RecordingNotes notes(beside.file, dataset.notes);
    note_reading(companions.back()->table, notes);
    unused.add(companions.back()->table);
  }
  log::LogTable with_companions;
  if (!companions.empty()) with_companions = joined(entry, own->table, companions);
  const log::LogTable& as_read = companions.empty() ? own->table : with_companions;
  std::optional<log::LogTable> mended;
  if (manifest.text_logs.skip_bad_rows) mended = without_impossible_values(entry, as_read);
  std::vector<std::size_t> rows;
  joint::Recording recording =
      make_recording(entry, mended ? *mended : as_read, dataset.manifest.drive,
                     manifest.effort_sign, dataset.notes, &loads, &rows);
  arm.keep(*own, rows);
  joint::InputFile input = own->file;
  input.role = joint::to_string(entry.role);
  count_rows(recording, input);
  input.conversions = conversions_by(manifest, entry);
  if (entry.columns.effort) {
    input.logged_effort =
        layout::known_effort(present(entry.columns.angle).name, entry.columns.effort->name);
  }
  dataset.inputs.push_back(std::move(input));
  for (const auto& companion : companions) {
    joint::InputFile beside = companion->file;
    beside.role = joint::to_string(entry.role);
    count_rows(recording, beside);
    dataset.inputs.push_back(std::move(beside));
  }
  add_note(entry, dataset);
  dataset.recordings.push_back(std::move(recording));
}

}  // namespace

std::vector<std::string> joints_of_robot(const std::string& manifest_path) {
  return manifest::joints_in_manifest(manifest::read_manifest_text(manifest_path), manifest_path);
}

joint::Dataset read_dataset(const std::string& manifest_path, const std::string& joint) {
  const std::string text = manifest::read_manifest_text(manifest_path);
  manifest::ManifestFile manifest = manifest::parse_manifest(text, manifest_path, joint);
  const std::filesystem::path path(manifest_path);
  joint::Dataset dataset;
  dataset.manifest = std::move(manifest.manifest);
  // Joints of a robot share their files: by this they are different calibrations.
  const std::string role = joint.empty() ? "manifest" : "manifest of joint " + joint;
  dataset.inputs.push_back(fingerprint(path.filename().string(), role, text));
  const std::filesystem::path directory = path.parent_path();
  if (!dataset.manifest.robot_description.empty()) add_robot(directory, dataset);
  ArmInMotion arm(dataset.manifest);
  add_arm(directory, manifest::joints_in_manifest(text, manifest_path), arm, dataset);
  UnusedColumns unused;
  KeptLogs logs(manifest, directory);
  std::span<const manifest::RecordingEntry> coming = manifest.recordings;
  for (; !coming.empty(); coming = coming.subspan(1)) {
    const manifest::RecordingEntry& entry = coming.front();
    logs.read_ahead(coming, dataset.manifest.known_loads, arm.columns());
    if (entry.role == joint::Role::friction_points) {
      add_points(entry, manifest, logs, dataset, unused);
    } else {
      add_recording(entry, manifest, logs, dataset, unused, arm);
    }
  }
  arm.take_gravity_off(dataset);
  // Those of a robot are its other joints'.
  const bool is_of_robot = !joint.empty();
  if (const Statement note = unused.note(); !note.empty() && !is_of_robot) {
    dataset.notes.push_back(note);
  }
  if (dataset.manifest.drive.kind() == joint::EffortKind::none && !is_of_robot) {
    if (const Statement note = unused.note_of_efforts(); !note.empty()) {
      dataset.notes.push_back(note);
    }
  }
  if (dataset.robot) compare_angles(dataset);
  return dataset;
}

}  // namespace tribolog::ingest::dataset
