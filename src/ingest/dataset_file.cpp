#include "ingest/dataset_file.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "error.h"
#include "files/byte_source.h"
#include "files/file_contents.h"
#include "files/sha256.h"
#include "ingest/closest_match.h"
#include "ingest/column_conversions.h"
#include "ingest/companion_columns.h"
#include "ingest/layout/known_effort.h"
#include "ingest/log_reader.h"
#include "ingest/manifest/manifest_file.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/recording_rows.h"
#include "ingest/row_choice.h"
#include "ingest/unused_columns.h"
#include "joint/degrees.h"

namespace tribolog {
namespace {

constexpr double noticeable_rad = 1e-3;  // of an angle beyond a limit that is given in degrees

InputFile fingerprint(const std::string& name, const std::string& role, std::string_view bytes) {
  InputFile input;
  input.name = name;
  input.role = role;
  input.bytes = bytes.size();
  input.sha256 = sha256_hex(bytes);
  return input;
}

/// The description, its fingerprint, and a note where it is of another joint.
void add_robot(const std::filesystem::path& directory, Dataset& dataset) {
  const std::string& file = dataset.manifest.robot_description;
  const std::string path = (directory / file).string();
  const std::string text = read_file(path, largest_robot_bytes);
  dataset.robot = std::make_shared<const RobotDescription>(parse_robot(text, path));
  dataset.inputs.push_back(fingerprint(file, "robot", text));
  const std::string& tested = dataset.robot->under_test.joint().name;
  if (tested == dataset.manifest.joint) return;
  dataset.notes.push_back(fmt::format(
      "{} describes the test of joint {}, the manifest is of joint {}: the drawings of the robot "
      "show the former",
      printable(file), in_quotes(tested), in_quotes(dataset.manifest.joint)));
}

/// A note where a log's angles leave the described range of motion: it counts otherwise, or the
/// description is wrong.
void compare_angles(Dataset& dataset) {
  const ArmJoint& joint = dataset.robot->under_test.joint();
  double lowest_rad = joint.lowest_rad;
  double highest_rad = joint.highest_rad;
  for (const Recording& recording : dataset.recordings) {
    for (const double q_rad : recording.q_rad) {
      lowest_rad = std::min(lowest_rad, q_rad);
      highest_rad = std::max(highest_rad, q_rad);
    }
  }
  const double beyond_rad =
      std::max(joint.lowest_rad - lowest_rad, highest_rad - joint.highest_rad);
  if (beyond_rad <= noticeable_rad) return;
  dataset.notes.push_back(fmt::format(
      "the logs reach {:.4g}°, outside the range of motion of joint {} in {}, {:.4g}° to {:.4g}°: "
      "do both count the angle from the same zero and with the same sign?",
      degrees_per_rad * (lowest_rad < joint.lowest_rad ? lowest_rad : highest_rad),
      in_quotes(joint.name), printable(dataset.manifest.robot_description),
      degrees_per_rad * joint.lowest_rad, degrees_per_rad * joint.highest_rad));
}

/// For the fingerprint: other readers open the file themselves.
void read_to_the_end(ByteSource& bytes) {
  constexpr std::size_t at_a_time = std::size_t{1} << 20;
  std::string buffer(at_a_time, '\0');
  while (bytes.read(buffer.data(), buffer.size()) > 0) {
  }
}

struct ReadLog {
  LogTable table;
  InputFile input;
};

/// A recording's own file, or one beside it.
ReadLog read_log(const RecordingEntry& entry, const std::filesystem::path& directory,
                 const std::vector<KnownLoad>& loads, const TextLogRules& rules,
                 std::vector<std::string>& notes) {
  if (entry.file.find('\0') != std::string::npos) {
    throw InputError(entry.where,
                     {"NUL byte in the name of a file", in_quotes(entry.file), "", ""});
  }
  const std::string path = (directory / entry.file).string();
  InputFileSource log(path);
  FingerprintedSource bytes(log);
  const LogFormat format = format_of_log(path);
  ReadLog read;
  read.table = format == LogFormat::text
                   ? read_columns_of(entry, bytes, path, loads, rules)
                   : choose_columns_of(entry, read_tables(path, format), path, loads);
  read_to_the_end(bytes);
  if (log.has_grown()) {
    notes.push_back(printable(entry.file) +
                    ": the log is still being written; what came after the start of reading "
                    "is not in");
  }
  read.input.name = entry.file;
  read.input.role = to_string(entry.role);
  read.input.bytes = log.bytes_read();
  read.input.sha256 = bytes.sha256();
  return read;
}

/// What became of the rows, which a recording's files share.
void count_rows(const Recording& recording, InputFile& input) {
  input.rows_read = recording.rows_read;
  input.rows_used = recording.size();
  input.skipped = recording.skipped;
}

void add_recording(const RecordingEntry& entry, const std::filesystem::path& directory,
                   const ManifestFile& manifest, Dataset& dataset, UnusedColumns& unused) {
  std::vector<KnownLoad>& loads = dataset.manifest.known_loads;
  const RecordingEntry own = without_companions(entry);
  auto [table, input] = read_log(own, directory, loads, manifest.text_logs, dataset.notes);
  unused.add(table);
  std::vector<LogTable> tables;
  std::vector<InputFile> companions;
  for (const RecordingEntry& companion : companions_of(entry)) {
    ReadLog read = read_log(companion, directory, {}, manifest.text_logs, dataset.notes);
    RecordingNotes notes(companion.file, dataset.notes);
    note_reading(read.table, notes);
    unused.add(read.table);
    tables.push_back(std::move(read.table));
    companions.push_back(std::move(read.input));
  }
  join_companions(entry, std::move(tables), table);
  Recording recording = make_recording(entry, table, dataset.manifest.drive, manifest.effort_sign,
                                       dataset.notes, &loads);
  count_rows(recording, input);
  input.conversions = conversions_of(entry.columns, dataset.manifest.drive, manifest.effort_sign);
  if (entry.columns.effort) {
    input.logged_effort = known_effort(entry.columns.angle->name, entry.columns.effort->name);
  }
  dataset.inputs.push_back(std::move(input));
  for (InputFile& companion : companions) {
    count_rows(recording, companion);
    dataset.inputs.push_back(std::move(companion));
  }
  if (!entry.note.empty()) dataset.notes.push_back(printable(entry.file) + ": " + entry.note);
  dataset.recordings.push_back(std::move(recording));
}

}  // namespace

Dataset read_dataset(const std::string& manifest_path) {
  const std::string text = read_file(manifest_path, largest_manifest_bytes);
  ManifestFile manifest = parse_manifest(text, manifest_path);
  const std::filesystem::path path(manifest_path);
  Dataset dataset;
  dataset.manifest = std::move(manifest.manifest);
  dataset.inputs.push_back(fingerprint(path.filename().string(), "manifest", text));
  const std::filesystem::path directory = path.parent_path();
  if (!dataset.manifest.robot_description.empty()) add_robot(directory, dataset);
  UnusedColumns unused;
  for (const RecordingEntry& entry : manifest.recordings) {
    add_recording(entry, directory, manifest, dataset, unused);
  }
  if (const std::string note = unused.note(); !note.empty()) dataset.notes.push_back(note);
  if (dataset.robot) compare_angles(dataset);
  return dataset;
}

}  // namespace tribolog
