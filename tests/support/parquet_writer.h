#pragma once
// Parquet files for tests, by the format's specification and not by the reader's code: one page a
// column and group of rows, each part of which a test can spoil.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tribolog::test {

/// Thrift's compact protocol, written: fields in ascending order of their numbers.
class CompactWriter {
 public:
  CompactWriter& integer(int id, std::int64_t value, int type = 5);
  CompactWriter& text(int id, const std::string& value);
  CompactWriter& boolean(int id, bool value);
  CompactWriter& structure(int id, const CompactWriter& inner);
  CompactWriter& structures(int id, const std::vector<CompactWriter>& list);
  /// The fields and the mark of their end.
  [[nodiscard]] std::string bytes() const { return bytes_ + '\0'; }

 private:
  void head(int id, int type);

  int last_id_{};
  std::string bytes_;
};

std::string varint(std::uint64_t value);
/// Numbers as they stand in memory, one behind the other.
template <class Number>
std::string raw(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}
/// Runs of equal levels, each as long as stated, below 256; the length of all in front.
std::string level_runs(const std::vector<std::pair<unsigned, unsigned>>& count_and_level);

/// A node of the schema.
struct WrittenNode {
  std::string name;
  std::optional<int> type{};         ///< As the format numbers it; none of a group.
  std::optional<int> repetition{0};  ///< 0: required, 1: optional, 2: repeated.
  int children{};
  std::optional<int> converted{};
  std::optional<CompactWriter> logical{};
  int type_bytes{};
  int scale{};
};

/// A leaf's one page, and what is said of it.
struct WrittenColumn {
  int type{5};
  std::string page;  ///< With its levels.
  std::size_t values{};
  int encoding{0};
  int codec{0};
  std::string dictionary{};  ///< Not empty: a page of its own, in PLAIN.
  std::size_t dictionary_values{};
  int level_encoding{3};
  std::optional<std::uint32_t> crc{};
  std::optional<std::int64_t> stated_values{};    ///< Where it lies,
  std::optional<std::int64_t> stated_unpacked{};  ///< and here.
};

struct WrittenParquet {
  std::vector<WrittenNode> schema;  ///< Without the root.
  std::vector<WrittenColumn> columns;
  std::int64_t rows{};
  std::size_t root_children{};  ///< 0: as many as there are nodes.
  std::string magic{"PAR1"};
};

std::string write_parquet(const WrittenParquet& file);

/// A required column of doubles.
void add_doubles(const std::string& name, const std::vector<double>& values, WrittenParquet& file);
/// A required column of 64-bit integers.
void add_integers(const std::string& name, const std::vector<std::int64_t>& values,
                  WrittenParquet& file);
/// Optional lists of floats with required elements, as LeRobot's features are written.
void add_lists(const std::string& name, const std::vector<std::vector<float>>& rows,
               WrittenParquet& file);

}  // namespace tribolog::test
