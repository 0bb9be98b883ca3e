#pragma once
// What a key of a file may be, and what is said where it is not.

#include <stdexcept>
#include <string>
#include <string_view>

#include "ingest/manifest/toml_table.h"

namespace tribolog::ingest::manifest {

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
