#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <libdeflate.h>
#include <lz4frame.h>
#include <zstd.h>

#include "base/error.h"
#include "ingest/bags/mcap_records.h"

namespace tribolog::ingest::bags {

// The records of a compressed chunk, unpacked as its bytes come: a chunk that the file's end cuts
// gives what stands before the cut.

namespace {

/// The chunk cannot be unpacked; the text says why.
class ChunkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class ChunkUnpacker {
 public:
  ChunkUnpacker(const ChunkUnpacker&) = delete;
  ChunkUnpacker& operator=(const ChunkUnpacker&) = delete;
  virtual ~ChunkUnpacker() = default;

  /// The next bytes as they stand in the file.
  /// @throw ChunkError: they are damaged, or give more than was stated.
  virtual void add(std::string_view stored) = 0;
  /// What was unpacked so far. It grows as bytes come, never by what the file states.
  [[nodiscard]] const std::string& records() const& { return records_; }
  [[nodiscard]] std::string records() && { return std::move(records_); }

 protected:
  explicit ChunkUnpacker(std::uint64_t stated_bytes) : stated_bytes_(stated_bytes) {}
  void keep(std::string_view unpacked);

 private:
  std::uint64_t stated_bytes_;
  std::string records_;
};

constexpr std::size_t piece_bytes = std::size_t{1} << 17;

class StoredChunk : public ChunkUnpacker {
 public:
  explicit StoredChunk(std::uint64_t stated_bytes) : ChunkUnpacker(stated_bytes) {}
  void add(std::string_view stored) override { keep(stored); }
};

class ZstdChunk : public ChunkUnpacker {
 public:
  explicit ZstdChunk(std::uint64_t stated_bytes)
      : ChunkUnpacker(stated_bytes), stream_(ZSTD_createDStream(), &ZSTD_freeDStream) {
    if (!stream_) throw std::bad_alloc();
  }

  void add(std::string_view stored) override {
    ZSTD_inBuffer in{stored.data(), stored.size(), 0};
    for (bool is_full = false; in.pos < in.size || is_full;) {
      ZSTD_outBuffer out{piece_.data(), piece_.size(), 0};
      const std::size_t status = ZSTD_decompressStream(stream_.get(), &out, &in);
      if (ZSTD_isError(status) != 0) {
        throw ChunkError(std::string("zstd: ") + ZSTD_getErrorName(status));
      }
      keep({piece_.data(), out.pos});
      is_full = out.pos == out.size;
    }
  }

 private:
  std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream_;
  std::string piece_ = std::string(piece_bytes, '\0');
};

class Lz4Chunk : public ChunkUnpacker {
 public:
  explicit Lz4Chunk(std::uint64_t stated_bytes) : ChunkUnpacker(stated_bytes) {
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context_, LZ4F_VERSION)) != 0) {
      throw std::bad_alloc();
    }
  }
  Lz4Chunk(const Lz4Chunk&) = delete;
  Lz4Chunk& operator=(const Lz4Chunk&) = delete;
  ~Lz4Chunk() override { LZ4F_freeDecompressionContext(context_); }

  void add(std::string_view stored) override {
    for (bool is_full = false; !stored.empty() || is_full;) {
      std::size_t out_bytes = piece_.size();
      std::size_t in_bytes = stored.size();
      const std::size_t status =
          LZ4F_decompress(context_, piece_.data(), &out_bytes, stored.data(), &in_bytes, nullptr);
      if (LZ4F_isError(status) != 0) {
        throw ChunkError(std::string("lz4: ") + LZ4F_getErrorName(status));
      }
      keep({piece_.data(), out_bytes});
      stored.remove_prefix(in_bytes);
      is_full = out_bytes == piece_.size();
      if (in_bytes == 0 && out_bytes == 0 && !stored.empty()) throw ChunkError("lz4: no progress");
    }
  }

 private:
  LZ4F_dctx* context_{};
  std::string piece_ = std::string(piece_bytes, '\0');
};

void ChunkUnpacker::keep(std::string_view unpacked) {
  if (unpacked.size() > stated_bytes_ - records_.size()) {
    throw ChunkError(fmt::format("gives more than the {} bytes stated", stated_bytes_));
  }
  records_ += unpacked;
}

/// @param compression "", "lz4" (frames) or "zstd". @param stated_bytes of the unpacked records.
/// @throw ChunkError: another compression.
std::unique_ptr<ChunkUnpacker> chunk_unpacker(const std::string& compression,
                                              std::uint64_t stated_bytes) {
  if (compression.empty()) return std::make_unique<StoredChunk>(stated_bytes);
  if (compression == "lz4") return std::make_unique<Lz4Chunk>(stated_bytes);
  if (compression == "zstd") return std::make_unique<ZstdChunk>(stated_bytes);
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
    unpacker = chunk_unpacker(start.compression, start.uncompressed_bytes);
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
