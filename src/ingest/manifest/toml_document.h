#pragma once
// A TOML document as values with their places, whichever library has parsed it: toml++, or toml11
// where the distribution has no toml++ (Ubuntu 22.04).

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tribolog::ingest::manifest {

struct TomlNode;

/// A date, with a time or without.
struct TomlDate {
  std::string iso8601;  ///< Whole seconds; empty for a time of no date.
};

/// "Z", or as "+02:00". @param minutes east of Greenwich.
std::string iso_offset(int minutes);

using TomlArray = std::vector<TomlNode>;
using TomlMembers = std::map<std::string, TomlNode, std::less<>>;

struct TomlNode {
  long line{};  ///< Of its first character, counted from 1.
  long column{};
  std::variant<bool, std::int64_t, double, std::string, TomlDate, TomlArray, TomlMembers> value;

  /// @return nullptr where it is of another type.
  template <class Type>
  [[nodiscard]] const Type* as() const {
    return std::get_if<Type>(&value);
  }
  /// Of a table. @return nullptr where it has no such key.
  [[nodiscard]] const TomlNode* member(std::string_view key) const;
};

/// The top-level table of a document that precheck_toml() has let through.
/// @param file its name, for the error. @throw InputError for a syntax error or a key given twice.
TomlNode parse_toml(std::string_view text, const std::string& file);

}  // namespace tribolog::ingest::manifest
