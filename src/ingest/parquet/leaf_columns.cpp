#include "ingest/parquet/leaf_columns.h"

#include <utility>

#include <fmt/format.h>

#include "ingest/parquet/compact_protocol.h"

namespace tribolog::ingest::parquet {
namespace {

constexpr unsigned deepest_schema = 32;
constexpr std::int32_t most_decimal_bytes = 32;

std::string joined(const std::string& before, const std::string& name) {
  return before.empty() || name.empty() ? before + name : before + "." + name;
}

/// Why values of this type give no column; empty: they do.
std::string why_left_out(const SchemaNode& node) {
  switch (*node.type) {
    case PhysicalType::bytes:
      if (node.logical == LogicalType::text || node.logical == LogicalType::decimal) return "";
      return "it holds bytes that are neither numbers nor texts";
    case PhysicalType::fixed_bytes:
      if (node.logical == LogicalType::real16 && node.type_bytes == sizeof(std::uint16_t))
        return "";
      if (node.logical == LogicalType::decimal && node.type_bytes > 0 &&
          node.type_bytes <= most_decimal_bytes) {
        return "";
      }
      return "it holds bytes that are neither numbers nor texts";
    default:
      return node.logical == LogicalType::other ? "it is of a type that is not read" : "";
  }
}

/// What is around a node.
struct Around {
  std::string name;
  unsigned depth{};
  unsigned definition{};
  unsigned lists{};
  unsigned list_definition{};
  bool is_list{};     ///< The node is what a list repeats: its name says nothing.
  bool is_element{};  ///< The node is a list's element: neither does its own.
  bool is_in_map{};
};

class SchemaWalk {
 public:
  explicit SchemaWalk(const std::vector<SchemaNode>& schema) : schema_(schema) {}

  std::vector<LeafColumn> leaves() {
    const std::size_t columns = next().children;
    for (std::size_t i = 0; i < columns; ++i) walk({});
    if (at_ != schema_.size()) refuse();
    return std::move(leaves_);
  }

 private:
  [[noreturn]] static void refuse() {
    throw UnreadableParquet("damaged: the nodes of the schema are no tree");
  }

  const SchemaNode& next() {
    if (at_ >= schema_.size()) refuse();
    return schema_[at_++];
  }

  /// Depth first, as the nodes are listed.
  void walk(Around around) {
    if (++around.depth > deepest_schema) {
      throw UnreadableParquet("damaged: the schema is nested too deeply");
    }
    const SchemaNode& node = next();
    const Around inside = in_node(node, around);
    if (node.type) return add(node, inside);
    if (node.children == 0) refuse();
    for (std::size_t i = 0; i < node.children; ++i) walk(inside);
  }

  /// What is around the node's children, or around a leaf's values.
  [[nodiscard]] Around in_node(const SchemaNode& node, const Around& around) const {
    Around inside = around;
    inside.is_list = node.logical == LogicalType::list && node.children == 1;
    inside.is_element = false;
    inside.is_in_map = around.is_in_map || node.logical == LogicalType::map;
    if (node.repetition != Repetition::required) ++inside.definition;
    if (node.repetition == Repetition::repeated) {
      ++inside.lists;
      inside.list_definition = inside.definition;
    }
    const bool repeats = around.is_list && node.repetition == Repetition::repeated;
    inside.is_element = repeats && has_element(node);
    if (!repeats && !around.is_element) inside.name = joined(around.name, node.name);
    return inside;
  }

  /// Today a list's repeated node holds its element; of older ones it is the element itself.
  [[nodiscard]] static bool has_element(const SchemaNode& repeated) {
    return !repeated.type && repeated.children == 1 && repeated.name != "array" &&
           !repeated.name.ends_with("_tuple");
  }

  void add(const SchemaNode& node, const Around& around) {
    LeafColumn leaf;
    leaf.name = around.name;
    leaf.type = *node.type;
    leaf.type_bytes = node.type_bytes;
    leaf.logical = node.logical;
    leaf.units_per_s = node.units_per_s;
    leaf.scale = node.scale;
    const bool is_long = leaf.type == PhysicalType::int64 || leaf.type == PhysicalType::int96;
    if (is_long) leaf.storage = Storage::integer;
    leaf.most_definition = around.definition;
    leaf.is_list = around.lists > 0;
    leaf.list_definition = around.list_definition;
    leaf.left_out = why_left_out(node);
    if (around.lists > 1) leaf.left_out = "it is a list of lists";
    if (around.is_in_map) leaf.left_out = "it is a map";
    leaves_.push_back(std::move(leaf));
  }

  const std::vector<SchemaNode>& schema_;
  std::size_t at_{};
  std::vector<LeafColumn> leaves_;
};

}  // namespace

std::vector<LeafColumn> leaf_columns(const std::vector<SchemaNode>& schema) {
  return SchemaWalk(schema).leaves();
}

}  // namespace tribolog::ingest::parquet
