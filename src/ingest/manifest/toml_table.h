#pragma once
// Typed access to a TOML table, with an error at file:line:column for whatever does not fit.
//
// A table remembers which of its keys were asked for. refuse_unknown_keys() refuses the first one
// that nobody asked for; readers call it after the last key, so that a misspelt optional key is
// never passed over in silence.

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace tribolog::ingest::manifest {

struct TomlNode;

/// Which numbers a key takes. In every case finite, and in the range of its unit (range_of_key()).
enum class Sign { any, not_negative, positive };

class TomlTable {
 public:
  /// The top-level table of a document.
  /// @throw InputError for a syntax error, a key given twice, broken UTF-8, or absurdly deep
  /// nesting.
  static TomlTable parse(std::string_view text, const std::string& file);

  /// The same of a document that was parsed already. @param file its name, for messages.
  static TomlTable of(TomlNode document, const std::string& file);

  // Required keys. @throw InputError if missing (with the hint) or of another type or range.
  [[nodiscard]] std::string text(const std::string& key, const std::string& hint = {}) const;
  /// `gear_ratio` also as a text, "101:1".
  [[nodiscard]] double number(const std::string& key, Sign sign = Sign::any,
                              const std::string& hint = {}) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& key, Sign sign = Sign::any) const;
  /// An array of texts.
  [[nodiscard]] std::vector<std::string> texts(const std::string& key,
                                               const std::string& hint = {}) const;
  [[nodiscard]] TomlTable table(const std::string& key, const std::string& hint = {}) const;
  /// Index of the text among the options.
  [[nodiscard]] std::size_t choice(const std::string& key, const std::vector<std::string>& options,
                                   const std::string& hint = {}) const;

  // Optional keys. @throw InputError if of another type or range.
  [[nodiscard]] std::string text_or(const std::string& key, const std::string& otherwise) const;
  /// A text as it is; a date, with a time or without, as ISO 8601: quotes are easily forgotten.
  [[nodiscard]] std::string text_or_date(const std::string& key,
                                         const std::string& otherwise) const;
  [[nodiscard]] double number_or(const std::string& key, double otherwise,
                                 Sign sign = Sign::any) const;
  [[nodiscard]] std::optional<double> find_number(const std::string& key,
                                                  Sign sign = Sign::any) const;
  [[nodiscard]] bool flag_or(const std::string& key, bool otherwise) const;
  [[nodiscard]] std::uint64_t count_or(const std::string& key, std::uint64_t otherwise) const;
  [[nodiscard]] std::optional<TomlTable> find_table(const std::string& key) const;
  [[nodiscard]] std::vector<TomlTable> tables(const std::string& key) const;  ///< `[[key]]`
  /// `[key]` or any number of `[[key]]`; empty if neither.
  [[nodiscard]] std::vector<TomlTable> one_or_more_tables(const std::string& key) const;

  [[nodiscard]] bool has(const std::string& key) const;
  /// Whether the key is there, and its value this text.
  [[nodiscard]] bool says(const std::string& key, std::string_view text) const;
  /// has() of a key that is not known here, to refuse it with its own reason.
  [[nodiscard]] bool has_misplaced(const std::string& key) const;
  [[nodiscard]] Location where() const;
  /// Of the key's value; the table's where there is no such key.
  [[nodiscard]] Location where(const std::string& key) const;
  /// @throw InputError naming the key in full at its place: "key 'joint.gear_ratio': <what>".
  [[noreturn]] void refuse(const std::string& key, InputError::Problem problem) const;
  /// @throw InputError at the first key that was not asked for, with the closest that was.
  void refuse_unknown_keys() const;

 private:
  struct View;
  explicit TomlTable(std::shared_ptr<View> view) : view_(std::move(view)) {}
  std::shared_ptr<View> view_;
};

/// For what shows only when a file's numbers are used together: of the key; of the table, where it
/// has no such key; of the file, where it has no such table.
/// @param text a whole document. @param file its name.
Location place_in_toml(std::string_view text, const std::string& file, const std::string& table,
                       const std::string& key);

// What a key of a file may be, and what is said where it is not.

/// @throw InputError at the key, with the error's words.
[[noreturn]] void refuse_with_words(const TomlTable& table, const std::string& key,
                                    const std::invalid_argument& error);

/// Runs `build` and returns its result.
/// @throw InputError at the key, with the constructor's words, if it throws std::invalid_argument.
template <class Build>
auto guarded(const TomlTable& table, const std::string& key, const Build& build) {
  try {
    return build();
  } catch (const std::invalid_argument& error) {
    refuse_with_words(table, key, error);
  }
}

// Which numbers a key may have, by the unit at its name's end: the range of all joints that there
// are, with room, and far inside the range in which numbers can be multiplied without loss. What
// lies outside is a slip of the unit or of the decimal point.

/// Magnitudes; 0 is allowed beside them where the key takes it at all.
struct KeyRange {
  double smallest{};
  double largest{};
  std::string unit;  ///< "N·m"; empty: a pure number.

  [[nodiscard]] bool holds(double value) const;
  /// "1e-09 to 1e+07 N·m"
  [[nodiscard]] std::string in_words() const;
};

/// Of "torque_limit_Nm" that of torques; of a name without a unit that of pure numbers.
KeyRange range_of_key(std::string_view key);

}  // namespace tribolog::ingest::manifest
