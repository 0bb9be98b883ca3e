#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/input_file.h"
#include "ingest/bags/bag_readers.h"
#include "ingest/bags/bag_records.h"
#include "ingest/bags/byte_reader.h"
#include "ingest/bags/chunk_unpacker.h"
#include "ingest/bags/message_readers.h"
#include "ingest/messages/topic_tables.h"

namespace tribolog::ingest::bags {
namespace {

/// Topics and callers have names, not more.
constexpr std::uint32_t longest_header = 1U << 20U;
constexpr std::uint64_t unknown_bytes = ~std::uint64_t{0};

/// A record of the file, of which the data are not read yet.
struct BagRecord {
  std::uint64_t byte{};  ///< Where it starts.
  BagFields fields;      ///< Valid until the next record's are read.
  std::uint8_t op{};
  std::uint32_t data_bytes{};
};

/// From connections and messages to tables.
class BagMessages {
 public:
  explicit BagMessages(const std::string& file) : tables_(file, reader_of) {}

  [[nodiscard]] static bool takes(std::uint8_t op) {
    return op == static_cast<std::uint8_t>(BagOp::message) ||
           op == static_cast<std::uint8_t>(BagOp::connection);
  }

  /// One of these. @param place "byte 5 of the chunk at byte 4117".
  /// @return false: its fields are damaged.
  bool take(std::uint8_t op, const BagFields& fields, std::string_view data,
            const std::string& place) {
    if (op == static_cast<std::uint8_t>(BagOp::connection)) return take_connection(fields, data);
    return take_message(fields, data, place);
  }

  /// All records in an unpacked chunk, up to the last that is complete.
  /// @param byte where it stands in the file. @param is_cut its end may be missing.
  void take_chunk(std::string_view records, std::uint64_t byte, bool is_cut) {
    std::size_t at = 0;
    while (const std::size_t bytes = take_record(records.substr(at), at, byte)) at += bytes;
    if (at == records.size() || is_cut) return;
    note({"reading.bag_chunk_damaged", {{"byte", byte}, {"at", at}}});
  }

  void note(const Statement& note) { tables_.note(note); }
  [[nodiscard]] const std::string& file() const { return tables_.file(); }

  std::vector<log::LogTable> finish() && {
    if (without_topic_ > 0) {
      note({"reading.messages_without_topic", {{"messages", without_topic_}}});
    }
    return std::move(tables_).finish();
  }

 private:
  struct Connection {
    messages::TopicDescription topic;
    bool is_opened{false};          ///< Which happens at its first message.
    messages::TopicTable* table{};  ///< Then none: it is not read.
  };

  /// @return how many bytes it takes; 0: there is none.
  std::size_t take_record(std::string_view rest, std::size_t at, std::uint64_t chunk) {
    if (rest.size() < bag_length_bytes) return 0;
    const std::uint64_t header_bytes = bag_length(rest);
    const std::uint64_t data_length_at = bag_length_bytes + header_bytes;
    if (data_length_at + bag_length_bytes > rest.size()) return 0;
    const std::uint64_t data_at = data_length_at + bag_length_bytes;
    const std::uint64_t data_bytes = bag_length(rest.substr(data_length_at));
    if (data_bytes > rest.size() - data_at) return 0;
    const auto fields = BagFields::parse(rest.substr(bag_length_bytes, header_bytes));
    const auto op = fields ? fields->uint8("op") : std::nullopt;
    if (!op) return 0;
    if (takes(*op) && !take(*op, *fields, rest.substr(data_at, data_bytes),
                            fmt::format("byte {} of the chunk at byte {}", at, chunk))) {
      return 0;
    }
    return data_at + data_bytes;
  }

  bool take_connection(const BagFields& fields, std::string_view data) {
    const auto number = fields.uint32("conn");
    const auto described = BagFields::parse(data);
    if (!number || !described) return false;
    Connection connection;
    connection.topic = {std::string(fields.value("topic")), std::string(described->value("type")),
                        "ros1", "ros1msg", std::string(described->value("message_definition"))};
    connections_[*number] = std::move(connection);
    return true;
  }

