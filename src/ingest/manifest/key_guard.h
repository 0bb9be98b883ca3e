#pragma once
// Constructors that refuse impossible parameters, as errors of the file they came from.

#include <stdexcept>
#include <string>

#include "ingest/manifest/toml_table.h"

namespace tribolog {

/// Runs `build` and returns its result.
/// @throw InputError at the key, with the constructor's words, if it throws std::invalid_argument.
template <class Build>
auto guarded(const TomlTable& table, const std::string& key, const Build& build) {
  try {
    return build();
  } catch (const std::invalid_argument& error) {
    table.refuse(key, {error.what(), "", "", ""});
  }
}

}  // namespace tribolog
