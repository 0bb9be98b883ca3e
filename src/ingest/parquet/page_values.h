#pragma once
// The values of a page, in whichever encoding they are written.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "ingest/parquet/file_metadata.h"
#include "ingest/parquet/leaf_columns.h"
#include "ingest/parquet/text_values.h"

namespace tribolog::ingest::parquet {

/// Stands where a row has no integer; as a value it is one too, as pandas' NaT is.
inline constexpr std::int64_t integer_gap = std::numeric_limits<std::int64_t>::min();

/// Numbers of a column, in its unit, in one of the two as LeafColumn::storage says.
struct Numbers {
  std::vector<double> reals;           ///< NaN where there is a gap.
  std::vector<std::int64_t> integers;  ///< integer_gap where there is one.
};

/// Decodes one column's pages, one after the other.
class ValueDecoder {
 public:
  /// @param column and @param texts, which receives those of a column of texts, have to live on.
  ValueDecoder(const LeafColumn& column, TextValues& texts) : column_(column), texts_(texts) {}

  /// The values that those of the next pages point to.
  /// @throw UnreadableParquet: damaged, or in another encoding than dictionaries have.
  void set_dictionary(const PageHeader& page, std::string_view bytes);
  /// Another group of rows starts: it has a dictionary of its own, or none.
  void forget_dictionary() { has_dictionary_ = false; }

  /// Appends `count` values, none of them null.
  /// @throw UnreadableParquet: damaged, or in an encoding that the type does not have.
  void decode(Encoding encoding, std::string_view bytes, std::size_t count, Numbers& to);

 private:
  void plain(std::string_view bytes, std::size_t count, Numbers& to);
  void plain_bytes(std::string_view bytes, std::size_t count, Numbers& to);
  void plain_fixed_bytes(std::string_view bytes, std::size_t count, Numbers& to);
  void places(std::string_view bytes, std::size_t count, Numbers& to);
  void deltas(std::string_view bytes, std::size_t count, Numbers& to);
  void delta_lengths(std::string_view bytes, std::size_t count, Numbers& to);
  void delta_bytes(std::string_view bytes, std::size_t count, Numbers& to);
  void byte_streams(std::string_view bytes, std::size_t count, Numbers& to);
  [[nodiscard]] double number_in(std::string_view bytes);
  [[nodiscard]] std::size_t fixed_width() const;

  const LeafColumn& column_;
  TextValues& texts_;
  bool has_dictionary_{};
  Numbers dictionary_;
  std::vector<std::uint32_t> places_;
};

/// IEEE 754's binary16.
double from_real16(std::uint16_t bits);

}  // namespace tribolog::ingest::parquet