  bool take_message(const BagFields& fields, std::string_view data, const std::string& place) {
    const auto number = fields.uint32("conn");
    const auto time_ns = fields.time_ns("time");
    if (!number || !time_ns) return false;
    const auto found = connections_.find(*number);
    if (found == connections_.end()) {
      ++without_topic_;
      return true;
    }
    Connection& connection = found->second;
    if (!std::exchange(connection.is_opened, true)) {
      connection.table = tables_.table_for(connection.topic);
    }
    if (connection.table == nullptr) return true;
    try {
      connection.table->take(data, *time_ns);
    } catch (const messages::MessageError& error) {
      connection.table->refuse(fmt::format("{} ({})", error.what(), place));
    }
    return true;
  }

  messages::TopicTables tables_;
  std::map<std::uint32_t, Connection> connections_;
  std::size_t without_topic_{0};
};

std::optional<Compression> compression_of(std::string_view name) {
  if (name == "none") return Compression::none;
  if (name == "bz2") return Compression::bz2;
  if (name == "lz4") return Compression::lz4;
  return std::nullopt;
}

class BagReader {
 public:
  BagReader(ByteReader& source, const std::string& file, std::uint64_t largest_record_bytes)
      : source_(source), messages_(file), largest_record_bytes_(largest_record_bytes) {}

  std::vector<log::LogTable> read() && {
    check_magic();
    while (take_record()) {
    }
    if (!is_closed_) messages_.note(Code{"reading.no_index"});
    return std::move(messages_).finish();
  }

 private:
  [[noreturn]] void refuse(const InputError::Problem& problem) {
    throw InputError({messages_.file(), 0, 0}, problem);
  }

  void check_magic() {
    constexpr std::string_view name = "#ROSBAG V";
    std::string start;
    (void)source_.append(start, bag_magic.size());
    if (start.empty()) refuse({"file is empty", "", "", ""});
    if (start == bag_magic) return;
    const std::string found = "'" + printable(start) + "'";
    if (bag_magic.starts_with(start)) {
      refuse({"file ends inside the first 13 bytes", found, "", ""});
    }
    if (!start.starts_with(name)) refuse({"is not a bag (byte 0)", found, "'#ROSBAG V2.0'", ""});
    refuse({"is a bag of another version (byte 9)", found, "'#ROSBAG V2.0'",
            "rosbag filter " + messages_.file() + " new.bag True"});
  }

  /// @return false at the end.
  bool take_record() {
    const std::optional<BagRecord> record = record_start();
    if (!record) return false;
    if (record->op == static_cast<std::uint8_t>(BagOp::chunk)) return take_chunk(*record);
    if (BagMessages::takes(record->op)) return take_content(*record);
    if (record->op == static_cast<std::uint8_t>(BagOp::bag_header)) check_bag_header(*record);
    const std::uint64_t skipped = source_.skip(record->data_bytes);
    return skipped == record->data_bytes || note_cut(*record, skipped);
  }

  /// Nothing at the end, or where there is no record; a note says why.
  std::optional<BagRecord> record_start() {
    BagRecord record;
    record.byte = source_.position();
    std::string length;
    const bool has_length = source_.append(length, bag_length_bytes);
    if (length.empty()) return std::nullopt;
    const std::uint32_t header_bytes = has_length ? bag_length(length) : 0;
    if (header_bytes > longest_header) return note_damaged(record.byte);
    const std::uint64_t wanted = header_bytes + bag_length_bytes;
    header_.clear();
    if (!has_length || !source_.append(header_, wanted)) {
      note_cut("the start of a record", record.byte, bag_length_bytes + wanted,
               length.size() + header_.size());
      return std::nullopt;
    }
    record.data_bytes = bag_length(std::string_view(header_).substr(header_bytes));
    auto fields = BagFields::parse(std::string_view(header_).substr(0, header_bytes));
    const auto op = fields ? fields->uint8("op") : std::nullopt;
    if (!op) return note_damaged(record.byte);
    record.fields = *std::move(fields);
    record.op = *op;
    return record;
  }

  void check_bag_header(const BagRecord& record) {
    const std::string_view encryptor = record.fields.value("encryptor");
    if (!encryptor.empty()) {
      refuse({"is an encrypted bag", "'" + printable(std::string(encryptor)) + "'",
              "a bag without encryption",
              "rosbag decrypt " + messages_.file() + " where its key is"});
    }
    is_closed_ = record.fields.uint64("index_pos").value_or(0) > 0;
  }

