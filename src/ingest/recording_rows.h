#pragma once
// A log's columns to a recording: SI, joint-side angle, motor-side torque, time strictly rising.

#include <string>
#include <vector>

#include "files/byte_source.h"
#include "ingest/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "ingest/row_choice.h"
#include "joint/recording.h"

namespace tribolog {

/// Reads the columns that the entry names.
/// @param path of the log, for messages.
/// @param loads the angles of those that load the recording are read behind the others.
/// @param rules of text logs, as the manifest states them.
/// @throw InputError for whatever read_csv refuses, a column that is nothing but gaps, and a unit
/// in
///        the log's header that contradicts the manifest.
LogTable read_columns_of(const RecordingEntry& entry, ByteSource& bytes, const std::string& path,
                         const std::vector<KnownLoad>& loads = {}, const TextLogRules& rules = {});

/// The same of a log that is no text, from its tables.
/// @throw InputError as take_columns(), and as above.
LogTable choose_columns_of(const RecordingEntry& entry, std::vector<LogTable> tables,
                           const std::string& path, const std::vector<KnownLoad>& loads = {});

/// What was peculiar when the table was read, and which of its columns have many gaps.
void note_reading(const LogTable& table, RecordingNotes& notes);

/// Rows outside the window, with a gap, or with a time stamp that stood before are left out and
/// counted in `skipped`. Time running back by up to a second is put in order.
/// @param notes receives what the user should know.
/// @param loads those that load the recording are subtracted from its torque and count it.
/// @throw InputError if time runs back further, more than 5 % of the time stamps stand twice, or
///        fewer than 20 rows are left.
Recording make_recording(const RecordingEntry& entry, const LogTable& table, const Drive& drive,
                         double effort_sign, std::vector<std::string>& notes,
                         std::vector<KnownLoad>* loads = nullptr);

}  // namespace tribolog
