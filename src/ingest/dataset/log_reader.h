#pragma once
// Logs of any format that is known, as tables.

#include <string>
#include <vector>

#include "ingest/log/log_format.h"
#include "ingest/log/log_table.h"

namespace tribolog {

/// What a log is, by its first bytes. Text is read as a stream; all else goes through
/// read_tables().
/// @throw InputError as read_file() does.
LogFormat format_of_log(const std::string& path);

/// All tables of a log that is no text: MCAP, rosbag2 (.db3), MAT, HDF5, NumPy, JSON.
/// @throw InputError as the format's reader does, and for text.
std::vector<LogTable> read_tables(const std::string& path, LogFormat format);

/// Of a clock that counts from 1970 the whole units of its first reading are taken off, as a text
/// log's are.
void count_from_first(LogColumn& clock);

/// The one table that has all the columns, with these alone and in their order. Where several
/// tables have a column of the same name, it is named with its group:
/// "/left/joint_states/q.position".
/// @throw InputError if no table has them all (naming what is missing), several have, or the one
/// that has them is damaged.
LogTable take_columns(std::vector<LogTable> tables, const std::vector<WantedColumn>& columns);

}  // namespace tribolog