  bool take_content(const BagRecord& record) {
    if (record.data_bytes > largest_record_bytes_) {
      refuse({fmt::format("{} at byte {} is too large", bag_record_name(record.op), record.byte),
              fmt::format("{} bytes", record.data_bytes),
              fmt::format("at most {}", largest_record_bytes_), ""});
    }
    std::string data;
    if (!source_.append(data, record.data_bytes)) return note_cut(record, data.size());
    if (messages_.take(record.op, record.fields, data, fmt::format("byte {}", record.byte))) {
      return true;
    }
    (void)note_damaged(record.byte);
    return false;
  }

  bool take_chunk(const BagRecord& record) {
    const std::uint64_t stated = record.fields.uint32("size").value_or(0);
    const auto compression = compression_of(record.fields.value("compression"));
    std::string damage;
    if (!compression) {
      damage =
          "is compressed with '" + printable(std::string(record.fields.value("compression"))) + "'";
    } else if (stated > largest_record_bytes_) {
      damage =
          fmt::format("it states {} bytes unpacked, more than {}", stated, largest_record_bytes_);
    }
    if (!damage.empty()) {
      note_left_out(record, damage);
      const std::uint64_t skipped = source_.skip(record.data_bytes);
      return skipped == record.data_bytes || note_cut(record, skipped);
    }
    // The one that a recorder is still writing: its sizes follow when it is complete, and of one
    // that is not compressed the records are read as if they stood outside.
    const bool is_open = !is_closed_ && stated == 0 && record.data_bytes == 0;
    if (is_open && *compression == Compression::none) return true;
    if (is_open) return take_open_chunk(record, *compression);
    return unpack(record, *chunk_unpacker(*compression, stated), record.data_bytes, stated);
  }

  bool take_open_chunk(const BagRecord& record, Compression compression) {
    return unpack(record, *chunk_unpacker(compression, largest_record_bytes_), unknown_bytes,
                  unknown_bytes);
  }

  /// @return false: the file ends with it.
  bool unpack(const BagRecord& record, ChunkUnpacker& unpacker, std::uint64_t stored_bytes,
              std::uint64_t stated_bytes) {
    std::uint64_t left = stored_bytes;
    std::string damage;
    while (left > 0) {
      const std::string_view stored = source_.next(left);
      if (stored.empty()) break;
      left -= stored.size();
      try {
        if (damage.empty()) unpacker.add(stored);
      } catch (const ChunkError& error) {
        damage = error.what();
      }
    }
    const bool is_cut = left > 0;
    const std::size_t unpacked = unpacker.records().size();
    if (is_cut && stored_bytes != unknown_bytes) note_cut(record, stored_bytes - left);
    if (damage.empty() && !is_cut && unpacked != stated_bytes) {
      damage = fmt::format("it unpacks to {} bytes instead of {}", unpacked, stated_bytes);
    }
    if (damage.empty()) {
      messages_.take_chunk(unpacker.records(), record.byte, is_cut);
    } else {
      note_left_out(record, damage);
    }
    return !is_cut;
  }

  void note_left_out(const BagRecord& record, const std::string& why) {
    messages_.note({"reading.bag_chunk_left_out", {{"byte", record.byte}, {"why", why}}});
  }

  std::nullopt_t note_damaged(std::uint64_t byte) {
    messages_.note({"reading.damaged_bag", {{"byte", byte}}});
    return std::nullopt;
  }

  void note_cut(const std::string& record, std::uint64_t byte, std::uint64_t expected,
                std::uint64_t got) {
    messages_.note({"reading.truncated",
                    {{"record", record}, {"byte", byte}, {"expected", expected}, {"got", got}}});
  }

  /// @return false: nothing follows.
  bool note_cut(const BagRecord& record, std::uint64_t got) {
    note_cut(bag_record_name(record.op), record.byte, record.data_bytes, got);
    return false;
  }

  ByteReader& source_;
  std::string header_;  ///< Of the record that is being read.
  BagMessages messages_;
  std::uint64_t largest_record_bytes_;
  bool is_closed_{false};
};

}  // namespace

std::vector<log::LogTable> read_rosbag(const std::string& path) {
  InputFileSource file(path);
  ByteReader source(file);
  return BagReader(source, path, largest_bag_record_bytes).read();
}

std::vector<log::LogTable> read_rosbag_bytes(std::string_view bytes, const std::string& file,
                                             std::uint64_t largest_record_bytes) {
  MemorySource memory(bytes);
  ByteReader source(memory);
  return BagReader(source, file, largest_record_bytes).read();
}

}  // namespace tribolog::ingest::bags
