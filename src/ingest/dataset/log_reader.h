#pragma once
// Logs of any format that is known, as tables, each read once.

#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/statement.h"
#include "ingest/log/log_format.h"
#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "joint/dataset.h"
#include "joint/gravity_load.h"

namespace tribolog::ingest::dataset {

/// What a log is, by its first bytes. Text is read as a stream; all else goes through
/// read_tables().
/// @throw InputError as read_file() does.
log::LogFormat format_of_log(const std::string& path);

/// All tables of a log that is no text: MCAP, rosbag (.bag), rosbag2 (.db3), MAT, HDF5, NumPy,
/// JSON, MDF 4, TDMS, Parquet.
/// @throw InputError as the format's reader does, and for text.
std::vector<log::LogTable> read_tables(const std::string& path, log::LogFormat format);

/// The one table that has all the columns, with these alone and in their order. Where several
/// tables have a column of the same name, it is named with its group:
/// "/left/joint_states/q.position".
/// @throw InputError if no table has them all (naming what is missing), several have, or the one
/// that has them is damaged.
log::LogTable take_columns(std::vector<log::LogTable> tables,
                           const std::vector<log::WantedColumn>& columns);

// The logs that recordings are cut from: one with many recordings in it is read once.

/// A log with the columns that a recording wants.
struct ReadLog {
  log::LogTable table;
  /// Angles of the robot's other joints, as far as the log has them, by the names that were wanted.
  /// Not among the table's columns: a gap in one leaves no row out.
  std::map<std::string, log::LogColumn> others{};
  /// Those of the robot's other joints that the log's own names tell, their columns among `others`.
  std::vector<joint::OtherJoint> found_others{};
  joint::InputFile file;  ///< Name, size and fingerprint.
};

class KeptLogs {
 public:
  /// @param manifest whose recordings are read, each once and in any order.
  KeptLogs(const manifest::ManifestFile& manifest, std::filesystem::path directory);

  /// A recording's own file, or one beside it. It is kept until the last recording that names it
  /// was read.
  /// @param loads whose angles are read with it.
  /// @param others columns of the robot's other joints, which the log need not have.
  /// @param notes receives what the user should know of the reading.
  /// @throw InputError as read_csv(), take_columns() and refuse_unusable_columns().
  std::shared_ptr<const ReadLog> read(const manifest::RecordingEntry& entry,
                                      const std::vector<joint::KnownLoad>& loads,
                                      std::vector<Statement>& notes,
                                      const std::vector<std::string>& others = {});

  /// Reads the logs of the recordings that come next, several at once, up to the first large one;
  /// read() then finds them read. Nothing where the first of them is known already.
  /// @param loads, others as read() will get them.
  /// @throw Nothing: read() throws what went wrong.
  void read_ahead(std::span<const manifest::RecordingEntry> coming,
                  const std::vector<joint::KnownLoad>& loads,
                  const std::vector<std::string>& others);

 private:
  struct Ahead {
    std::vector<log::WantedColumn> columns;
    std::unique_ptr<ReadLog> log{};
    std::vector<Statement> notes{};
    std::exception_ptr failure{};
  };
  struct Kept {
    std::vector<log::WantedColumn> columns;
    std::optional<double> rate_Hz;     ///< Of its clock, where the log has none of its own.
    std::string rows;                  ///< Of which joint or recording; empty: all.
    std::unique_ptr<ReadLog> whole{};  ///< With all rows, where recordings take some of them.
    std::shared_ptr<const ReadLog> log;
  };
  [[nodiscard]] std::string path_of(const manifest::RecordingEntry& entry) const;
  /// As it was read ahead, or now.
  std::unique_ptr<ReadLog> log_of(const manifest::RecordingEntry& entry,
                                  const std::vector<log::WantedColumn>& columns,
                                  const std::vector<std::string>& others,
                                  std::vector<Statement>& notes);

  std::filesystem::path directory_;
  text::TextLogRules rules_;
  /// Whether the file's recordings are told apart by what stands in their rows.
  [[nodiscard]] bool holds_several(const std::string& file) const;

  std::map<std::string, std::set<std::string>> rows_of_;  ///< By file, what the rows say.
  std::map<std::string, std::size_t> still_named_;        ///< By file, by so many recordings.
  std::map<std::string, Kept> kept_;                      ///< By file.
  std::map<std::string, Ahead> ahead_;                    ///< By file.
};

}  // namespace tribolog::ingest::dataset
