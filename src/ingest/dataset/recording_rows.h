#pragma once
// A log's columns to a recording: SI, joint-side angle, motor-side torque, time strictly rising.

#include <string>
#include <vector>

#include "base/input_file.h"
#include "base/statement.h"
#include "ingest/dataset/row_choice.h"
#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "joint/recording.h"

namespace tribolog::ingest::dataset {

/// The columns that the entry names, in the order of logged_columns(); behind them the time to
/// compare and the angles of the loads that load the recording.
std::vector<log::WantedColumn> columns_wanted(const manifest::RecordingEntry& entry,
                                              const std::vector<joint::KnownLoad>& loads = {});

/// @param table with the columns wanted.
/// @param path of the log, for messages.
/// @throw InputError for a column that is nothing but gaps, and a unit in the log's header that
///        contradicts the manifest.
void refuse_unusable_columns(const manifest::RecordingEntry& entry,
                             const std::vector<joint::KnownLoad>& loads, const std::string& path,
                             const log::LogTable& table);

/// What was peculiar when the table was read, and which of its columns have many gaps.
void note_reading(const log::LogTable& table, RecordingNotes& notes);

/// Rows outside the window, with a gap, or with a time stamp that stood before are left out and
/// counted in `skipped`. Time running back by up to a second is put in order.
/// @param notes receives what the user should know.
/// @param loads those that load the recording are subtracted from its torque and count it.
/// @throw InputError if time runs back further, more than 5 % of the time stamps stand twice, or
///        fewer than 20 rows are left.
joint::Recording make_recording(const manifest::RecordingEntry& entry, const log::LogTable& table,
                                const joint::Drive& drive, double effort_sign,
                                std::vector<Statement>& notes,
                                std::vector<joint::KnownLoad>* loads = nullptr);

}  // namespace tribolog::ingest::dataset
