#pragma once
// Tables from an MCAP log (https://mcap.dev/spec), as ROS 2 and robot controllers write it.
//
// Read from start to end, chunk by chunk, without the indexes: chunked or not, with compression
// lz4, zstd or none, indexed or not. A file that is cut off gives every message that stands
// complete before the cut, also inside a compressed chunk as far as it unpacks, and a note says in
// which record and at which byte it ends. A chunk that is damaged (its CRC does not agree, or it
// does not unpack) is left out as a whole and counted in a note. Memory: the tables and one chunk.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::ingest::bags {

/// Largest record, and largest unpacked chunk, that is read: 1 GiB.
inline constexpr std::uint64_t largest_mcap_record_bytes = std::uint64_t{1} << 30;

/// One table for each topic whose messages are in CDR with a definition in ros2msg (or of a type
/// that is known without one); see TopicTable for its columns. Other topics are named in a note.
/// @throw InputError naming file and byte: it is no regular file or no MCAP file, a record is
///        damaged, or no topic can be read. A topic in which a message does not agree with its
///        type (its number is stated) is a table that is refused.
std::vector<log::LogTable> read_mcap(const std::string& path);

/// The same from memory. @param file its name, for messages. @param largest_record_bytes see above.
std::vector<log::LogTable> read_mcap_bytes(
    std::string_view bytes, const std::string& file,
    std::uint64_t largest_record_bytes = largest_mcap_record_bytes);

}  // namespace tribolog::ingest::bags
