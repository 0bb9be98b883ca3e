#pragma once
// The fingerprint of a file, for the provenance.

#include <string>
#include <string_view>

namespace tribolog {

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits.
/// @throw std::runtime_error if the cryptographic library cannot compute it.
std::string sha256_hex(std::string_view bytes);

}  // namespace tribolog
