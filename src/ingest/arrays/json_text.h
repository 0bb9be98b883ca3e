#pragma once
// The text of a JSON log as a tree of values.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::ingest::arrays {

/// Deepest nesting that is read.
inline constexpr std::size_t deepest_json = 32;

enum class JsonKind { number, null, text, array, object };

struct JsonContent;

/// Small, since a log has millions of them.
struct JsonValue {
  JsonValue() = default;
  explicit JsonValue(double a_number, bool rounded = false)
      : kind(JsonKind::number), was_rounded(rounded), number(a_number) {}

  JsonKind kind{JsonKind::null};
  bool was_rounded{};                      ///< An integer that no double holds exactly.
  double number{};                         ///< Booleans are 0 and 1.
  std::unique_ptr<JsonContent> content{};  ///< Of texts, arrays and objects; never null there.
};

struct JsonContent {
  std::string text;
  std::vector<JsonValue> elements;  ///< Of an array, or an object's values.
  std::vector<std::string> keys;    ///< Of an object, in the order of the file.
};

/// NaN, Infinity and -Infinity, which Python writes and JSON does not know, are read as null.
/// @throw InputError at line and column: no JSON, nested too deeply, or the same key twice in one
///        object.
JsonValue parse_json_text(std::string_view text, const std::string& file);

}  // namespace tribolog::ingest::arrays
