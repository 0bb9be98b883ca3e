#pragma once
// The steps of a clock as it was logged.

#include <vector>

#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"

namespace tribolog::ingest::dataset {

// Columns that stand in a file beside the recording's: some loggers write the angles into one file
// and the torques into another. The rows of such files are those of the recording's, one by one.

/// The entry with the columns of its own file alone.
manifest::RecordingEntry without_companions(const manifest::RecordingEntry& entry);

/// One for each file beside the recording's, in the order of the columns: that file and the columns
/// in it, with its time to compare.
/// @throw InputError if two columns state different names for the time of one file.
std::vector<manifest::RecordingEntry> companions_of(const manifest::RecordingEntry& entry);

/// Puts the columns of the companions into the recording's table, each where
/// logged_columns(entry.columns) has it.
/// @param table of the recording's own file.
/// @param companions the tables of companions_of(entry), one for each.
/// @throw InputError if rows cannot be matched: there are more or fewer of them, some that cannot
///        be used were left out, or times differ by more than half of the median step.
void join_companions(const manifest::RecordingEntry& entry, std::vector<log::LogTable> companions,
                     log::LogTable& table);

}  // namespace tribolog::ingest::dataset
