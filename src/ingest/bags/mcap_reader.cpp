#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/bags/bag_readers.h"
#include "ingest/bags/byte_reader.h"
#include "ingest/bags/mcap_records.h"
#include "ingest/bags/message_readers.h"
#include "ingest/messages/topic_tables.h"

namespace tribolog::ingest::bags {

// From records to tables: which channel a message belongs to, and what its topic holds.

namespace {

/// Where a record starts.
struct McapPlace {
  std::uint64_t byte{};                ///< Of the file, or of the unpacked chunk.
  std::optional<std::uint64_t> chunk;  ///< Where that stands in the file.
  [[nodiscard]] std::string text() const;
};

class McapMessages {
 public:
  explicit McapMessages(const std::string& file) : tables_(file, reader_of) {}

  /// Schema, channel or message.
  [[nodiscard]] static bool takes(std::uint8_t opcode);
  /// One of these.
  /// A message that does not agree with its type makes its table one that is refused.
  /// @throw InputError: the record is damaged.
  void take(std::uint8_t opcode, std::string_view content, const McapPlace& place);
  /// All of them in an unpacked chunk, up to the last that is complete.
  /// @param byte where the chunk stands in the file. @param is_cut its end may be missing.
  void take_chunk(std::string_view records, std::uint64_t byte, bool is_cut);

  void note(const Statement& note) { tables_.note(note); }
  [[nodiscard]] const std::string& file() const { return tables_.file(); }
  /// @throw InputError as messages::TopicTables::finish.
  std::vector<log::LogTable> finish() &&;

 private:
  struct Channel {
    McapChannel described;
    bool is_opened{false};          ///< Which happens at its first message.
    messages::TopicTable* table{};  ///< Then none: it is not read.
  };

  void take_message(const McapMessage& message, const McapPlace& place);
  messages::TopicTable* open(const McapChannel& channel);

  messages::TopicTables tables_;
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::size_t without_channel_{0};
};

std::string McapPlace::text() const {
  if (chunk) return fmt::format("byte {} of the chunk at byte {}", byte, *chunk);
  return fmt::format("byte {}", byte);
}

bool McapMessages::takes(std::uint8_t opcode) {
  switch (static_cast<McapOpcode>(opcode)) {
    case McapOpcode::schema:
    case McapOpcode::channel:
    case McapOpcode::message:
      return true;
    default:
      return false;
  }
}

void McapMessages::take(std::uint8_t opcode, std::string_view content, const McapPlace& place) {
  try {
    switch (static_cast<McapOpcode>(opcode)) {
      case McapOpcode::schema: {
        McapSchema schema = mcap_schema(content);
        schemas_[schema.id] = std::move(schema);
        return;
      }
      case McapOpcode::channel: {
        McapChannel channel = mcap_channel(content);
        channels_[channel.id] = {std::move(channel), false, nullptr};
        return;
      }
      case McapOpcode::message:
        return take_message(mcap_message(content), place);
      default:
        return;
    }
  } catch (const McapRecordError& error) {
    throw InputError(
        {file(), 0, 0},
        {mcap_record_name(opcode) + " at " + place.text() + " is damaged", error.what(), "", ""});
  }
}

void McapMessages::take_chunk(std::string_view records, std::uint64_t byte, bool is_cut) {
  std::size_t at = 0;
  while (records.size() - at >= mcap_record_start_bytes) {
    const auto [opcode, bytes] = mcap_record_start(records.substr(at, mcap_record_start_bytes));
    const std::size_t start = at + mcap_record_start_bytes;
    if (opcode == 0 || bytes > records.size() - start) break;
    if (takes(opcode)) {
      take(opcode, records.substr(start, bytes), {at, byte});
    }
    at = start + bytes;
  }
  if (at < records.size() && !is_cut) {
    note({"reading.chunk_damaged", {{"byte", byte}, {"at", at}}});
  }
}

void McapMessages::take_message(const McapMessage& message, const McapPlace& place) {
  const auto found = channels_.find(message.channel);
  if (found == channels_.end()) {
    ++without_channel_;
    return;
  }
  Channel& channel = found->second;
  if (!std::exchange(channel.is_opened, true)) channel.table = open(channel.described);
  if (channel.table == nullptr) return;
  try {
    channel.table->take(message.data, message.log_time_ns);
  } catch (const messages::MessageError& error) {
    channel.table->refuse(fmt::format("{} ({})", error.what(), place.text()));
  }
}

messages::TopicTable* McapMessages::open(const McapChannel& channel) {
  const auto schema = schemas_.find(channel.schema);
  if (schema == schemas_.end()) {
    return tables_.table_for({channel.topic, "", channel.encoding, "", ""});
  }
  const McapSchema& type = schema->second;
  return tables_.table_for({channel.topic, type.name, channel.encoding, type.encoding, type.data});
}

std::vector<log::LogTable> McapMessages::finish() && {
  if (without_channel_ > 0) {
    note({"reading.messages_without_channel", {{"messages", without_channel_}}});
  }
  return std::move(tables_).finish();
}

constexpr auto opcode_of = [](McapOpcode opcode) { return static_cast<std::uint8_t>(opcode); };

class McapReader {
 public:
  McapReader(ByteReader& source, const std::string& file, std::uint64_t largest_record_bytes)
      : source_(source), messages_(file), largest_record_bytes_(largest_record_bytes) {}

