#pragma once
// Recordings of ROS and of what speaks like it: MCAP files, bags of ROS 1 and rosbag2 databases.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::bags {

// Tables from an MCAP log (https://mcap.dev/spec), as ROS 2 and robot controllers write it.
//
// Read from start to end, chunk by chunk, without the indexes: chunked or not, with compression
// lz4, zstd or none, indexed or not. A file that is cut off gives every message that stands
// complete before the cut, also inside a compressed chunk as far as it unpacks, and a note says in
// which record and at which byte it ends. A chunk that is damaged (its CRC does not agree, or it
// does not unpack) is left out as a whole and counted in a note. Memory: the tables and one chunk.

/// Largest record, and largest unpacked chunk, that is read: 1 GiB.
inline constexpr std::uint64_t largest_mcap_record_bytes = std::uint64_t{1} << 30;

/// One table for each topic whose messages can be read: in CDR, as ROS 1 writes them, in JSON or in
/// protobuf (see reader_of() for which definitions they need); see TopicTable for its columns.
/// Other topics are named in a note.
/// @throw InputError naming file and byte: it is no regular file or no MCAP file, a record is
///        damaged, or no topic can be read. A topic in which a message does not agree with its
///        type (its number is stated) is a table that is refused.
std::vector<log::LogTable> read_mcap(const std::string& path);

/// The same from memory. @param file its name, for messages. @param largest_record_bytes see above.
std::vector<log::LogTable> read_mcap_bytes(
    std::string_view bytes, const std::string& file,
    std::uint64_t largest_record_bytes = largest_mcap_record_bytes);

// Tables from a bag of ROS 1 (http://wiki.ros.org/Bags/Format/2.0).
//
// Read from start to end, chunk by chunk, without the index: also one that was not closed
// (`.bag.active`), of which the chunk that was being written gives what stands complete. Chunks may
// be compressed with bz2 or lz4. What is cut off or damaged is noted as in an MCAP file. Memory:
// the tables and one chunk.

/// Largest record, and largest unpacked chunk, that is read: 1 GiB.
inline constexpr std::uint64_t largest_bag_record_bytes = std::uint64_t{1} << 30;

/// One table for each topic; see TopicTable for its columns. Topics that cannot be read are named
/// in a note.
/// @throw InputError naming file and byte: it is no regular file, no bag, a bag of another version
///        than 2.0 or an encrypted one, or no topic can be read. A topic in which a message does
///        not agree with its type (its number is stated) is a table that is refused.
std::vector<log::LogTable> read_rosbag(const std::string& path);

/// The same from memory. @param file its name, for messages. @param largest_record_bytes see above.
std::vector<log::LogTable> read_rosbag_bytes(
    std::string_view bytes, const std::string& file,
    std::uint64_t largest_record_bytes = largest_bag_record_bytes);

// Tables from a rosbag2 log in SQLite (`.db3`), as ROS 2 writes it.
//
// Types are taken from the log where it defines them (ROS 2 Iron and later), else by their names
// (rosmsg_schema.h). Nothing is written, not even a lock. Messages that stand in a
// write-ahead log beside the file (`.db3-wal`) are not read; a note says so.

/// One table for each topic in CDR whose type is known; see TopicTable for its columns. Other
/// topics are named in a note.
/// @throw InputError naming the file: it is no regular file or no SQLite database, is packed
///        (`.db3.zstd`), is damaged or lacks the tables of rosbag2, or no topic can be read. A
///        topic in which a message does not agree with its type (its number and its row are
///        stated) is a table that is refused.
std::vector<log::LogTable> read_rosbag_db3(const std::string& path);

}  // namespace tribolog::ingest::bags
