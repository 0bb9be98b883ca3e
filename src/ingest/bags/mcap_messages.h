#pragma once
// From records to tables: which channel a message belongs to, and what its topic holds.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/bags/mcap_records.h"
#include "ingest/bags/topic_tables.h"

namespace tribolog {

/// Where a record starts.
struct McapPlace {
  std::uint64_t byte{};                ///< Of the file, or of the unpacked chunk.
  std::optional<std::uint64_t> chunk;  ///< Where that stands in the file.
  [[nodiscard]] std::string text() const;
};

class McapMessages {
 public:
  explicit McapMessages(const std::string& file) : tables_(file) {}

  /// Schema, channel or message.
  [[nodiscard]] static bool takes(std::uint8_t opcode);
  /// One of these.
  /// A message that does not agree with its type makes its table one that is refused.
  /// @throw InputError: the record is damaged.
  void take(std::uint8_t opcode, std::string_view content, const McapPlace& place);
  /// All of them in an unpacked chunk, up to the last that is complete.
  /// @param byte where the chunk stands in the file. @param is_cut its end may be missing.
  void take_chunk(std::string_view records, std::uint64_t byte, bool is_cut);

  void note(const std::string& text) { tables_.note(text); }
  [[nodiscard]] const std::string& file() const { return tables_.file(); }
  /// @throw InputError as TopicTables::finish.
  std::vector<LogTable> finish() &&;

 private:
  struct Channel {
    McapChannel described;
    bool is_opened{false};  ///< Which happens at its first message.
    TopicTable* table{};    ///< Then none: it is not read.
  };

  void take_message(const McapMessage& message, const McapPlace& place);
  TopicTable* open(const McapChannel& channel);

  TopicTables tables_;
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::size_t without_channel_{0};
};

}  // namespace tribolog
