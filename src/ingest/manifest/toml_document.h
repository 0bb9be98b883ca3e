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

// Values as TOML writes them.

/// The shortest that reads back to the same double. @param value finite.
std::string toml_number(double value);

/// A basic string, in quotes; what is not seen is escaped.
/// @throw std::invalid_argument: not UTF-8, of which TOML has no form.
std::string toml_text(std::string_view text);

// What must not reach the TOML parser.
//
// Some released versions of toml++ answer certain malformed texts with undefined behaviour (its
// issues 190 and 295: characters beyond ASCII where no text is) or with a recursion as deep as a
// key has dots. Those texts are no valid or no sensible TOML; they are refused before the parser.

/// @throw InputError for broken UTF-8, a character beyond ASCII outside of quotes and comments, a
///        backslash before such a character, a quote or a bracket in the middle of a key or value,
///        or a key with over 50 dots.
void precheck_toml(std::string_view text, const std::string& file);

}  // namespace tribolog::ingest::manifest
