#pragma once
// The header row of a log.

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "ingest/text/csv_dialect.h"
#include "ingest/text/number_field.h"

namespace tribolog::ingest::text {

/// Whether a first row holds numbers and gaps only, a number at least: no header.
bool holds_numbers_only(const std::vector<Field>& row, DecimalMark mark);

/// "#1", "#2" and so on, for a log without header.
std::vector<Field> names_by_position(std::size_t columns);

/// "Nm" of "[Nm]" and "(Nm)".
std::string_view without_brackets(std::string_view unit);

/// Whether a row under the header states units: most of its fields are known ones, none a number.
bool holds_units(const std::vector<Field>& row, DecimalMark mark);

/// @throw InputError at the first byte that is not UTF-8.
void refuse_other_encodings(const std::vector<Field>& header, const Location& line);

/// Those that stand more than once.
std::vector<std::string> repeated_names(const std::vector<Field>& header);

/// The columns of a header by their names.
class ColumnNames {
 public:
  /// @param header outlives the names.
  explicit ColumnNames(const std::vector<Field>& header);

  /// Whether a column has this name, with or without its unit.
  [[nodiscard]] bool has(const std::string& name) const;
  /// Whether it has, or this is the position of one, "#2".
  [[nodiscard]] bool has_or_counts(const std::string& name) const;
  /// Index of the column with this name; the full text counts first, then the name without its
  /// unit, then, of "#2", the position.
  /// @throw InputError if there is none (listing those that are, and the closest) or several, also
  ///        of the same name.
  [[nodiscard]] std::size_t find(const std::string& name, const std::string& hint_if_missing,
                                 const Location& line) const;

 private:
  struct Places {
    std::size_t first{};
    std::size_t count{};
  };
  using Index = std::unordered_map<std::string, Places>;
  static void add(const std::string& name, std::size_t place, Index& index);

  const std::vector<Field>& header_;
  Index by_text_;       ///< With the unit.
  Index by_bare_name_;  ///< Without.
};

/// Under blanks as delimiter "tau [Nm]" falls into two fields; joins them again.
std::vector<Field> join_units(std::vector<Field> header);

}  // namespace tribolog::ingest::text
