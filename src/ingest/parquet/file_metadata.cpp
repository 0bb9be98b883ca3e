#include "ingest/parquet/file_metadata.h"

#include <algorithm>
#include <limits>

#include "ingest/parquet/compact_protocol.h"

namespace tribolog::ingest::parquet {
namespace {

constexpr std::int64_t most_rows = std::int64_t{1} << 31;
constexpr std::int64_t largest_offset = std::numeric_limits<std::int64_t>::max();
constexpr std::size_t most_nodes = 65'536;
constexpr std::size_t most_chunks = std::size_t{1} << 20;
constexpr std::int64_t most_type_bytes = 1 << 20;

[[noreturn]] void refuse_encrypted() {
  throw UnreadableParquet("is encrypted Parquet", "", "decrypt it where its key is");
}

PhysicalType physical_type(CompactReader& in, ThriftType type) {
  return static_cast<PhysicalType>(
      in.count(type, static_cast<int>(PhysicalType::fixed_bytes), "a column's type"));
}

std::int32_t read_scale(CompactReader& in, ThriftType type) {
  constexpr std::int64_t most_digits = 1000;
  return static_cast<std::int32_t>(in.count(type, most_digits, "a decimal's scale"));
}

// Units of times: seconds, and their parts.

constexpr double milliseconds = 1e3;
constexpr double microseconds = 1e6;
constexpr double nanoseconds = 1e9;

void tell(SchemaNode& node, LogicalType logical, double units_per_s = 1) {
  node.logical = logical;
  node.units_per_s = units_per_s;
}

/// As older writers say it.
void tell_converted(std::int64_t converted, SchemaNode& node) {
  switch (converted) {
    case 0:   // UTF8
    case 4:   // ENUM
    case 19:  // JSON
      return tell(node, LogicalType::text);
    case 1:
    case 2:
      return tell(node, LogicalType::map);
    case 3:
      return tell(node, LogicalType::list);
    case 5:
      return tell(node, LogicalType::decimal);
    case 6:
      return tell(node, LogicalType::date);
    case 7:
      return tell(node, LogicalType::time, milliseconds);
    case 8:
      return tell(node, LogicalType::time, microseconds);
    case 9:
      return tell(node, LogicalType::timestamp, milliseconds);
    case 10:
      return tell(node, LogicalType::timestamp, microseconds);
    case 11:
    case 12:
    case 13:
    case 14:
      return tell(node, LogicalType::unsigned_integer);
    case 20:  // BSON
    case 21:  // INTERVAL
      return tell(node, LogicalType::other);
    default:
      return;  // signed integers
  }
}

/// {1: is it UTC, 2: {1: ms, 2: us, 3: ns}}
double time_unit(CompactReader& in) {
  double units_per_s = milliseconds;
  read_fields(in, [&](const ThriftField& field) {
    if (field.id != 2 || field.type != ThriftType::structure) return in.skip(field.type);
    read_fields(in, [&](const ThriftField& unit) {
      units_per_s = unit.id == 1 ? milliseconds : unit.id == 2 ? microseconds : nanoseconds;
      in.skip(unit.type);
    });
  });
  return units_per_s;
}

/// {1: its width, 2: is it signed}
LogicalType integer_type(CompactReader& in) {
  bool is_signed = true;
  read_fields(in, [&](const ThriftField& field) {
    if (field.id == 2) is_signed = CompactReader::boolean(field.type);
    in.skip(field.type);
  });
  return is_signed ? LogicalType::none : LogicalType::unsigned_integer;
}

/// {1: digits behind the point, 2: digits}
std::int32_t decimal_scale(CompactReader& in) {
  std::int32_t scale = 0;
  read_fields(in, [&](const ThriftField& field) {
    if (field.id != 1) return in.skip(field.type);
    scale = read_scale(in, field.type);
  });
  return scale;
}

/// A union: the number of its field says which type it is.
void tell_logical(CompactReader& in, SchemaNode& node) {
  read_fields(in, [&](const ThriftField& field) {
    const bool is_structure = field.type == ThriftType::structure;
    switch (is_structure ? field.id : 0) {
      case 5:
        node.scale = decimal_scale(in);
        return tell(node, LogicalType::decimal);
      case 7:
        return tell(node, LogicalType::time, time_unit(in));
      case 8:
        return tell(node, LogicalType::timestamp, time_unit(in));
      case 10:
        return tell(node, integer_type(in));
      default:
        in.skip(field.type);
    }
    switch (field.id) {
      case 1:   // STRING
      case 4:   // ENUM
      case 12:  // JSON
        return tell(node, LogicalType::text);
      case 2:
        return tell(node, LogicalType::map);
      case 3:
        return tell(node, LogicalType::list);
      case 6:
        return tell(node, LogicalType::date);
      case 11:  // of nulls alone
        return tell(node, LogicalType::none);
      case 15:
        return tell(node, LogicalType::real16);
      default:
        return tell(node, LogicalType::other);
    }
  });
}

SchemaNode read_node(CompactReader& in) {
  SchemaNode node;
  SchemaNode newer;  // what the logical type says counts more
  bool has_logical = false;
  read_fields(in, [&](const ThriftField& field) {
    switch (field.id) {
      case 1:
        node.type = physical_type(in, field.type);
        break;
      case 2:
        node.type_bytes =
            static_cast<std::int32_t>(in.count(field.type, most_type_bytes, "a value's length"));
        break;
      case 3:
        node.repetition = static_cast<Repetition>(in.count(field.type, 2, "a repetition"));
        break;
      case 4:
        node.name = in.text(field.type);
        break;
      case 5:
        node.children = static_cast<std::size_t>(in.count(field.type, most_nodes, "a schema"));
        break;
      case 6:
        tell_converted(in.integer(field.type), node);
        break;
      case 7:
        node.scale = read_scale(in, field.type);
        break;
      case 10:
        if (field.type != ThriftType::structure) return in.skip(field.type);
        tell_logical(in, newer);
        has_logical = true;
        break;
      default:
        in.skip(field.type);
    }
  });
  if (has_logical) tell(node, newer.logical, newer.units_per_s);
  if (newer.logical == LogicalType::decimal) node.scale = newer.scale;
  return node;
}

/// Where the pages of a column begin: the dictionary's is the first, if there is one.
struct ChunkPlace {
  std::uint64_t data{};
  std::uint64_t dictionary{};
};

ColumnChunk read_chunk_metadata(CompactReader& in, std::uint64_t file_bytes) {
  ColumnChunk chunk;
  ChunkPlace place;
  const auto offset = [&](const ThriftField& field) {
    return static_cast<std::uint64_t>(in.count(field.type, largest_offset, "a place in the file"));
  };
  read_fields(in, [&](const ThriftField& field) {
    switch (field.id) {
      case 1:
        chunk.type = physical_type(in, field.type);
        break;
      case 4:
        chunk.codec = in.integer(field.type);
        break;
      case 5:
        chunk.values = static_cast<std::uint64_t>(
            in.count(field.type, most_rows, "a column's number of values"));
        break;
      case 7:
        chunk.bytes = offset(field);
        break;
      case 9:
        place.data = offset(field);
        break;
      case 11:
        place.dictionary = offset(field);
        break;
      default:
        in.skip(field.type);
    }
  });
  const bool has_dictionary = place.dictionary > 0 && place.dictionary < place.data;
  chunk.begin = has_dictionary ? place.dictionary : place.data;
  if (chunk.begin > file_bytes || chunk.bytes > file_bytes - chunk.begin) {
    throw UnreadableParquet("damaged: a column lies outside of the file");
  }
  return chunk;
}

ColumnChunk read_chunk(CompactReader& in, std::uint64_t file_bytes) {
  ColumnChunk chunk;
  bool has_metadata = false;
  read_fields(in, [&](const ThriftField& field) {
    if (field.id == 1 && !in.text(field.type).empty()) {
      throw UnreadableParquet("its columns lie in other files", "",
                              "read those, or write it as one file");
    }
    if (field.id == 1) return;
    if (field.id == 8) refuse_encrypted();
    if (field.id != 3 || field.type != ThriftType::structure) return in.skip(field.type);
    chunk = read_chunk_metadata(in, file_bytes);
    has_metadata = true;
  });
  if (!has_metadata) throw UnreadableParquet("damaged: a column is not described");
  return chunk;
}

RowGroup read_group(CompactReader& in, std::uint64_t file_bytes, std::size_t most_columns) {
  RowGroup group;
  read_fields(in, [&](const ThriftField& field) {
    if (field.id == 3) {
      group.rows = static_cast<std::uint64_t>(in.count(field.type, most_rows, "a number of rows"));
      return;
    }
    if (field.id != 1) return in.skip(field.type);
    const ThriftList list = in.list(field.type);
    if (list.type != ThriftType::structure || list.size > most_columns) {
      throw UnreadableParquet("damaged: a group of rows has other columns than the schema");
    }
    for (std::size_t i = 0; i < list.size; ++i) group.chunks.push_back(read_chunk(in, file_bytes));
  });
  return group;
}

/// @param most of a list of structures.
std::size_t structures_in(CompactReader& in, const ThriftField& field, std::size_t most) {
  const ThriftList list = in.list(field.type);
  if (list.type != ThriftType::structure || list.size > most) {
    throw UnreadableParquet("damaged: the footer has a list that cannot be");
  }
  return list.size;
}

}  // namespace

FileMetadata read_metadata(std::string_view footer, std::uint64_t file_bytes) {
  FileMetadata metadata;
  CompactReader in(footer);
  read_fields(in, [&](const ThriftField& field) {
    switch (field.id) {
      case 2:
        metadata.schema.clear();
        for (std::size_t n = structures_in(in, field, most_nodes); n > 0; --n) {
          metadata.schema.push_back(read_node(in));
        }
        break;
      case 4: {
        const std::size_t columns = metadata.schema.size();
        const std::size_t most = most_chunks / std::max<std::size_t>(1, columns);
        metadata.groups.clear();
        for (std::size_t n = structures_in(in, field, most); n > 0; --n) {
          metadata.groups.push_back(read_group(in, file_bytes, columns));
        }
        break;
      }
      case 6:
        metadata.written_by = in.text(field.type);
        break;
      case 8:
        refuse_encrypted();
      default:
        in.skip(field.type);
    }
  });
  if (metadata.schema.empty()) throw UnreadableParquet("damaged: the footer has no schema");
  return metadata;
}

}  // namespace tribolog::ingest::parquet
