#include "ingest/bags/mcap_messages.h"

#include <utility>

#include <fmt/format.h>

#include "base/error.h"

namespace tribolog {

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
    note(
        fmt::format("chunk (0x06) at byte {} is damaged: no record stands at its byte {}; the "
                    "rest of the chunk is left out",
                    byte, at));
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
  } catch (const CdrError& error) {
    channel.table->refuse(fmt::format("{} ({})", error.what(), place.text()));
  }
}

TopicTable* McapMessages::open(const McapChannel& channel) {
  const auto schema = schemas_.find(channel.schema);
  if (schema == schemas_.end()) {
    return tables_.table_for({channel.topic, "", channel.encoding, "", ""});
  }
  const McapSchema& type = schema->second;
  return tables_.table_for({channel.topic, type.name, channel.encoding, type.encoding, type.data});
}

std::vector<LogTable> McapMessages::finish() && {
  if (without_channel_ > 0) {
    note(fmt::format("messages left out because no channel record stands before them: {}",
                     without_channel_));
  }
  return std::move(tables_).finish();
}

}  // namespace tribolog
