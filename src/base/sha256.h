#pragma once
// The fingerprint of a file, for the provenance.

#include <memory>
#include <string>
#include <string_view>

namespace tribolog {

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
