#include "ingest/bags/chunk_unpacker.h"

#include <cstddef>
#include <new>

#include <bzlib.h>
#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

namespace tribolog::ingest::bags {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 17;

class StoredChunk : public ChunkUnpacker {
 public:
  explicit StoredChunk(std::uint64_t stated_bytes) : ChunkUnpacker(stated_bytes) {}
  void add(std::string_view stored) override { keep(stored); }
};

class Bz2Chunk : public ChunkUnpacker {
 public:
  explicit Bz2Chunk(std::uint64_t stated_bytes) : ChunkUnpacker(stated_bytes) {
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  Bz2Chunk(const Bz2Chunk&) = delete;
  Bz2Chunk& operator=(const Bz2Chunk&) = delete;
  ~Bz2Chunk() override { BZ2_bzDecompressEnd(&stream_); }

  void add(std::string_view stored) override {
    stream_.next_in = const_cast<char*>(stored.data());  // which it only reads
    stream_.avail_in = static_cast<unsigned>(stored.size());
    for (bool is_full = false; stream_.avail_in > 0 || is_full;) {
      if (is_at_end_) throw ChunkError("bz2: bytes follow its end");
      stream_.next_out = piece_.data();
      stream_.avail_out = static_cast<unsigned>(piece_.size());
      const int status = BZ2_bzDecompress(&stream_);
      if (status != BZ_OK && status != BZ_STREAM_END) {
        throw ChunkError(fmt::format("bz2: error {}", status));
      }
      keep({piece_.data(), piece_.size() - stream_.avail_out});
      is_at_end_ = status == BZ_STREAM_END;
      is_full = stream_.avail_out == 0 && !is_at_end_;
    }
  }

 private:
  bz_stream stream_{};
  bool is_at_end_{false};
  std::string piece_ = std::string(piece_bytes, '\0');
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

std::unique_ptr<ChunkUnpacker> chunk_unpacker(Compression compression, std::uint64_t stated_bytes) {
  switch (compression) {
    case Compression::none:
      break;
    case Compression::bz2:
      return std::make_unique<Bz2Chunk>(stated_bytes);
    case Compression::lz4:
      return std::make_unique<Lz4Chunk>(stated_bytes);
    case Compression::zstd:
      return std::make_unique<ZstdChunk>(stated_bytes);
  }
  return std::make_unique<StoredChunk>(stated_bytes);
}

}  // namespace tribolog::ingest::bags
