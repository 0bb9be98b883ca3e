#include "ingest/parquet/parquet_reader.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/input_file.h"
#include "ingest/parquet/column_values.h"
#include "ingest/parquet/compact_protocol.h"
#include "ingest/parquet/file_metadata.h"
#include "ingest/parquet/leaf_columns.h"
#include "ingest/parquet/lerobot_set.h"
#include "ingest/parquet/table_columns.h"
#include "ingest/text/csv_dialect.h"
#include "wording/words.h"

namespace tribolog::ingest::parquet {
namespace {

constexpr std::string_view magic = "PAR1";
constexpr std::string_view magic_of_encrypted = "PARE";
constexpr std::size_t tail_bytes = sizeof(std::uint32_t) + magic.size();
constexpr std::uint64_t largest_footer_bytes = std::uint64_t{1} << 28;
constexpr std::size_t most_listed = 12;
constexpr std::size_t most_columns = 16'384;

/// A file's bytes, from anywhere.
class ParquetFile {
 public:
  virtual ~ParquetFile() = default;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// They stay valid until the next call. @param at and @param bytes within the file.
  virtual std::string_view bytes_at(std::uint64_t at, std::uint64_t bytes) = 0;
};

class FileOnDisk final : public ParquetFile {
 public:
  explicit FileOnDisk(const std::string& path) : file_(path) {}
  [[nodiscard]] std::uint64_t size() const override { return file_.likely_bytes(); }
  std::string_view bytes_at(std::uint64_t at, std::uint64_t bytes) override {
    char* const to = room_.room_for(static_cast<std::size_t>(bytes));
    file_.read_at(at, to, static_cast<std::size_t>(bytes));
    return {to, static_cast<std::size_t>(bytes)};
  }

 private:
  InputFileSource file_;
  PageBytes room_;
};

class FileInMemory final : public ParquetFile {
 public:
  explicit FileInMemory(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  std::string_view bytes_at(std::uint64_t at, std::uint64_t bytes) override {
    return bytes_.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(bytes));
  }

 private:
  std::string_view bytes_;
};

FileMetadata read_footer(ParquetFile& file) {
  if (file.size() < magic.size() + tail_bytes) {
    throw UnreadableParquet("damaged: shorter than any Parquet file",
                            fmt::format("{} bytes", file.size()));
  }
  if (file.bytes_at(0, magic.size()) == magic_of_encrypted) {
    throw UnreadableParquet("is encrypted Parquet", "", "decrypt it where its key is");
  }
  const std::string_view tail = file.bytes_at(file.size() - tail_bytes, tail_bytes);
  if (!tail.ends_with(magic)) {
    throw UnreadableParquet("damaged: the file does not end with its footer", "",
                            "it is cut off, or was not closed by what wrote it: copy it again");
  }
  std::uint32_t length = 0;
  std::memcpy(&length, tail.data(), sizeof length);
  if (length > file.size() - tail_bytes - magic.size() || length > largest_footer_bytes) {
    throw UnreadableParquet(
        fmt::format("damaged: a footer of {} bytes does not fit into the file", length));
  }
  return read_metadata(file.bytes_at(file.size() - tail_bytes - length, length), file.size());
}

/// Columns of a table as they are read, with names that differ.
class TableInMaking {
 public:
  TableInMaking(const std::string& file, std::uint64_t rows) {
    table_.file = file;
    table_.rows = static_cast<std::size_t>(rows);
  }

  void leave_out(const std::string& column, const std::string& why) {
    refusals_.push_back({"reading.not_read", {{"name", in_quotes(column)}, {"why", why}}});
  }

  void add(const std::string& wanted, const std::string& leaf, log::LogColumn column) {
    const std::string name = free_name(wanted);
    if (name != wanted) {
      table_.notes.push_back(
          {"reading.column_renamed",
           {{"column", in_quotes(wanted)}, {"array", in_quotes(leaf)}, {"name", in_quotes(name)}}});
    }
    taken_.insert(name);
    column.header = text::read_header_field(name);
    table_.header.push_back(name);
    table_.columns.push_back(std::move(column));
  }

  void note(Statement statement) { table_.notes.push_back(std::move(statement)); }

  /// @throw InputError: there is no row, or no column.
  log::LogTable finish() && {
    const std::size_t listed = std::min(refusals_.size(), most_listed);
    table_.notes.insert(table_.notes.end(), refusals_.begin(),
                        refusals_.begin() + static_cast<std::ptrdiff_t>(listed));
    if (refusals_.size() > listed) {
      table_.notes.push_back({"reading.more_not_read", {{"arrays", refusals_.size() - listed}}});
    }
    if (table_.rows > 0 && !table_.columns.empty()) return std::move(table_);
    Statement held;
    for (const Statement& note : table_.notes) held.add(note);
    throw InputError({table_.file, 0, 0},
                     {"no rows of numbers",
                      held.empty() ? fmt::format("{} rows", table_.rows) : wording::words(held),
                      "columns of numbers", ""});
  }

