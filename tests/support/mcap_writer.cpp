#include "support/mcap_writer.h"

#include <array>
#include <stdexcept>
#include <utility>

#include <lz4frame.h>
#include <zstd.h>

namespace tribolog::test {
namespace {

constexpr std::string_view magic{"\x89MCAP0\r\n", 8};

std::string integer(std::uint64_t value, std::size_t bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i, value >>= 8) text += static_cast<char>(value & 0xffU);
  return text;
}

std::string text_field(std::string_view text) {
  return integer(text.size(), 4) + std::string(text);
}

std::string record(std::uint8_t opcode, std::string_view content) {
  return integer(opcode, 1) + integer(content.size(), 8) + std::string(content);
}

/// Bit by bit, the definition of CRC-32 (IEEE 802.3).
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::string compressed(const std::string& compression, const std::string& bytes) {
  if (compression.empty()) return bytes;
  const bool is_zstd = compression == "zstd";
  if (!is_zstd && compression != "lz4") return bytes;
  std::string packed(
      is_zstd ? ZSTD_compressBound(bytes.size()) : LZ4F_compressFrameBound(bytes.size(), nullptr),
      '\0');
  packed.resize(is_zstd ? ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1)
                        : LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(),
                                             bytes.size(), nullptr));
  return packed;
}

}  // namespace

McapWriter::McapWriter(McapOptions options) : options_(std::move(options)), file_(magic) {
  file_ += record(0x01, text_field("ros2") + text_field("test"));
}

void McapWriter::add(std::uint8_t opcode, std::string_view content) {
  (options_.messages_per_chunk > 0 ? chunk_ : file_) += record(opcode, content);
}

void McapWriter::add_record(std::uint8_t opcode, std::string_view content) {
  close_chunk();
  file_ += record(opcode, content);
}

void McapWriter::add_schema(std::uint16_t id, std::string_view name, std::string_view encoding,
                            std::string_view data) {
  const std::string content =
      integer(id, 2) + text_field(name) + text_field(encoding) + text_field(data);
  add(0x03, content);
  repeated_ += record(0x03, content);
}

void McapWriter::add_channel(std::uint16_t id, std::uint16_t schema, std::string_view topic,
                             std::string_view encoding) {
  const std::string content = integer(id, 2) + integer(schema, 2) + text_field(topic) +
                              text_field(encoding) + integer(0, 4);
  add(0x04, content);
  repeated_ += record(0x04, content);
}

void McapWriter::add_message(std::uint16_t channel, std::uint64_t log_time_ns,
                             std::string_view data) {
  add(0x05, integer(channel, 2) + integer(0, 4) + integer(log_time_ns, 8) +
                integer(log_time_ns, 8) + std::string(data));
  if (options_.messages_per_chunk == 0) {
    readable_from_.push_back(file_.size());
    return;
  }
  ends_in_chunk_.push_back(chunk_.size());
  if (ends_in_chunk_.size() == options_.messages_per_chunk) close_chunk();
}

void McapWriter::close_chunk() {
  if (chunk_.empty()) return;
  const std::string stored = compressed(options_.compression, chunk_);
  const std::string start = integer(0, 8) + integer(0, 8) + integer(chunk_.size(), 8) +
                            integer(options_.with_crc ? crc32(chunk_) : 0, 4) +
                            text_field(options_.compression) + integer(stored.size(), 8);
  const std::size_t records_at = file_.size() + 9 + start.size();
  file_ += record(0x06, start + stored);
  for (const std::size_t end : ends_in_chunk_) {
    readable_from_.push_back(options_.compression.empty() ? records_at + end : file_.size());
  }
  if (options_.with_summary) file_ += record(0x07, integer(1, 2) + integer(0, 4));
  chunk_.clear();
  ends_in_chunk_.clear();
}

std::string McapWriter::finish() {
  close_chunk();
  file_ += record(0x0f, integer(0, 4));
  const std::size_t summary = file_.size();
  if (options_.with_summary) file_ += repeated_;
  file_ += record(0x02, integer(options_.with_summary ? summary : 0, 8) + integer(0, 12));
  return file_ + std::string(magic);
}

}  // namespace tribolog::test
