#include "ingest/dataset/kept_logs.h"

#include <utility>

#include "base/byte_source.h"
#include "base/closest_match.h"
#include "base/error.h"
#include "base/file_contents.h"
#include "ingest/dataset/companion_columns.h"
#include "ingest/dataset/log_reader.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/text/csv_reader.h"

namespace tribolog {
namespace {

/// For the fingerprint: other readers open the file themselves.
void read_to_the_end(ByteSource& bytes) {
  constexpr std::size_t at_a_time = std::size_t{1} << 20;
  std::string buffer(at_a_time, '\0');
  while (bytes.read(buffer.data(), buffer.size()) > 0) {
  }
}

ReadLog read_log(const RecordingEntry& entry, const std::string& path,
                 const std::vector<WantedColumn>& columns, const TextLogRules& rules,
                 std::vector<std::string>& notes) {
  InputFileSource log(path);
  FingerprintedSource bytes(log);
  const LogFormat format = format_of_log(path);
  ReadLog read;
  read.table = format == LogFormat::text ? read_csv(bytes, path, columns, rules)
                                         : take_columns(read_tables(path, format), columns);
  read_to_the_end(bytes);
  if (log.has_grown()) {
    notes.push_back(printable(entry.file) +
                    ": the log is still being written; what came after the start of reading "
                    "is not in");
  }
  read.file.name = entry.file;
  read.file.bytes = log.bytes_read();
  read.file.sha256 = bytes.sha256();
  return read;
}

}  // namespace

KeptLogs::KeptLogs(const ManifestFile& manifest, std::filesystem::path directory)
    : directory_(std::move(directory)), rules_(manifest.text_logs) {
  for (const RecordingEntry& entry : manifest.recordings) {
    ++still_named_[entry.file];
    for (const RecordingEntry& companion : companions_of(entry)) ++still_named_[companion.file];
  }
}

std::shared_ptr<const ReadLog> KeptLogs::read(const RecordingEntry& entry,
                                              const std::vector<KnownLoad>& loads,
                                              std::vector<std::string>& notes) {
  if (entry.file.find('\0') != std::string::npos) {
    throw InputError(entry.where,
                     {"NUL byte in the name of a file", in_quotes(entry.file), "", ""});
  }
  const std::string path = (directory_ / entry.file).string();
  std::vector<WantedColumn> columns = columns_wanted(entry, loads);
  Kept& kept = kept_[entry.file];
  if (!kept.log || kept.columns != columns) {
    kept.log.reset();
    kept.log = std::make_shared<const ReadLog>(read_log(entry, path, columns, rules_, notes));
    kept.columns = std::move(columns);
  }
  const std::shared_ptr<const ReadLog> log = kept.log;
  if (--still_named_.at(entry.file) == 0) kept_.erase(entry.file);
  refuse_unusable_columns(entry, loads, path, log->table);
  return log;
}

}  // namespace tribolog
