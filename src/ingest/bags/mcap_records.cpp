#include "ingest/bags/mcap_records.h"

#include <array>

#include <fmt/format.h>

namespace tribolog::ingest::bags {
namespace {

/// Fields of a record, one after the other; integers are little-endian.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  std::string_view bytes(std::uint64_t count) {
    if (count > rest_.size()) {
      throw McapRecordError(
          fmt::format("a field of {} bytes, where {} are left", count, rest_.size()));
    }
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  template <class Integer>
  Integer integer() {
    Integer value = 0;
    const std::string_view raw = bytes(sizeof(Integer));
    for (std::size_t i = raw.size(); i-- > 0;) {
      value = static_cast<Integer>((static_cast<std::uint64_t>(value) << 8U) |
                                   static_cast<unsigned char>(raw[i]));
    }
    return value;
  }

  std::string string() { return std::string(bytes(integer<std::uint32_t>())); }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

}  // namespace

McapRecordStart mcap_record_start(std::string_view bytes) {
  Fields fields(bytes);
  const auto opcode = fields.integer<std::uint8_t>();
  return {opcode, fields.integer<std::uint64_t>()};
}

std::string mcap_record_name(std::uint8_t opcode) {
  constexpr std::array names = {"",           "header",           "footer",
                                "schema",     "channel",          "message",
                                "chunk",      "message index",    "chunk index",
                                "attachment", "attachment index", "statistics",
                                "metadata",   "metadata index",   "summary offset",
                                "data end"};
  if (opcode == 0 || opcode >= names.size()) return fmt::format("record 0x{:02x}", opcode);
  return fmt::format("{} (0x{:02x})", names.at(opcode), opcode);
}

McapSchema mcap_schema(std::string_view content) {
  Fields fields(content);
  McapSchema schema;
  schema.id = fields.integer<std::uint16_t>();
  schema.name = fields.string();
  schema.encoding = fields.string();
  schema.data = fields.string();
  return schema;
}

McapChannel mcap_channel(std::string_view content) {
  Fields fields(content);
  McapChannel channel;
  channel.id = fields.integer<std::uint16_t>();
  channel.schema = fields.integer<std::uint16_t>();
  channel.topic = fields.string();
  channel.encoding = fields.string();
  return channel;
}

McapMessage mcap_message(std::string_view content) {
  Fields fields(content);
  McapMessage message;
  message.channel = fields.integer<std::uint16_t>();
  (void)fields.integer<std::uint32_t>();  // sequence
  message.log_time_ns = fields.integer<std::uint64_t>();
  (void)fields.integer<std::uint64_t>();  // publish time
  message.data = fields.rest();
  return message;
}

std::uint32_t mcap_chunk_name_bytes(std::string_view fixed) {
  Fields fields(fixed);
  (void)fields.bytes(mcap_chunk_fixed_bytes - sizeof(std::uint32_t));
  return fields.integer<std::uint32_t>();
}

McapChunkStart mcap_chunk_start(std::string_view start) {
  Fields fields(start);
  McapChunkStart chunk;
  (void)fields.bytes(2 * sizeof(std::uint64_t));  // first and last log time
  chunk.uncompressed_bytes = fields.integer<std::uint64_t>();
  chunk.uncompressed_crc = fields.integer<std::uint32_t>();
  chunk.compression = fields.string();
  chunk.stored_bytes = fields.integer<std::uint64_t>();
  return chunk;
}

}  // namespace tribolog::ingest::bags
