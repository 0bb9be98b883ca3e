#pragma once
// JSON as Python writes it, which knows more numbers than the standard does.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::ingest::text {

/// A text with null in place of numbers that JSON does not know.
struct PlainJson {
  std::string text;
  std::vector<std::size_t> inserted;  ///< Where a byte more stands than in the file; ascending.
};

/// NaN, Infinity and -Infinity outside of strings become null.
PlainJson without_foreign_numbers(std::string_view text);

}  // namespace tribolog::ingest::text
