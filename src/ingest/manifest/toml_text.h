#pragma once
// Values as TOML writes them.

#include <string>
#include <string_view>

namespace tribolog::ingest::manifest {

/// The shortest that reads back to the same double. @param value finite.
std::string toml_number(double value);

/// A basic string, in quotes; what is not seen is escaped.
/// @throw std::invalid_argument: not UTF-8, of which TOML has no form.
std::string toml_text(std::string_view text);

}  // namespace tribolog::ingest::manifest
