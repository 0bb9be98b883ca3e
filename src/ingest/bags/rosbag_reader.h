#pragma once
// Tables from a rosbag2 log in SQLite (`.db3`), as ROS 2 writes it.
//
// Types are taken from the log where it defines them (ROS 2 Iron and later), else by their names
// (ros2msg_schema.h). Nothing is written, not even a lock. Messages that stand in a
// write-ahead log beside the file (`.db3-wal`) are not read; a note says so.

#include <string>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::bags {

/// One table for each topic in CDR whose type is known; see TopicTable for its columns. Other
/// topics are named in a note.
/// @throw InputError naming the file: it is no regular file or no SQLite database, is packed
///        (`.db3.zstd`), is damaged or lacks the tables of rosbag2, or no topic can be read. A
///        topic in which a message does not agree with its type (its number and its row are
///        stated) is a table that is refused.
std::vector<log::LogTable> read_rosbag_db3(const std::string& path);

}  // namespace tribolog::ingest::bags
