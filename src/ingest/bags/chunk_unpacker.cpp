#include "ingest/bags/chunk_unpacker.h"

#include <new>

#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include "base/error.h"

namespace tribolog {
namespace {

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

}  // namespace

void ChunkUnpacker::keep(std::string_view unpacked) {
  if (unpacked.size() > stated_bytes_ - records_.size()) {
    throw ChunkError(fmt::format("gives more than the {} bytes stated", stated_bytes_));
  }
  records_ += unpacked;
}

std::unique_ptr<ChunkUnpacker> chunk_unpacker(const std::string& compression,
                                              std::uint64_t stated_bytes) {
  if (compression.empty()) return std::make_unique<StoredChunk>(stated_bytes);
  if (compression == "lz4") return std::make_unique<Lz4Chunk>(stated_bytes);
  if (compression == "zstd") return std::make_unique<ZstdChunk>(stated_bytes);
  throw ChunkError("is compressed with '" + printable(compression) + "'");
}

}  // namespace tribolog
