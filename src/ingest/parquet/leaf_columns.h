#pragma once
// The columns that a Parquet schema has at its leaves, and what becomes of each.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ingest/parquet/file_metadata.h"

namespace tribolog::ingest::parquet {

/// Of a column's numbers those that a double may not hold are kept as integers until all are known.
enum class Storage : std::uint8_t { real, integer };

struct LeafColumn {
  /// "q", "state.q" of a structure; a list goes by its own name, without those of its parts.
  std::string name;
  PhysicalType type{};
  std::int32_t type_bytes{};
  LogicalType logical{LogicalType::none};
  double units_per_s{1};
  std::int32_t scale{};
  Storage storage{Storage::real};
  /// The definition level of a value that is there; below it, something around it is null.
  unsigned most_definition{};
  bool is_list{};              ///< A row holds so many values as it says.
  unsigned list_definition{};  ///< From this level on a list has an element.
  std::string left_out;        ///< Not empty: it is not read, for this reason.
};

/// In the order in which groups of rows have them.
/// @throw UnreadableParquet: the nodes are no tree, or one too deep.
std::vector<LeafColumn> leaf_columns(const std::vector<SchemaNode>& schema);

}  // namespace tribolog::ingest::parquet
