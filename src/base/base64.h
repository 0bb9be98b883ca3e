#pragma once
// Base64 after RFC 4648 section 4, with padding.

#include <cstddef>
#include <span>
#include <string>

namespace tribolog {

std::string base64(std::span<const std::byte> bytes);

/// The bytes that a text of hex digits stands for, in base64: a SHA-256 as a CSP wants it.
/// @param hex an even number of lower- or upper-case hex digits.
std::string base64_of_hex(const std::string& hex);

}  // namespace tribolog
