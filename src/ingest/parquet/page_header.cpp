#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "ingest/parquet/compact_protocol.h"
#include "ingest/parquet/file_metadata.h"

namespace tribolog::ingest::parquet {
namespace {

constexpr std::int64_t largest_page = std::numeric_limits<std::int32_t>::max();

Encoding read_encoding(CompactReader& in, ThriftType type) {
  const std::int64_t encoding = in.integer(type);
  if (encoding < 0 || encoding > static_cast<int>(Encoding::byte_streams) || encoding == 1) {
    throw UnreadableParquet(
        fmt::format("a column is in an encoding that is not read: {}", encoding));
  }
  return static_cast<Encoding>(encoding);
}

std::size_t page_bytes(CompactReader& in, ThriftType type) {
  return static_cast<std::size_t>(in.count(type, largest_page, "a page's length"));
}

std::size_t page_values(CompactReader& in, ThriftType type) {
  return static_cast<std::size_t>(in.count(type, largest_page, "a page's number of values"));
}

/// Of version 1, and of a dictionary, which has the first two fields alone.
void read_data_header(CompactReader& in, bool is_dictionary, PageHeader& page) {
  read_fields(in, [&](const ThriftField& field) {
    if (field.id == 1) {
      page.values = page_values(in, field.type);
    } else if (field.id == 2) {
      page.encoding = read_encoding(in, field.type);
    } else if (field.id == 3 && !is_dictionary) {
      page.definition_encoding = read_encoding(in, field.type);
    } else if (field.id == 4 && !is_dictionary) {
      page.repetition_encoding = read_encoding(in, field.type);
    } else {
      in.skip(field.type);
    }
  });
}

void read_data_header_v2(CompactReader& in, PageHeader& page) {
  read_fields(in, [&](const ThriftField& field) {
    switch (field.id) {
      case 1:
        page.values = page_values(in, field.type);
        break;
      case 4:
        page.encoding = read_encoding(in, field.type);
        break;
      case 5:
        page.definition_bytes = page_bytes(in, field.type);
        break;
      case 6:
        page.repetition_bytes = page_bytes(in, field.type);
        break;
      case 7:
        page.is_compressed = CompactReader::boolean(field.type);
        break;
      default:
        in.skip(field.type);
    }
  });
}

}  // namespace

PageHeader read_page_header(std::string_view bytes) {
  PageHeader page;
  CompactReader in(bytes);
  read_fields(in, [&](const ThriftField& field) {
    const bool is_structure = field.type == ThriftType::structure;
    if (field.id == 1) {
      page.kind = in.integer(field.type);
    } else if (field.id == 2) {
      page.unpacked_bytes = page_bytes(in, field.type);
    } else if (field.id == 3) {
      page.stored_bytes = page_bytes(in, field.type);
    } else if (field.id == 4) {
      page.crc = static_cast<std::uint32_t>(in.integer(field.type));
    } else if (is_structure && (field.id == 5 || field.id == 7)) {
      read_data_header(in, field.id == 7, page);
    } else if (is_structure && field.id == 8) {
      read_data_header_v2(in, page);
    } else {
      in.skip(field.type);
    }
  });
  page.header_bytes = in.position();
  return page;
}

}  // namespace tribolog::ingest::parquet
