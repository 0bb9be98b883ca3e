#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <libdeflate.h>

#include "base/error.h"
#include "ingest/bags/chunk_unpacker.h"
#include "ingest/bags/mcap_records.h"

namespace tribolog::ingest::bags {

// The records of a compressed chunk, unpacked as its bytes come: a chunk that the file's end cuts
// gives what stands before the cut.

namespace {

/// @param compression "", "lz4" (frames) or "zstd". @param stated_bytes of the unpacked records.
/// @throw ChunkError: another compression.
std::unique_ptr<ChunkUnpacker> unpacker_of(const std::string& compression,
                                           std::uint64_t stated_bytes) {
  if (compression.empty()) return chunk_unpacker(Compression::none, stated_bytes);
  if (compression == "lz4") return chunk_unpacker(Compression::lz4, stated_bytes);
  if (compression == "zstd") return chunk_unpacker(Compression::zstd, stated_bytes);
  throw ChunkError("is compressed with '" + printable(compression) + "'");
}

constexpr std::uint32_t longest_compression_name = 64;

struct EndOfFile {};

/// The content of one record, of which no more is read than there is.
class Content {
 public:
  Content(ByteReader& source, std::uint64_t bytes) : source_(source), left_(bytes) {}

  /// @throw EndOfFile, ChunkError: the record ends first.
  void append(std::string& to, std::uint64_t bytes) {
    if (bytes > left_) throw ChunkError("it is shorter than its fields");
    left_ -= bytes;
    if (!source_.append(to, bytes)) throw EndOfFile{};
  }
  /// @throw EndOfFile.
  std::string_view next(std::uint64_t most) {
    const std::string_view bytes = source_.next(std::min(most, left_));
    if (bytes.empty() && std::min(most, left_) > 0) throw EndOfFile{};
    left_ -= bytes.size();
    return bytes;
  }
  /// @return false: the file ends first.
  bool skip_rest() {
    const std::uint64_t wanted = std::exchange(left_, 0);
    return source_.skip(wanted) == wanted;
  }
  [[nodiscard]] std::uint64_t left() const { return left_; }

 private:
  ByteReader& source_;
  std::uint64_t left_;
};

McapChunkStart take_start(Content& content, std::uint64_t largest_bytes) {
  std::string bytes;
  content.append(bytes, mcap_chunk_fixed_bytes);
  const std::uint32_t name_bytes = mcap_chunk_name_bytes(bytes);
  if (name_bytes > longest_compression_name) {
    throw ChunkError(fmt::format("its compression has a name of {} bytes", name_bytes));
  }
  content.append(bytes, name_bytes + sizeof(std::uint64_t));
  McapChunkStart start = mcap_chunk_start(bytes);
  if (start.uncompressed_bytes > largest_bytes) {
    throw ChunkError(fmt::format("it states {} bytes unpacked, more than {}",
                                 start.uncompressed_bytes, largest_bytes));
  }
  if (start.stored_bytes > content.left()) {
    throw ChunkError(fmt::format("it states {} bytes of records, where {} are left",
                                 start.stored_bytes, content.left()));
  }
  return start;
}

void check(const std::string& records, const McapChunkStart& start) {
  if (records.size() != start.uncompressed_bytes) {
    throw ChunkError(fmt::format("it unpacks to {} bytes instead of {}", records.size(),
                                 start.uncompressed_bytes));
  }
  if (start.uncompressed_crc == 0) return;
  const std::uint32_t crc = libdeflate_crc32(0, records.data(), records.size());
  if (crc != start.uncompressed_crc) {
    throw ChunkError(
        fmt::format("its CRC is {:08x} instead of {:08x}", crc, start.uncompressed_crc));
  }
}

}  // namespace

UnpackedChunk unpack_chunk(ByteReader& source, std::uint64_t content_bytes,
                           std::uint64_t largest_bytes) {
  UnpackedChunk chunk;
  Content content(source, content_bytes);
  std::unique_ptr<ChunkUnpacker> unpacker;
  try {
    const McapChunkStart start = take_start(content, largest_bytes);
    unpacker = unpacker_of(start.compression, start.uncompressed_bytes);
    for (std::uint64_t left = start.stored_bytes; left > 0;) {
      const std::string_view stored = content.next(left);
      unpacker->add(stored);
      left -= stored.size();
    }
    check(unpacker->records(), start);
  } catch (const ChunkError& error) {
    chunk.damage = error.what();
  } catch (const EndOfFile&) {
    chunk.is_cut = true;
  }
  if (!chunk.is_cut) chunk.is_cut = !content.skip_rest();
  if (unpacker && chunk.damage.empty()) chunk.records = std::move(*unpacker).records();
  return chunk;
}

}  // namespace tribolog::ingest::bags
