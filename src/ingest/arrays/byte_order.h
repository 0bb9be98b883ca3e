#pragma once
// Numbers in the bytes of a file.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace tribolog::ingest::arrays {

/// The number of `sizeof(Number)` bytes at an offset; the caller has checked that they are there.
template <class Number>
Number number_at(std::string_view bytes, std::size_t offset, bool big_endian = false) {
  static_assert(std::is_arithmetic_v<Number>);
  unsigned char raw[sizeof(Number)];
  std::memcpy(raw, bytes.data() + offset, sizeof(Number));
  if (big_endian != (std::endian::native == std::endian::big)) {
    for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) {
      const unsigned char kept = raw[i];
      raw[i] = raw[sizeof(Number) - 1 - i];
      raw[sizeof(Number) - 1 - i] = kept;
    }
  }
  Number number;
  std::memcpy(&number, raw, sizeof(Number));
  return number;
}

}  // namespace tribolog::ingest::arrays
