#pragma once
// MCAP files, written for tests, that tell where each message ends in them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::test {

struct McapOptions {
  std::size_t messages_per_chunk{0};  ///< 0: no chunks.
  std::string compression{};          ///< "", "lz4" or "zstd".
  bool with_crc{true};
  bool with_summary{true};  ///< And a message index after each chunk.
};

class McapWriter {
 public:
  explicit McapWriter(McapOptions options);

  void add_schema(std::uint16_t id, std::string_view name, std::string_view encoding,
                  std::string_view data);
  void add_channel(std::uint16_t id, std::uint16_t schema, std::string_view topic,
                   std::string_view encoding = "cdr");
  void add_message(std::uint16_t channel, std::uint64_t log_time_ns, std::string_view data);
  /// Any record, outside of chunks.
  void add_record(std::uint8_t opcode, std::string_view content);
  /// The whole file.
  [[nodiscard]] std::string finish();

  /// First bytes of the file after which a message, in the order of writing, can be read: its own
  /// end, or that of its chunk where that is compressed.
  [[nodiscard]] const std::vector<std::size_t>& readable_from() const { return readable_from_; }

 private:
  void add(std::uint8_t opcode, std::string_view content);
  void close_chunk();

  McapOptions options_;
  std::string file_;
  std::string chunk_;
  std::string repeated_;  ///< Schemas and channels once more, for the summary.
  std::vector<std::size_t> ends_in_chunk_;
  std::vector<std::size_t> readable_from_;
};

}  // namespace tribolog::test
