#pragma once
// The records of a compressed chunk, unpacked as its bytes come: a chunk that the file's end cuts
// gives what stands before the cut.

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace tribolog::ingest::bags {

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

enum class Compression : std::uint8_t {
  none,
  bz2,
  lz4,  ///< Frames.
  zstd
};

/// @param stated_bytes of the unpacked records.
std::unique_ptr<ChunkUnpacker> chunk_unpacker(Compression compression, std::uint64_t stated_bytes);

}  // namespace tribolog::ingest::bags
