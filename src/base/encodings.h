#pragma once
// Bytes as text: Base64, and the fingerprint of a file.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace tribolog {

std::string base64(std::span<const std::byte> bytes);

/// The bytes that a text of hex digits stands for, in base64: a SHA-256 as a CSP wants it.
/// @param hex an even number of lower- or upper-case hex digits.
std::string base64_of_hex(const std::string& hex);

// The fingerprint of a file, for the provenance.

/// SHA-256 (FIPS 180-4) of bytes that come piece by piece.
class Sha256 {
 public:
  /// @throw std::runtime_error if the cryptographic library cannot compute it.
  Sha256();
  void add(std::string_view bytes);
  /// 64 lower-case hexadecimal digits; once, at the end.
  [[nodiscard]] std::string hex();

 private:
  struct Free {
    void operator()(void* context) const;
  };
  std::unique_ptr<void, Free> context_;
};

/// The same of bytes in one piece. @throw std::runtime_error as above.
std::string sha256_hex(std::string_view bytes);

}  // namespace tribolog
