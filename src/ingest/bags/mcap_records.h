#pragma once
// The records of an MCAP file (https://mcap.dev/spec): what stands in each that is read.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "ingest/bags/byte_reader.h"

namespace tribolog::ingest::bags {

inline constexpr std::string_view mcap_magic{"\x89MCAP0\r\n", 8};

enum class McapOpcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  data_end = 0x0f,
};

/// Every record starts with its opcode and the length of what follows.
inline constexpr std::size_t mcap_record_start_bytes = 9;

struct McapRecordStart {
  std::uint8_t opcode{};
  std::uint64_t content_bytes{};
};

/// @param bytes the nine that a record starts with.
McapRecordStart mcap_record_start(std::string_view bytes);

/// "chunk (0x06)"; "record 0x83" where the format has no name for it.
std::string mcap_record_name(std::uint8_t opcode);

/// A record's content ends before its fields do.
class McapRecordError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct McapSchema {
  std::uint16_t id{};
  std::string name;
  std::string encoding;
  std::string data;
};

struct McapChannel {
  std::uint16_t id{};
  std::uint16_t schema{};  ///< 0: it has none.
  std::string topic;
  std::string encoding;  ///< Of its messages.
};

/// Refers to the bytes that it was read from.
struct McapMessage {
  std::uint16_t channel{};
  std::uint64_t log_time_ns{};
  std::string_view data;
};

/// What stands before a chunk's records.
struct McapChunkStart {
  std::uint64_t uncompressed_bytes{};
  std::uint32_t uncompressed_crc{};  ///< 0: not known.
  std::string compression;
  std::uint64_t stored_bytes{};  ///< Of the records as they stand in the file.
};

/// @throw McapRecordError, all of them.
McapSchema mcap_schema(std::string_view content);
McapChannel mcap_channel(std::string_view content);
McapMessage mcap_message(std::string_view content);

/// A chunk's start up to the length of its compression's name; the name and eight bytes follow.
inline constexpr std::size_t mcap_chunk_fixed_bytes = 32;
/// @param fixed these bytes. @return the length of the name.
std::uint32_t mcap_chunk_name_bytes(std::string_view fixed);
/// @param start all bytes before the records.
McapChunkStart mcap_chunk_start(std::string_view start);

// One chunk of an MCAP file, from its start in the file to its unpacked records.

struct UnpackedChunk {
  std::string records;  ///< Where is_cut: those that could be unpacked, the last one in part.
  bool is_cut{};        ///< The file ends inside the chunk.
  std::string damage;   ///< Why the chunk is not to be trusted; empty: nothing against it.
};

/// Reads the content of a chunk record to its end, whatever stands in it.
/// @param source stands after the record's start. @param content_bytes as the record states.
/// @param largest_bytes of the unpacked records.
UnpackedChunk unpack_chunk(ByteReader& source, std::uint64_t content_bytes,
                           std::uint64_t largest_bytes);

}  // namespace tribolog::ingest::bags