  std::vector<log::LogTable> read() && {
    check_magic();
    while (take_record()) {
    }
    return std::move(messages_).finish();
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& found,
                           const std::string& expected) {
    throw InputError({messages_.file(), 0, 0}, {what, found, expected, ""});
  }

  void check_magic() {
    std::string start;
    (void)source_.append(start, mcap_magic.size());
    if (start.empty()) refuse("file is empty", "", "");
    if (start == mcap_magic) return;
    if (mcap_magic.starts_with(start)) {
      refuse("file ends inside the first 8 bytes", fmt::format("{} bytes", start.size()), "");
    }
    if (start.starts_with(mcap_magic.substr(0, 5))) {
      refuse("is MCAP of another version (byte 5)", printable(start.substr(5, 1)), "0");
    }
    refuse("is not an MCAP file (byte 0)", fmt::format("'{}'", printable(start)),
           R"('\x89MCAP0\r\n')");
  }

  /// @return false at the end.
  bool take_record() {
    const std::uint64_t byte = source_.position();
    std::string start;
    const bool is_whole = source_.append(start, mcap_record_start_bytes);
    if (start.empty()) {
      note({"reading.no_footer", {{"byte", byte}}});
      return false;
    }
    if (!is_whole) {
      note_cut("the start of a record", byte, mcap_record_start_bytes, start.size());
      return false;
    }
    const McapRecordStart record = mcap_record_start(start);
    if (record.opcode == 0) {
      note({"reading.damaged_record", {{"byte", byte}}});
      return false;
    }
    if (record.opcode == opcode_of(McapOpcode::chunk)) return take_chunk(record, byte);
    if (is_wanted(record.opcode)) return take_content(record, byte);
    const std::uint64_t skipped = source_.skip(record.content_bytes);
    if (skipped < record.content_bytes) {
      note_cut(mcap_record_name(record.opcode), byte, record.content_bytes, skipped);
      return false;
    }
    if (record.opcode == opcode_of(McapOpcode::data_end)) is_data_end_ = true;
    if (record.opcode != opcode_of(McapOpcode::footer)) return true;
    take_end();
    return false;
  }

  /// After the data, schemas and channels stand there once more. No messages should; a damaged
  /// byte may look like the data's end, and must not hide what follows.
  [[nodiscard]] bool is_wanted(std::uint8_t opcode) const {
    return McapMessages::takes(opcode) &&
           (!is_data_end_ || opcode == opcode_of(McapOpcode::message));
  }

  bool take_content(const McapRecordStart& record, std::uint64_t byte) {
    std::string content;
    const bool is_bounded = record.content_bytes <= largest_record_bytes_;
    const std::uint64_t most = is_bounded ? record.content_bytes : largest_record_bytes_ + 1;
    if (!source_.append(content, most)) {
      note_cut(mcap_record_name(record.opcode), byte, record.content_bytes, content.size());
      return false;
    }
    if (!is_bounded) {
      refuse(fmt::format("{} at byte {} is too large", mcap_record_name(record.opcode), byte),
             fmt::format("{} bytes", record.content_bytes),
             fmt::format("at most {}", largest_record_bytes_));
    }
    messages_.take(record.opcode, content, {byte, std::nullopt});
    return true;
  }

  bool take_chunk(const McapRecordStart& record, std::uint64_t byte) {
    const UnpackedChunk chunk = unpack_chunk(source_, record.content_bytes, largest_record_bytes_);
    if (chunk.is_cut) {
      note_cut(mcap_record_name(record.opcode), byte, record.content_bytes,
               source_.position() - byte - mcap_record_start_bytes);
    }
    if (!chunk.damage.empty()) {
      note({"reading.chunk_left_out", {{"byte", byte}, {"why", chunk.damage}}});
    } else {
      messages_.take_chunk(chunk.records, byte, chunk.is_cut);
    }
    return !chunk.is_cut;
  }

  void take_end() {
    const std::uint64_t byte = source_.position();
    std::string end;
    (void)source_.append(end, mcap_magic.size());
    if (end != mcap_magic) {
      note({"reading.damaged_end", {{"byte", byte}}});
    } else if (const std::uint64_t rest = source_.skip(~std::uint64_t{0}); rest > 0) {
      note({"reading.bytes_after_end", {{"bytes", rest}, {"end", byte + mcap_magic.size()}}});
    }
  }

  void note(const Statement& note) { messages_.note(note); }
  void note_cut(const std::string& record, std::uint64_t byte, std::uint64_t expected,
                std::uint64_t got) {
    note({"reading.truncated",
          {{"record", record}, {"byte", byte}, {"expected", expected}, {"got", got}}});
  }

  ByteReader& source_;
  McapMessages messages_;
  std::uint64_t largest_record_bytes_;
  bool is_data_end_{false};
};

}  // namespace

std::vector<log::LogTable> read_mcap(const std::string& path) {
  InputFileSource file(path);
  ByteReader source(file);
  return McapReader(source, path, largest_mcap_record_bytes).read();
}

std::vector<log::LogTable> read_mcap_bytes(std::string_view bytes, const std::string& file,
                                           std::uint64_t largest_record_bytes) {
  MemorySource memory(bytes);
  ByteReader source(memory);
  return McapReader(source, file, largest_record_bytes).read();
}

}  // namespace tribolog::ingest::bags
