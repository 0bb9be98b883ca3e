#pragma once
// What a Parquet file says of itself: its footer, and the headers of its pages
// (https://github.com/apache/parquet-format/blob/master/src/main/thrift/parquet.thrift).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::ingest::parquet {

enum class PhysicalType : std::uint8_t {
  boolean,
  int32,
  int64,
  int96,
  real32,
  real64,
  bytes,
  fixed_bytes,
};

enum class Repetition : std::uint8_t { required, optional, repeated };

/// What is written into the bytes of a physical type, as far as it is told apart.
enum class LogicalType : std::uint8_t {
  none,
  text,
  map,
  list,
  decimal,
  date,
  time,
  timestamp,
  unsigned_integer,
  real16,
  other,  ///< UUID, BSON, an interval and the like.
};

/// A node of the schema, which is listed depth first.
struct SchemaNode {
  std::string name;
  std::optional<PhysicalType> type;  ///< None of a group.
  std::int32_t type_bytes{};         ///< Of fixed_bytes.
  Repetition repetition{Repetition::required};
  std::size_t children{};
  LogicalType logical{LogicalType::none};
  double units_per_s{1};  ///< Of a time or a timestamp.
  std::int32_t scale{};   ///< Of a decimal: digits behind the point.
};

enum class Codec : std::uint8_t { none, snappy, gzip, lzo, brotli, lz4, zstd, lz4_raw };

/// One column's values in one group of rows.
struct ColumnChunk {
  PhysicalType type{};
  std::int64_t codec{};
  std::uint64_t values{};  ///< Nulls too.
  std::uint64_t begin{};   ///< In the file,
  std::uint64_t bytes{};   ///< so many, in pages.
};

struct RowGroup {
  std::vector<ColumnChunk> chunks;  ///< In the order of the schema's leaves.
  std::uint64_t rows{};
};

struct FileMetadata {
  std::vector<SchemaNode> schema;  ///< The first one is the root.
  std::vector<RowGroup> groups;
  std::string written_by;
};

/// @param footer its bytes, without length and magic. @param file_bytes of the whole file.
/// @throw UnreadableParquet: damaged, encrypted, or its columns lie in other files.
FileMetadata read_metadata(std::string_view footer, std::uint64_t file_bytes);

enum class PageKind : std::uint8_t { data, index, dictionary, data_v2 };

enum class Encoding : std::uint8_t {
  plain = 0,
  plain_dictionary = 2,
  runs = 3,
  bit_packed = 4,
  delta = 5,
  delta_length = 6,
  delta_bytes = 7,
  dictionary = 8,
  byte_streams = 9,
};

struct PageHeader {
  std::int64_t kind{};  ///< PageKind, or one that is not known.
  std::size_t header_bytes{};
  std::size_t stored_bytes{};
  std::size_t unpacked_bytes{};
  std::optional<std::uint32_t> crc;  ///< Of the bytes as they are stored.
  std::size_t values{};              ///< Nulls too.
  Encoding encoding{};
  Encoding definition_encoding{Encoding::runs};
  Encoding repetition_encoding{Encoding::runs};
  // Of version 2, where the levels stand in front and are never compressed.
  std::size_t definition_bytes{};
  std::size_t repetition_bytes{};
  bool is_compressed{true};
};

/// @param bytes of the column's pages, from this one on. @throw UnreadableParquet: damaged.
PageHeader read_page_header(std::string_view bytes);

}  // namespace tribolog::ingest::parquet
