#pragma once
// One chunk of an MCAP file, from its start in the file to its unpacked records.

#include <cstdint>
#include <string>

#include "ingest/bags/byte_reader.h"

namespace tribolog::ingest::bags {

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
