#pragma once
// Rows of text under each other in aligned columns, for a terminal.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tribolog::inspect::survey {

/// Places that a UTF-8 text takes, one for each character.
std::size_t places(const std::string& text);

/// Places that a name takes in a cell at most.
inline constexpr std::size_t longest_name = 40;

/// "1 gap", "3 gaps"
std::string plural(std::size_t n, const std::string& word);

class TextTable {
 public:
  /// @param indent blanks before each row.
  explicit TextTable(std::size_t indent) : indent_(indent) {}

  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  /// Columns two blanks apart, flush left. The last one is broken at blanks so that no row is
  /// longer than `width` places, if it can be.
  [[nodiscard]] std::string text(std::size_t width = 100) const;

 private:
  std::size_t indent_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace tribolog::inspect::survey
