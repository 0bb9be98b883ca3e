#include "ingest/bags/mcap_reader.h"

#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/bags/byte_reader.h"
#include "ingest/bags/mcap_chunk.h"
#include "ingest/bags/mcap_messages.h"
#include "ingest/bags/mcap_records.h"

namespace tribolog {
namespace {

constexpr auto opcode_of = [](McapOpcode opcode) { return static_cast<std::uint8_t>(opcode); };

class McapReader {
 public:
  McapReader(ByteReader& source, const std::string& file, std::uint64_t largest_record_bytes)
      : source_(source), messages_(file), largest_record_bytes_(largest_record_bytes) {}

  std::vector<LogTable> read() && {
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
      note(fmt::format("ends at byte {} without a footer: the recording was not closed", byte));
      return false;
    }
    if (!is_whole) {
      note_cut("the start of a record", byte, mcap_record_start_bytes, start.size());
      return false;
    }
    const McapRecordStart record = mcap_record_start(start);
    if (record.opcode == 0) {
      note(fmt::format("damaged at byte {}: no record has opcode 0x00; what follows is not read",
                       byte));
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
      note(fmt::format("chunk (0x06) at byte {} is left out: {}", byte, chunk.damage));
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
      note(fmt::format("damaged at byte {}: the closing 8 bytes are not those of MCAP", byte));
    } else if (const std::uint64_t rest = source_.skip(~std::uint64_t{0}); rest > 0) {
      note(fmt::format("{} bytes after the log's end at byte {} are not read", rest,
                       byte + mcap_magic.size()));
    }
  }

  void note(const std::string& text) { messages_.note(text); }
  void note_cut(const std::string& record, std::uint64_t byte, std::uint64_t expected,
                std::uint64_t got) {
    note(fmt::format("truncated in {} at byte {}: expected {} bytes, ended after {}", record, byte,
                     expected, got));
  }

  ByteReader& source_;
  McapMessages messages_;
  std::uint64_t largest_record_bytes_;
  bool is_data_end_{false};
};

}  // namespace

std::vector<LogTable> read_mcap(const std::string& path) {
  InputFileSource file(path);
  ByteReader source(file);
  return McapReader(source, path, largest_mcap_record_bytes).read();
}

std::vector<LogTable> read_mcap_bytes(std::string_view bytes, const std::string& file,
                                      std::uint64_t largest_record_bytes) {
  MemorySource memory(bytes);
  ByteReader source(memory);
  return McapReader(source, file, largest_record_bytes).read();
}

}  // namespace tribolog
