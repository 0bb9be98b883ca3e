#pragma once
// Thrift's compact protocol, in which Parquet writes its footer and the headers of its pages
// (https://github.com/apache/thrift/blob/master/doc/specs/thrift-compact-protocol.md).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace tribolog::ingest::parquet {

/// The file is damaged, or is of a kind that is not read; the text says how, as one line without
/// the file's name.
class UnreadableParquet : public std::runtime_error {
 public:
  explicit UnreadableParquet(const std::string& what, std::string found = "", std::string hint = "")
      : std::runtime_error(what), found_(std::move(found)), hint_(std::move(hint)) {}
  [[nodiscard]] const std::string& found() const { return found_; }
  [[nodiscard]] const std::string& hint() const { return hint_; }

 private:
  std::string found_;
  std::string hint_;
};

/// As the protocol numbers them.
enum class ThriftType : std::uint8_t {
  stop,
  yes,  ///< A field's boolean is its type.
  no,
  byte,
  i16,
  i32,
  i64,
  real,
  binary,
  list,
  set,
  map,
  structure,
};

struct ThriftField {
  std::int32_t id{};
  ThriftType type{};
};

struct ThriftList {
  std::size_t size{};  ///< No more than the bytes that are left.
  ThriftType type{};
};

/// Values one after the other. Each function throws UnreadableParquet where the bytes end first or
/// another type stands there.
class CompactReader {
 public:
  explicit CompactReader(std::string_view bytes) : bytes_(bytes) {}

  /// The next field of a structure; nothing at its end.
  /// @param last_id of the structure's field before it, 0 in front of the first; it is moved on.
  std::optional<ThriftField> next_field(std::int32_t& last_id);
  std::int64_t integer(ThriftType type);
  /// One that counts or measures. @throw UnreadableParquet: it is negative, or above `most`.
  std::int64_t count(ThriftType type, std::int64_t most, const char* what);
  std::string_view text(ThriftType type);
  static bool boolean(ThriftType type);
  ThriftList list(ThriftType type);
  void skip(ThriftType type) { skip(type, 0); }
  [[nodiscard]] std::size_t position() const { return at_; }

 private:
  std::uint8_t byte();
  std::uint64_t varint();
  void pass(std::uint64_t bytes);
  void skip(ThriftType type, int depth);
  void skip_elements(std::uint64_t size, ThriftType type, int depth);
  void skip_map(int depth);

  std::string_view bytes_;
  std::size_t at_{};
};

/// Calls `use(field)` for each field of a structure; what it does not know it has to skip.
template <class Use>
void read_fields(CompactReader& in, const Use& use) {
  std::int32_t last_id = 0;
  while (const auto field = in.next_field(last_id)) use(*field);
}

}  // namespace tribolog::ingest::parquet