 private:
  [[nodiscard]] std::string free_name(const std::string& wanted) const {
    std::string name = wanted;
    for (std::size_t number = 2; taken_.contains(name); ++number) {
      name = fmt::format("{}_{}", wanted, number);
    }
    return name;
  }

  log::LogTable table_;
  std::set<std::string> taken_;
  std::vector<Statement> refusals_;
};

/// The name of an element's column. @param elements of each row; 1 of what is no list, too.
using NameOfElement =
    std::function<std::string(const LeafColumn& leaf, std::size_t element, std::size_t elements)>;

class TableReader {
 public:
  TableReader(ParquetFile& file, const std::string& name)
      : file_(file),
        name_(name),
        metadata_(read_footer(file)),
        leaves_(leaf_columns(metadata_.schema)),
        budget_(file.size()) {
    for (const RowGroup& group : metadata_.groups) {
      rows_ += group.rows;
      if (group.chunks.size() != leaves_.size()) {
        throw UnreadableParquet("damaged: a group of rows has other columns than the schema");
      }
    }
  }

  [[nodiscard]] std::vector<std::string> leaf_names() const {
    std::vector<std::string> names;
    for (const LeafColumn& leaf : leaves_) names.push_back(leaf.name);
    return names;
  }

  log::LogTable read(const NameOfElement& name_of_element) {
    TableInMaking table(name_, rows_);
    for (std::size_t k = 0; k < leaves_.size(); ++k) read_leaf(k, name_of_element, table);
    return std::move(table).finish();
  }

 private:
  void read_leaf(std::size_t k, const NameOfElement& name_of_element, TableInMaking& table) {
    const LeafColumn& leaf = leaves_[k];
    if (!leaf.left_out.empty()) return table.leave_out(leaf.name, leaf.left_out);
    ColumnValues values(leaf, budget_);
    values.expect(rows_);
    for (const RowGroup& group : metadata_.groups) {
      const ColumnChunk& chunk = group.chunks[k];
      values.add_chunk(chunk, file_.bytes_at(chunk.begin, chunk.bytes), group.rows);
      if (!values.left_out().empty()) return table.leave_out(leaf.name, values.left_out());
    }
    const std::size_t elements = values.elements();
    if (elements == 0) return table.leave_out(leaf.name, "all of its lists are empty");
    if (columns_ + elements > most_columns) {
      return table.leave_out(leaf.name,
                             fmt::format("there are more than {} columns", most_columns));
    }
    columns_ += elements;
    TableColumns made = table_columns(leaf, values);
    for (std::size_t i = 0; i < elements; ++i) {
      table.add(name_of_element(leaf, i, elements), leaf.name, std::move(made.columns[i]));
    }
    if (made.was_rounded) {
      table.note({"reading.integers_rounded", {{"array", in_quotes(leaf.name)}}});
    }
  }

  ParquetFile& file_;
  const std::string& name_;
  FileMetadata metadata_;
  std::vector<LeafColumn> leaves_;
  ValueBudget budget_;
  std::uint64_t rows_{};
  std::size_t columns_{};
};

std::string plain_name(const LeafColumn& leaf, std::size_t element, std::size_t) {
  return leaf.is_list ? fmt::format("{}_{}", leaf.name, element) : leaf.name;
}

/// @param path in whose folders a data set is looked for; empty: nowhere.
log::LogTable read_table(ParquetFile& file, const std::string& name, const std::string& path) {
  TableReader reader(file, name);
  if (!is_of_lerobot(reader.leaf_names())) return reader.read(plain_name);
  std::optional<LeRobotSet> set;
  if (!path.empty()) set = lerobot_set_around(path);
  log::LogTable table =
      reader.read([&](const LeafColumn& leaf, std::size_t element, std::size_t elements) {
        return leaf.is_list ? lerobot_column(set, leaf.name, element, elements) : leaf.name;
      });
  complete_lerobot_table(set, table);
  return table;
}

std::vector<log::LogTable> read_or_refuse(ParquetFile& file, const std::string& name,
                                          const std::string& path) {
  try {
    std::vector<log::LogTable> tables;
    tables.push_back(read_table(file, name, path));
    return tables;
  } catch (const UnreadableParquet& refusal) {
    throw InputError({name, 0, 0}, {refusal.what(), refusal.found(), "", refusal.hint()});
  }
}

}  // namespace

std::vector<log::LogTable> read_parquet(const std::string& path) {
  FileOnDisk file(path);
  return read_or_refuse(file, path, path);
}

std::vector<log::LogTable> parse_parquet(std::string_view bytes, const std::string& file) {
  FileInMemory in_memory(bytes);
  return read_or_refuse(in_memory, file, "");
}

}  // namespace tribolog::ingest::parquet
