#pragma once
// One column of a Parquet file, from its pages in all groups of rows.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ingest/parquet/file_metadata.h"
#include "ingest/parquet/leaf_columns.h"
#include "ingest/parquet/page_unpacking.h"
#include "ingest/parquet/page_values.h"
#include "ingest/parquet/text_values.h"

namespace tribolog::ingest::parquet {

/// Most elements that a row's list may have.
inline constexpr std::size_t most_elements = 4096;

/// How many values may still be read of a file: runs of equal ones take no bytes to speak of.
class ValueBudget {
 public:
  explicit ValueBudget(std::uint64_t file_bytes);
  /// @throw UnreadableParquet: fewer are left.
  void take(std::uint64_t values);

 private:
  std::uint64_t left_;
};

/// The levels of a page's entries; empty: all are as high as they can be.
struct PageLevels {
  std::vector<std::uint32_t> definition;
  std::vector<std::uint32_t> repetition;
};

/// Takes the pages in their order.
class ColumnValues {
 public:
  /// @param column and @param budget have to live on.
  ColumnValues(const LeafColumn& column, ValueBudget& budget)
      : column_(column), budget_(budget), decoder_(column, texts_) {}
  ColumnValues(const ColumnValues&) = delete;
  ColumnValues& operator=(const ColumnValues&) = delete;

  /// @param pages the chunk's bytes. @param rows of its group.
  /// @throw UnreadableParquet: damaged.
  void add_chunk(const ColumnChunk& chunk, std::string_view pages, std::uint64_t rows);

  /// Rows as they came, of each so many numbers as elements(), one row behind the other.
  [[nodiscard]] const Numbers& numbers() const { return numbers_; }
  /// Of a row: 1, or of a list as many as all rows have.
  [[nodiscard]] std::size_t elements() const { return column_.is_list ? elements_ : 1; }
  [[nodiscard]] const TextValues& texts() const { return texts_; }
  /// Why it gives no columns; empty: it does.
  [[nodiscard]] const std::string& left_out() const;
  /// The real numbers themselves, which are no longer here then.
  [[nodiscard]] std::vector<double> take_reals() { return std::move(numbers_.reals); }
  /// Makes room for so many rows; memory is taken as they come.
  /// @throw UnreadableParquet: more than a file of its size is read for.
  void expect(std::uint64_t rows);

 private:
  // Each returns the bytes of the values.
  std::string_view take_levels(const PageHeader& page, const ColumnChunk& chunk,
                               std::string_view stored);
  std::string_view take_levels_v1(const PageHeader& page, std::string_view bytes);
  std::string_view take_levels_v2(const PageHeader& page, const ColumnChunk& chunk,
                                  std::string_view stored);
  void add_page(const PageHeader& page, const ColumnChunk& chunk, std::string_view stored);
  void add_rows(Encoding encoding, std::string_view values, std::size_t count);
  void add_lists(Encoding encoding, std::string_view values, std::size_t count);
  void add_element(bool is_there, const Numbers& present, std::size_t& next);
  void end_list();
  void append_gaps(std::size_t count);
  void append_empty_lists(std::size_t rows);

  const LeafColumn& column_;
  ValueBudget& budget_;
  TextValues texts_;
  ValueDecoder decoder_;
  PageBytes room_;
  PageLevels levels_;
  Numbers numbers_;
  std::uint64_t rows_{};  ///< Of the group that is being read.
  // Of lists:
  std::size_t elements_{};      ///< Of the first that is not empty.
  std::size_t in_list_{};       ///< Elements of the row that is being read.
  std::size_t empty_before_{};  ///< Rows without elements before any that has some.
  bool is_in_list_{};
  std::string left_out_;
};

}  // namespace tribolog::ingest::parquet
