#include "ingest/dataset_file.h"

#include <filesystem>

#include "error.h"
#include "files/file_contents.h"
#include "files/sha256.h"
#include "ingest/closest_match.h"
#include "ingest/manifest_file.h"
#include "ingest/recording_rows.h"

namespace tribolog {
namespace {

constexpr std::uint64_t largest_manifest_bytes = 1 << 20;

InputFile fingerprint(const std::string& name, const std::string& role, std::string_view bytes) {
  InputFile input;
  input.name = name;
  input.role = role;
  input.bytes = bytes.size();
  input.sha256 = sha256_hex(bytes);
  return input;
}

void add_recording(const RecordingEntry& entry, const std::filesystem::path& directory,
                   double effort_sign, Dataset& dataset) {
  if (entry.file.find('\0') != std::string::npos) {
    throw InputError(entry.where,
                     {"NUL byte in the name of a file", in_quotes(entry.file), "", ""});
  }
  const std::string path = (directory / entry.file).string();
  const std::string bytes = read_file(path);
  const CsvTable table = read_columns_of(entry, bytes, path);
  Recording recording =
      make_recording(entry, table, dataset.manifest.drive, effort_sign, dataset.notes);
  InputFile input = fingerprint(entry.file, to_string(entry.role), bytes);
  input.rows_read = recording.rows_read;
  input.rows_used = recording.size();
  input.skipped = recording.skipped;
  dataset.inputs.push_back(std::move(input));
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
  for (const RecordingEntry& entry : manifest.recordings) {
    add_recording(entry, path.parent_path(), manifest.effort_sign, dataset);
  }
  return dataset;
}

}  // namespace tribolog
