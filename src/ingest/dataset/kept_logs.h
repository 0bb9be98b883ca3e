#pragma once
// The logs that recordings are cut from: one with many recordings in it is read once.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "joint/dataset.h"
#include "joint/known_load.h"

namespace tribolog {

/// A log with the columns that a recording wants.
struct ReadLog {
  LogTable table;
  InputFile file;  ///< Name, size and fingerprint.
};

class KeptLogs {
 public:
  /// @param manifest whose recordings are read, each once and in any order.
  KeptLogs(const ManifestFile& manifest, std::filesystem::path directory);

  /// A recording's own file, or one beside it. It is kept until the last recording that names it
  /// was read.
  /// @param loads whose angles are read with it.
  /// @param notes receives what the user should know of the reading.
  /// @throw InputError as read_csv(), take_columns() and refuse_unusable_columns().
  std::shared_ptr<const ReadLog> read(const RecordingEntry& entry,
                                      const std::vector<KnownLoad>& loads,
                                      std::vector<std::string>& notes);

 private:
  struct Kept {
    std::vector<WantedColumn> columns;
    std::shared_ptr<const ReadLog> log;
  };
  std::filesystem::path directory_;
  TextLogRules rules_;
  std::map<std::string, std::size_t> still_named_;  ///< By file, by so many recordings.
  std::map<std::string, Kept> kept_;                ///< By file.
};

}  // namespace tribolog
