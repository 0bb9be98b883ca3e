#include "support/parquet_writer.h"

#include <algorithm>
#include <utility>

namespace tribolog::test {
namespace {

constexpr int type_integer_64 = 6;
constexpr int type_binary = 8;
constexpr int type_list = 9;
constexpr int type_structure = 12;
constexpr std::size_t long_list = 15;

std::uint64_t zigzag(std::int64_t value) {
  return (static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63);
}

}  // namespace

std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80U; value >>= 7U) bytes += static_cast<char>(value | 0x80U);
  return bytes + static_cast<char>(value);
}

void CompactWriter::head(int id, int type) {
  bytes_ += static_cast<char>(((id - last_id_) << 4) | type);
  last_id_ = id;
}

CompactWriter& CompactWriter::integer(int id, std::int64_t value, int type) {
  head(id, type);
  bytes_ += type == 3 ? std::string(1, static_cast<char>(value)) : varint(zigzag(value));
  return *this;
}

CompactWriter& CompactWriter::text(int id, const std::string& value) {
  head(id, type_binary);
  bytes_ += varint(value.size()) + value;
  return *this;
}

CompactWriter& CompactWriter::boolean(int id, bool value) {
  head(id, value ? 1 : 2);
  return *this;
}

CompactWriter& CompactWriter::structure(int id, const CompactWriter& inner) {
  head(id, type_structure);
  bytes_ += inner.bytes();
  return *this;
}

CompactWriter& CompactWriter::structures(int id, const std::vector<CompactWriter>& list) {
  head(id, type_list);
  if (list.size() < long_list) {
    bytes_ += static_cast<char>((list.size() << 4U) | type_structure);
  } else {
    bytes_ += static_cast<char>((long_list << 4U) | type_structure) + varint(list.size());
  }
  for (const CompactWriter& one : list) bytes_ += one.bytes();
  return *this;
}

std::string level_runs(const std::vector<std::pair<unsigned, unsigned>>& count_and_level) {
  std::string runs;
  for (const auto& [count, level] : count_and_level) {
    runs += varint(std::uint64_t{count} << 1U) + static_cast<char>(level);
  }
  return raw(std::vector{static_cast<std::uint32_t>(runs.size())}) + runs;
}

namespace {

CompactWriter node_of(const WrittenNode& node) {
  CompactWriter out;
  if (node.type) out.integer(1, *node.type);
  if (node.type_bytes > 0) out.integer(2, node.type_bytes);
  if (node.repetition) out.integer(3, *node.repetition);
  out.text(4, node.name);
  if (node.children > 0) out.integer(5, node.children);
  if (node.converted) out.integer(6, *node.converted);
  if (node.scale != 0) out.integer(7, node.scale);
  if (node.logical) out.structure(10, *node.logical);
  return out;
}

std::string page_of(int kind, const std::string& body, const WrittenColumn& column) {
  constexpr int dictionary_page = 2;
  CompactWriter data;
  const bool is_dictionary = kind == dictionary_page;
  const std::int64_t values =
      is_dictionary ? static_cast<std::int64_t>(column.dictionary_values)
                    : column.stated_values.value_or(static_cast<std::int64_t>(column.values));
  data.integer(1, values).integer(2, is_dictionary ? 0 : column.encoding);
  if (!is_dictionary) data.integer(3, column.level_encoding).integer(4, column.level_encoding);
  CompactWriter header;
  header.integer(1, kind);
  header.integer(2, column.stated_unpacked.value_or(static_cast<std::int64_t>(body.size())));
  header.integer(3, static_cast<std::int64_t>(body.size()));
  if (column.crc) header.integer(4, static_cast<std::int32_t>(*column.crc));
  header.structure(is_dictionary ? 7 : 5, data);
  return header.bytes() + body;
}

}  // namespace

std::string write_parquet(const WrittenParquet& file) {
  std::string bytes = file.magic;
  std::vector<CompactWriter> chunks;
  for (const WrittenColumn& column : file.columns) {
    const std::size_t begin = bytes.size();
    if (!column.dictionary.empty()) bytes += page_of(2, column.dictionary, column);
    const std::size_t data = bytes.size();
    bytes += page_of(0, column.page, column);
    CompactWriter metadata;
    metadata.integer(1, column.type).integer(4, column.codec);
    metadata.integer(5, column.stated_values.value_or(static_cast<std::int64_t>(column.values)),
                     type_integer_64);
    metadata.integer(7, static_cast<std::int64_t>(bytes.size() - begin), type_integer_64);
    metadata.integer(9, static_cast<std::int64_t>(data), type_integer_64);
    if (data > begin) metadata.integer(11, static_cast<std::int64_t>(begin), type_integer_64);
    chunks.emplace_back();
    chunks.back().integer(2, static_cast<std::int64_t>(begin), type_integer_64);
    chunks.back().structure(3, metadata);
  }
  const std::size_t children = file.root_children > 0 ? file.root_children : file.schema.size();
  std::vector<CompactWriter> nodes{
      node_of({"schema", {}, std::nullopt, static_cast<int>(children)})};
  for (const WrittenNode& node : file.schema) nodes.push_back(node_of(node));
  CompactWriter group;
  group.structures(1, chunks).integer(2, 0, type_integer_64).integer(3, file.rows, type_integer_64);
  CompactWriter footer;
  footer.integer(1, 1).structures(2, nodes).integer(3, file.rows, type_integer_64);
  footer.structures(4, {group}).text(6, "tribolog's tests");
  const std::string tail = footer.bytes();
  return bytes + tail + raw(std::vector{static_cast<std::uint32_t>(tail.size())}) + file.magic;
}

namespace {

/// One more column below the root.
void count_column(WrittenParquet& file) {
  if (file.root_children == 0) file.root_children = file.schema.size();
  ++file.root_children;
}

}  // namespace

void add_doubles(const std::string& name, const std::vector<double>& values, WrittenParquet& file) {
  constexpr int real64 = 5;
  count_column(file);
  file.schema.push_back({name, real64});
  file.columns.push_back({real64, raw(values), values.size()});
  file.rows = static_cast<std::int64_t>(values.size());
}

void add_integers(const std::string& name, const std::vector<std::int64_t>& values,
                  WrittenParquet& file) {
  constexpr int int64 = 2;
  count_column(file);
  file.schema.push_back({name, int64});
  file.columns.push_back({int64, raw(values), values.size()});
  file.rows = static_cast<std::int64_t>(values.size());
}

void add_lists(const std::string& name, const std::vector<std::vector<float>>& rows,
               WrittenParquet& file) {
  constexpr int real32 = 4;
  constexpr int list = 3;
  count_column(file);
  file.schema.push_back({name, {}, 1, 1, list});
  file.schema.push_back({"list", {}, 2, 1});
  file.schema.push_back({"element", real32, 0});
  std::vector<std::pair<unsigned, unsigned>> repetition;
  std::vector<std::pair<unsigned, unsigned>> definition;
  WrittenColumn column{real32, {}};
  std::string values;
  for (const std::vector<float>& row : rows) {
    const auto size = static_cast<unsigned>(row.size());
    repetition.emplace_back(1U, 0U);
    if (size > 1) repetition.emplace_back(size - 1, 1U);
    definition.emplace_back(std::max(1U, size), size > 0 ? 2U : 1U);
    column.values += std::max<std::size_t>(1, row.size());
    values += raw(row);
  }
  column.page = level_runs(repetition) + level_runs(definition) + values;
  file.columns.push_back(std::move(column));
  file.rows = static_cast<std::int64_t>(rows.size());
}

}  // namespace tribolog::test
